#include <wheelrail/base/errors.h>
#include <wheelrail/base/parallel.h>
#include <wheelrail/base/progress.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/base/value_list.h>
#include <wheelrail/vehicle/creep_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wheelrail
{
  namespace
  {
    /// How far the creepage of a solution is from the value, in that of the scene's entry.
    double
    missing(const CreepAxis axis, const ContactReference &at, const double value, const double side)
    {
      if (axis == CreepAxis::lateral)
        return (value - at.lateral_creepage) * at.speed / std::cos(at.angle) * side;
      const auto over_velocity = [](const double creepage) { return creepage / (1 - 0.5 * creepage); };
      return over_velocity(value) - over_velocity(at.creepage);
    }

    /// Leaves the scene with the creepage or spin at which the value is met.
    WheelRailSolution
    solve_point(Scene                                                 &scene,
                const CreepAxis                                        axis,
                const double                                           value,
                const std::function<WheelRailSolution(const Scene &)> &solve)
    {
      if (axis == CreepAxis::spin)
        {
          scene.halfspace_given_spin = value;
          return solve(scene);
        }
      if (axis == CreepAxis::longitudinal)
        scene.drive = Drive::rate;
      double &entry = axis == CreepAxis::longitudinal ? scene.creepage : scene.lateral_creepage;
      entry         = axis == CreepAxis::lateral && scene.left_wheel ? -value : value;
      // the reference point moves by some micrometres with the forces
      constexpr double  enough = 1e-7;
      constexpr int     most   = 4;
      WheelRailSolution result = solve(scene);
      for (int round = 1; round < most && result.reference; ++round)
        {
          const double step = missing(axis, *result.reference, value, scene.left_wheel ? -1 : 1);
          if (!(std::abs(step) > enough))
            break;
          entry += step;
          result = solve(scene);
        }
      return result;
    }
  } // namespace


  std::string
  creep_axis_name(const CreepAxis axis)
  {
    return axis == CreepAxis::longitudinal ? "longitudinal" : axis == CreepAxis::lateral ? "lateral" : "spin";
  }


  CreepCurve
  parse_creep_curve(const std::string &text)
  {
    const auto fail = [&](const std::string &why) {
      throw InputError(
        "--creep-curve \"" + text + "\": " + why +
        "; write longitudinal, lateral or spin, then first:last:step or values with commas, and % or "
        "1/m, such as \"longitudinal -2:2:0.1 %\" or \"spin -1:1:0.1 1/m\"");
    };
    std::string       rest  = text;
    const std::size_t first = rest.find_first_not_of(' '), blank = rest.find(' ', first);
    CreepCurve        curve;
    const std::string word = first == std::string::npos
                               ? ""
                               : rest.substr(first, blank == std::string::npos ? blank : blank - first);
    if (word == "lateral")
      curve.axis = CreepAxis::lateral;
    else if (word == "spin")
      curve.axis = CreepAxis::spin;
    else if (word != "longitudinal")
      fail("\"" + word + "\" is none of them");
    rest          = blank == std::string::npos ? "" : rest.substr(blank);
    double factor = 1;
    if (const std::size_t unit = rest.find("1/m"); curve.axis == CreepAxis::spin)
      {
        if (unit == std::string::npos || unit + 3 != rest.find_last_not_of(' ') + 1)
          fail("a spin needs its unit 1/m");
        rest.resize(unit);
      }
    else if (const std::size_t percent = rest.find('%'); percent != std::string::npos)
      {
        if (percent != rest.find_last_not_of(' '))
          fail("something follows the %");
        rest.resize(percent);
        factor = 0.01;
      }
    const ValueList list = parse_value_list(rest, 1000);
    if (!list.fault.empty())
      fail(list.fault);
    for (const double value : list.values)
      curve.values.push_back(factor * value);
    const double most = curve.axis == CreepAxis::spin ? 20 : 0.3;
    for (const double value : curve.values)
      if (std::abs(value) > most)
        fail(format_number(value / factor) + " is beyond " + format_number(most / factor));
    return curve;
  }


  std::vector<WheelRailSolution>
  solve_creep_curve(const Scene                                                   &scene,
                    const CreepCurve                                              &curve,
                    const std::function<WheelRailSolution(const Scene &)>         &solve,
                    const std::function<void(const Scene &, WheelRailSolution &)> &hold,
                    TaskCount                                                     *count)
  {
    std::vector<WheelRailSolution> points(curve.values.size());
    std::vector<Scene>             scenes(points.size(), scene);
    parallel_for(points.size(), [&](const std::size_t i) {
      points[i] = solve_point(scenes[i], curve.axis, curve.values[i], solve);
      if (count)
        count->one_more();
    });
    const auto [least, most] = std::minmax_element(
      points.begin(), points.end(), [](const auto &a, const auto &b) { return a.lateral < b.lateral; });
    hold(scenes[least - points.begin()], *least);
    if (most != least)
      hold(scenes[most - points.begin()], *most);
    const double      slope  = most->lateral > least->lateral
                                 ? (most->bodies_effect - least->bodies_effect) / (most->lateral - least->lateral)
                                 : 0;
    const std::string unheld = least->unheld.empty() ? most->unheld : least->unheld;
    for (WheelRailSolution &point : points)
      {
        point.unheld        = unheld;
        point.bodies_effect = least->bodies_effect + slope * (point.lateral - least->lateral);
      }
    return points;
  }
} // namespace wheelrail
