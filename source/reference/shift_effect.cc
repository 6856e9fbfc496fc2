#include <wheelrail/base/errors.h>
#include <wheelrail/reference/shift_effect.h>

#include <algorithm>

namespace wheelrail
{
  double
  shift_effect(const Scene &scene, const SceneGeometry &geometry, const double normal_force)
  {
    // what the shift of half-spaces has to be changed by for the pressure of the true bodies, of S1002 on
    // 54E1 and 60E1 under 103 kN (doc/theory/bodies.md)
    constexpr double give_way     = 0.2e-3 / 100e3; // [m/N]
    Scene            coarse       = scene;
    coarse.halfspace_element_size = std::max(0.8e-3, scene.halfspace_element_size);
    const double         by       = give_way * normal_force;
    const SectionOffsets offsets  = scene_offsets(scene);
    double               peak[2]  = {0, 0};
    for (const int side : {0, 1})
      {
        SectionOffsets moved = offsets;
        moved.lateral += side == 0 ? -by : by;
        peak[side] = halfspace_pressure(coarse, geometry, normal_force, moved).peak;
      }
    const double least = std::min(peak[0], peak[1]);
    return least > 0 ? std::max(peak[0], peak[1]) / least - 1 : Measures::none;
  }


  void
  find_shift_effect(const Scene &scene, const SceneGeometry &geometry, WheelRailSolution &result)
  {
    if (scene.halfspace_bodies == ContactBodies::real)
      return;
    double force = result.solution.fn;
    for (const WheelRailSolution &other : result.others)
      force += other.solution.fn;
    try
      {
        result.shift_effect = shift_effect(scene, geometry, force);
      }
    catch (const InputError &) // profiles that end there; what was solved is no worse for it
      {
      }
  }


  void
  hold_against_bodies(const Scene &scene, const SceneGeometry &geometry, WheelRailSolution &result)
  {
    find_shift_effect(scene, geometry, result);
    if (scene.halfspace_bodies == ContactBodies::real || scene.halfspace_lateral != 0 ||
        scene.halfspace_inclination != 0)
      return;
    WheelRailLoad load;
    load.force        = result.vertical;
    load.vertical     = true;
    double peak       = result.solution.peak_pressure;
    load.longitudinal = result.reference ? result.reference->driving : -result.solution.fx;
    load.slides       = !result.solution.within_friction;
    for (const WheelRailSolution &other : result.others)
      {
        load.force += other.vertical;
        load.longitudinal += other.reference ? other.reference->driving : -other.solution.fx;
        peak = std::max(peak, other.solution.peak_pressure);
      }
    Scene bodies            = scene;
    bodies.halfspace_bodies = ContactBodies::real;
    try
      {
        const WheelRailSolution real = solve_wheel_rail(bodies, geometry, load, {});
        if (real.solution.converged())
          result.bodies_effect = peak / real.solution.peak_pressure - 1;
      }
    catch (const InputError &) // sections that have no tables
      {
      }
    catch (const RunError &)
      {
      }
  }
} // namespace wheelrail
