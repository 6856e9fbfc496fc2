#pragma once

#include <wheelrail/wheel/halfspace_case.h>

#include <functional>
#include <string>
#include <vector>

namespace wheelrail
{
  class TaskCount;

  /// What a creep curve runs over: creepage along the rail, lateral creepage, spin.
  enum class CreepAxis
  {
    longitudinal,
    lateral,
    spin
  };

  struct CreepCurve
  {
    CreepAxis           axis = CreepAxis::longitudinal;
    std::vector<double> values; ///< creepages [1], or spins [1/m]
  };

  /// Reads "longitudinal -2:2:0.1 %": what the curve runs over, first:last:step or values with commas, and %
  /// (or nothing) for creepages, 1/m for a spin. Throws InputError.
  CreepCurve
  parse_creep_curve(const std::string &text);

  /// "longitudinal", "lateral", "spin".
  std::string
  creep_axis_name(CreepAxis axis);

  /// Solves a scene for each value of the curve, on all processors. Creepages count at the reference point of
  /// the contact (ContactReference) where wheel and rail have one; what the curve does not run over is that
  /// of the scene, but for the creepage along the rail, which is given where the curve runs over it. `solve`
  /// is called from several threads at a time. `hold` holds the points of least and largest lateral force
  /// against the true bodies (hold_against_bodies()); the others have a `bodies_effect` on the line between.
  /// `count` is called after each point.
  std::vector<WheelRailSolution>
  solve_creep_curve(
    const Scene                                                   &scene,
    const CreepCurve                                              &curve,
    const std::function<WheelRailSolution(const Scene &)>         &solve,
    const std::function<void(const Scene &, WheelRailSolution &)> &hold  = [](const Scene &, auto &) {},
    TaskCount                                                     *count = nullptr);
} // namespace wheelrail
