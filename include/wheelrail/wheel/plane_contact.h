#pragma once

#include <wheelrail/halfspace/kernels.h>
#include <wheelrail/halfspace/problem.h>
#include <wheelrail/planes/contact_sections.h>
#include <wheelrail/sampling/patch_measures.h>
#include <wheelrail/wheel/halfspace_case.h>

#include <functional>
#include <memory>
#include <vector>

namespace wheelrail
{
  /// The contact of one region of wheel and rail in one plane, at the mean angle of the rail: first pressed,
  /// then rolling.
  class PlaneContact
  {
  public:
    /// Nothing is solved yet. The geometry must outlive it.
    PlaneContact(const Scene          &scene,
                 const SceneGeometry  &geometry,
                 const SectionOffsets &offsets,
                 const ContactRegion  &region);

    ContactSections   sections;
    WheelMotion       motion;
    HalfspaceProblem  problem;
    PressureMeans     means;    ///< of the normal problem
    HalfspaceSolution solution; ///< empty where nothing presses
    int               enlargements = 0;

    /// Displacement along n that other contacts add to the distance of the surfaces, at x, s [m]; none: null.
    std::function<double(double, double)> added_distance;

    /// Solves the normal problem alone under a force normal to the plane [N] and sets `means`, on a grid that
    /// is enlarged until the contact keeps off its edge. The first grid is made for the expected approach
    /// times `room`.
    void
    press(double normal_force, double room = 1);

    /// The same with a given approach [m], counted from where the least distance of the region closes.
    void
    press_by(double approach);

    /// Rolls with a creepage, pressed as before.
    void
    roll(double creepage);

    /// Rolls under the load of the scene. The lateral traction carries a part of a vertical load: on the
    /// tread it hardly depends on the normal force, on the flange it grows with it, so that secants have to
    /// find the balance. What drives acts along the wheelset, so that with yaw the lateral force takes a part
    /// of it. On a steep flange the normal force is far more than the load: where it leaves what was pressed
    /// before, or the contact the grid, the normal problem is solved anew under the force that was found, a
    /// few times at most.
    void
    carry(const WheelRailLoad &load);

    /// Forces on the wheel along X and upwards [N]. The contact plane is inclined by the mean angle of the
    /// rail.
    double
    lateral() const;
    double
    vertical() const;

    /// Of the surfaces between the edges of the patch [rad].
    double
    turn_across(const PatchMeasures &measures) const;

    /// All results of it but its time.
    WheelRailSolution
    result() const;

  private:
    /// The grid that was made for nearly the same approach is kept, and the solution on it is the first
    /// guess, while the contact keeps off its edge.
    void
    press_on_grid(double first_approach);

    /// What the sections have on the grid, and what other contacts add to it.
    void
    set_distance();

    /// carry() on the grid and in the plane that there are.
    void
    carry_on_grid(const WheelRailLoad &load);

    void
    load_not_found();

    std::shared_ptr<HalfspaceKernels> kernels_;      ///< of the grid that there is
    std::vector<double>               own_distance_; ///< of the sections on it [m]
    double                            laid_for_ = 0; ///< approach that it was made for [m]

    double expected_force_ = 0, expected_approach_ = 0; ///< of the scene [N], [m]
    double element_ = 0;                                ///< wanted size of the elements [m]
  };
} // namespace wheelrail
