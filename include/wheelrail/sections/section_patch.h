#pragma once

#include <wheelrail/halfspace/kernels.h>
#include <wheelrail/halfspace/problem.h>
#include <wheelrail/sections/touching_places.h>

#include <memory>
#include <vector>

namespace wheelrail
{
  /// How a wheel on rails by slices is solved.
  struct SectionRolling
  {
    HalfspaceProblem problem;                  ///< materials, friction and speed; rail as body 1
    double           dx = 0.4e-3, dy = 0.4e-3; ///< elements along and across [m]
    bool             section_normal = false;   ///< planes turned about the track alone, as CONTACT has them
    double           turning        = 0;       ///< rate of the wheel [rad/s]; forward is positive
  };

  /// The contact of half-spaces around one place where wheel and rail overlap, in a plane of its own.
  ///
  /// The reference point is the mean place of the overlap with the square of the gap as weight; the plane has
  /// the mean normal there. With `section_normal` it is turned about the track alone by the mean inclination
  /// that the section under the axle has, as in the program CONTACT. The undeformed distance is that of the
  /// two surfaces along the normal of the plane.
  class SectionPatch
  {
  public:
    /// Lays plane and grid for a wheel lifted by `height` [m]; the rail, its wheel and the problem must
    /// outlive it. `at`: place of the wheelset along the track [m].
    SectionPatch(const SectionsSurface &rail,
                 const PosedWheel      &wheel,
                 const SectionRolling  &rolling,
                 const TouchingPlace   &place,
                 double                 at,
                 double                 height);

    /// The normal problem with the wheel at a height [m].
    void
    press(double height);

    /// Rolls, pressed as before, with the creepages that the wheel has at the reference point.
    void
    roll();

    /// Force on the rail [N], in the track frame.
    Vector3
    force() const;

    /// Normal force [N]; 0 where nothing touches.
    double
    normal_force() const
    {
      return solution.contact_elements > 0 ? solution.fn : 0;
    }

    std::size_t       rail = 0;                    ///< number of its surface
    Vector3           reference{};                 ///< point, Z from the middle of the wheelset [m]
    Vector3           along{}, across{}, normal{}; ///< unit vectors of the plane; the normal out of the rail
    double            angle = 0; ///< contact angle, positive when the tangent falls to the gauge side [rad]
    double            approach = 0; ///< [m]
    double            radius   = 0; ///< of the wheel at the reference point, vertical [m]
    double            wheel_x  = 0; ///< there, in the wheel section [m]
    HalfspaceProblem  problem;
    HalfspaceSolution solution;

  private:
    void
    set_reference(const TouchingPlace &place, double height);
    void
    set_rail_distance();

    const SectionsSurface            *surface_;
    const PosedWheel                 *wheel_;
    const SectionRolling             *rolling_;
    double                            at_ = 0, height_ = 0, line_ = 0;
    std::vector<double>               rail_distance_; ///< along the normal from the plane [m]; NaN: nothing
    std::shared_ptr<HalfspaceKernels> kernels_;
  };
} // namespace wheelrail
