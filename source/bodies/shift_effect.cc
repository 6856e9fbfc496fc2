#include <wheelrail/base/errors.h>
#include <wheelrail/bodies/answering_bodies.h>
#include <wheelrail/bodies/shift_effect.h>
#include <wheelrail/input/cross_checks.h>
#include <wheelrail/wheel/coarse_halfspaces.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// How far half-spaces hold (doc/theory/bodies.md, Where half-spaces hold): against the true bodies under the
// same forces, or by the lateral shift with which wheel and rail yield, 0.2 mm per 100 kN.

namespace wheelrail
{
  double
  shift_effect(const Scene &scene, const SceneGeometry &geometry, const double normal_force)
  {
    // what the shift of half-spaces has to be changed by for the pressure of the true bodies, of S1002 on
    // 54E1 and 60E1 under 103 kN (doc/theory/bodies.md)
    constexpr double compliance = 0.2e-3 / 100e3; // [m/N]
    // two solutions to either side, in coarse elements: the change counts, not the value
    const Scene coarse = coarse_halfspaces(scene);
    // [m]: 0.2 mm at 100 kN
    const double         by      = compliance * normal_force;
    const SectionOffsets offsets = scene_offsets(scene);
    double               peak[2] = {0, 0};
    for (const int side : {0, 1})
      {
        SectionOffsets moved = offsets;
        moved.lateral += side == 0 ? -by : by;
        peak[side] = halfspace_pressure(coarse, geometry, normal_force, moved).peak;
      }
    const double least = std::min(peak[0], peak[1]);
    // larger peak over smaller one, less 1: no sign
    return least > 0 ? std::max(peak[0], peak[1]) / least - 1 : Measures::none;
  }


  void
  find_shift_effect(const Scene &scene, const SceneGeometry &geometry, WheelRailSolution &result)
  {
    // of half-spaces alone: true bodies have moved already
    if (scene.halfspace_bodies == ContactBodies::real)
      return;
    const double force = sum_over_patches(result, [](const auto &patch) { return patch.solution.fn; });
    // profiles that end there: what was solved is no worse for it
    fault_of([&]() { result.shift_effect = shift_effect(scene, geometry, force); });
  }


  void
  hold_against_bodies(const Scene &scene, const SceneGeometry &geometry, WheelRailSolution &result)
  {
    if (scene.halfspace_bodies == ContactBodies::real)
      return;
    const std::string fault = fault_of([&]() {
      Scene bodies = scene;
      // true bodies know no other
      bodies.halfspace_spin = HalfspaceSpin::local_radius;
      if (const std::vector<std::string> refused = refused_by_bodies(bodies); !refused.empty())
        throw InputError(refused.front());
      WheelRailLoad load;
      load.vertical = true;
      load.force    = sum_over_patches(result, [](const auto &patch) { return patch.vertical; });
      // along the track, driving positive
      load.longitudinal = sum_over_patches(result, [](const auto &patch) {
        return patch.reference ? patch.reference->driving : -patch.solution.fx;
      });
      load.slides       = !result.solution.within_friction;
      if (const auto real = solve_true_bodies(bodies, geometry, load))
        {
          // peak of half-spaces over that of the true bodies, less 1 (doc/theory/bodies.md, Where half-spaces
          // hold)
          result.bodies_effect = halfspace_pressure(result).peak / real->solution.peak_pressure - 1;
          result.bodies        = {{"max_pressure_Pa", real->solution.peak_pressure},
                                  {"contact_area_m2", real->measures.area},
                                  {"creepage", steady_creepage(*real)},
                                  {"lateral_force_N", real->lateral}};
        }
    });
    if (!std::isfinite(result.bodies_effect))
      {
        // without true bodies the shift decides
        result.unheld = fault.empty() ? "their solution is not exact" : fault;
        find_shift_effect(scene, geometry, result);
      }
    else if (scene.both_wheels && scene.pose_balances)
      result.unheld = "shift and yaw are those at which half-spaces balance";
  }
} // namespace wheelrail
