#pragma once

#include <wheelrail/halfspace/problem.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/planes/contact_sections.h>

#include <vector>

namespace wheelrail
{
  /// Place, creepages and spin of a contact at its reference point, and what the contact does to the
  /// wheelset.
  ///
  /// The reference point is the mean place of the overlap that the undeformed surfaces have at the approach
  /// of the half-spaces, with the square of the overlap as weight. It agrees with that of the program CONTACT
  /// to 0.03 mm across and 0.02 mm along the rail, and 0.3 mrad in the angle (tests/halfspace_yaw.cc).
  struct ContactReference
  {
    Point2 place;      ///< on the rail, in the track plane [m]
    double along  = 0; ///< ahead of the middle of the wheelset [m]
    double ahead  = 0; ///< ahead of the axle, across it [m]
    double angle  = 0; ///< contact angle, positive when the tangent falls to the gauge side [rad]
    double radius = 0; ///< of the wheel there, distance from the axle [m]
    double speed =
      1; ///< mean of rolling speed of the wheel and velocity, over velocity: what creepages count in
    double creepage         = 0; ///< along the rail, positive driving
    double lateral_creepage = 0; ///< velocity of the wheel against the rail along s; about -yaw
    double spin             = 0; ///< of the rail against the wheel about the normal out of the rail [1/m]
    double spin_moment      = 0; ///< of the tractions on the rail about that normal through the point [N m]
    double traction         = 0; ///< force on the wheel along s [N]
    double driving          = 0; ///< force on the wheel along the wheelset's own forward direction [N]
    double across           = 0; ///< and along the horizontal part of its axle, to the track centre [N]
    double torque     = 0; ///< on the wheelset, about its axle, that keeps it rolling; positive drives [N m]
    double yaw_moment = 0; ///< of the contact on the wheelset about the vertical through its middle [N m]
  };

  /// What the tractions of a contact do to the wheelset, in the track frame.
  struct WheelsetForces
  {
    Vector3 force  = {{0, 0, 0}}; ///< [N]
    Vector3 moment = {{0, 0, 0}}; ///< about the middle of the wheelset [N m]
  };
  WheelsetForces
  wheelset_forces(const ContactSections   &sections,
                  const PressureMeans     &means,
                  const HalfspaceSolution &solution);

  /// A row of elements: where it lies on the rail, in the track plane [m], and the angle of the contact there
  /// against X [rad].
  struct RowOfElements
  {
    Point2 place;
    double angle = 0;
  };

  /// The same of elements whose planes differ from row to row.
  WheelsetForces
  wheelset_forces(const ContactSections            &sections,
                  const std::vector<RowOfElements> &rows,
                  const HalfspaceSolution          &solution);

  /// A reference point as it was found, in the coordinates of the solution.
  struct ReferencePoint
  {
    double                 x = 0, y = 0; ///< [m]
    Point2                 place;        ///< on the rail, in the track plane [m]
    double                 angle = 0;    ///< of the rail's surface against X [rad]
    ContactSections::Slice slice;        ///< of the wheel there
  };

  /// What follows from a reference point and the forces.
  ContactReference
  reference_at(const ContactSections   &sections,
               const ReferencePoint    &point,
               const WheelsetForces    &forces,
               const WheelMotion       &motion,
               const HalfspaceSolution &solution);

  /// Computes them. The tractions act in one plane at the mean angle of the rail, as they were solved.
  ContactReference
  contact_reference(const ContactSections   &sections,
                    const PressureMeans     &means,
                    const WheelMotion       &motion,
                    const HalfspaceSolution &solution);

  /// Adds the place of a reference point ahead of the axle, its angle, and creepages and spin there; NaN in
  /// their place where they are not `determined`.
  void
  set_reference_figures(const ContactReference &at, bool determined, Summary &summary);
} // namespace wheelrail
