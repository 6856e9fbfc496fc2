#pragma once

#include <wheelrail/geometry/surface_kinks.h>
#include <wheelrail/geometry/touching_profiles.h>
#include <wheelrail/halfspace/problem.h>
#include <wheelrail/planes/rigid_slip.h>

#include <limits>
#include <vector>

namespace wheelrail
{
  /// Where rail head and wheel rim stand against the rigid placement of 2D-Geo (signs of
  /// doc/manual/signs.md).
  struct SectionOffsets
  {
    double lateral    = 0; ///< wheel moved against the rail to the track centre [m]
    double rail_roll  = 0; ///< about the contact point, from X to Y [rad]
    double wheel_roll = 0; ///< [rad]
  };

  /// The plane of a contact and the part of the profiles that belongs to it.
  struct ContactRegion
  {
    ContactFrame frame;     ///< at its point
    double       along = 0; ///< of that point, ahead of the middle of the wheelset [m]
    double       ahead = 0; ///< and ahead of the axle, across it [m]
    double       s_min = -std::numeric_limits<double>::infinity(); ///< [m]
    double       s_max = std::numeric_limits<double>::infinity();
  };

  /// All that is around the first contact point.
  ContactRegion
  whole_region(const ContactGeometry &geometry);

  /// Wheel and rail before they deform, in the frame of a contact: x along the rail from its point, s across.
  /// Each slice of the wheel at fixed s is lowest where its normal lies across the track.
  class ContactSections
  {
  public:
    /// The profiles must outlive it. The offsets turn about the first contact point, whatever the region.
    ContactSections(const TouchingProfiles &profiles,
                    const SectionOffsets   &offsets,
                    const ContactRegion    &region);

    /// The lowest place of the wheel at s.
    struct Slice : WheelPlace
    {
      double radius     = 0; ///< distance from the axle there [m]
      double rail_angle = 0; ///< of the rail's surface against X [rad]
    };
    Slice
    slice(double s) const;

    /// Distance of the surfaces at the lowest place of the slice at s, counted from the least one [m].
    double
    distance(double s) const;

    /// The same over the place s, x of the rail.
    double
    distance(double s, double x) const;

    /// That least distance where 2D-Geo and the offsets put wheel and rail; negative where they overlap [m].
    double
    least_distance() const
    {
      return lowest_;
    }

    double
    s_min() const;
    double
    s_max() const;

    const ContactGeometry &
    geometry() const
    {
      return profiles_.contact;
    }
    const ContactRegion &
    region() const
    {
      return region_;
    }
    const FrameProfile &
    rail() const
    {
      return surfaces_.rail.profile();
    }

    /// Slope along the track of the rail's surface over the place s, x; 0 where it is smooth.
    double
    rail_slope_along(double s, double x) const
    {
      return surfaces_.rail.at(s, x).slope_along;
    }

    /// The rail's surface at s, in the track plane [m].
    Point2
    rail_place(double s) const;

    /// Of the surfaces under the pressure of a solution, whose rows lie at `places` [m].
    SurfaceKinks
    kinks_under(const HalfspaceSolution &solution, const std::vector<double> &places) const;

    /// A grid of square elements [m] that covers the interpenetration at the approach [m], of irregular
    /// surfaces all places of it.
    HalfspaceGrid
    grid(double approach, double element) const;

    /// Sets the undeformed distance on the problem's grid, of the exact surfaces.
    void
    set_distance(HalfspaceProblem &problem) const;

  private:
    /// Distance of the surfaces at a place [m].
    struct Sample
    {
      double x, s, distance;
    };

    void
    sample_irregular();
    HalfspaceGrid
    irregular_grid(double approach, double element) const;

    const FrameProfile &
    outline() const
    {
      return surfaces_.outline.profile();
    }

    const TouchingProfiles &profiles_;
    ContactRegion           region_;
    AxleLine                axle_;     ///< of the wheel that turns
    RunningSurfaces         surfaces_; ///< with their offsets, in the frame of the region; Z from its point
    double                  lowest_ = 0, lowest_s_ = 0; ///< smallest distance of the surfaces, and its place
    std::vector<double>     samples_;   ///< distances of the smooth profiles from s_min() on [m]
    std::vector<Sample>     irregular_; ///< of irregular surfaces; empty: they are smooth
  };

  /// Means over the pressure of a solution.
  struct PressureMeans
  {
    double s = 0, rail_angle = 0, wheel_angle = 0; ///< [m], against X, against the axle [rad]
  };
  PressureMeans
  pressure_means(const ContactSections &sections, const HalfspaceSolution &solution);

  /// Sets the fields of rigid slip, spin and lateral creepage of a problem whose bodies roll with `creepage`
  /// (or, where it is to be found, nearly so), row_slip() in each row. The small product of creepage and
  /// r / R - 1 is left out.
  void
  set_slip(const ContactSections &sections,
           const PressureMeans   &means,
           const WheelMotion     &motion,
           double                 creepage,
           HalfspaceProblem      &problem);
} // namespace wheelrail
