#include <wheelrail/geometry/made_up_part.h>
#include <wheelrail/wheel/halfspace_case.h>
#include <wheelrail/wheel/halfspace_parts.h>
#include <wheelrail/wheel/plane_contact.h>
#include <wheelrail/wheel/several_patches.h>
#include <wheelrail/wheel/wheel_load.h>

#include <algorithm>

namespace wheelrail
{
  WheelRailLoad
  scene_load(const Scene &scene, const SceneGeometry &geometry)
  {
    WheelRailLoad load;
    load.force        = static_wheel_load(scene, geometry.wheel);
    load.vertical     = true;
    load.longitudinal = scene.traction_coefficient * load.force;
    load.rate_held    = scene.drive == Drive::rate;
    load.creepage     = scene.creepage;
    return load;
  }


  double
  sum_over_patches(const WheelRailSolution                                &result,
                   const std::function<double(const WheelRailSolution &)> &of)
  {
    double sum = of(result);
    for (const WheelRailSolution &other : result.others)
      sum += of(other);
    return sum;
  }


  double
  steady_creepage(const WheelRailSolution &result)
  {
    const HalfspaceSolution &s = result.solution;
    return !result.problem.friction.frictionless() && (s.within_friction || s.xi < 0) ? s.xi : Summary::none;
  }


  SectionOffsets
  scene_offsets(const HalfspaceSettings &scene)
  {
    return {scene.halfspace_lateral, -scene.halfspace_inclination, 0};
  }


  WheelRailSolution
  solve_halfspaces(const Scene          &scene,
                   const SceneGeometry  &geometry,
                   const WheelRailLoad  &load,
                   const SectionOffsets &offsets)
  {
    PlaneContact one(scene, geometry, offsets, whole_region(geometry.contact));
    one.press(load.force);
    one.carry(load);
    const auto regions = separate_regions(geometry, offsets, one);
    return regions.size() > 1 ? solve_together(scene, geometry, load, offsets, regions, one) : one.result();
  }


  void
  name_made_up(const SceneGeometry &geometry, WheelRailSolution &result)
  {
    const auto touched = [&](WheelRailSolution &patch) {
      if (patch.reference)
        patch.made_up = made_up_part(geometry, patch.reference->place);
    };
    touched(result);
    std::for_each(result.others.begin(), result.others.end(), touched);
  }


  HalfspacePressure
  halfspace_pressure(const Scene          &scene,
                     const SceneGeometry  &geometry,
                     const double          normal_force,
                     const SectionOffsets &offsets,
                     const double          creepage)
  {
    PlaneContact one(scene, geometry, offsets, whole_region(geometry.contact));
    one.press(normal_force);
    one.solution.xi              = creepage;
    const PatchMeasures measures = measure_patch(halfspace_patch(one.solution));
    return {one.solution.peak_pressure,
            one.solution.approach,
            measures.width,
            measures.length,
            one.turn_across(measures),
            contact_reference(one.sections, one.means, one.motion, one.solution)};
  }


  HalfspacePressure
  halfspace_pressure(const WheelRailSolution &result)
  {
    const WheelRailSolution *highest = &result;
    for (const WheelRailSolution &other : result.others)
      if (other.solution.peak_pressure > highest->solution.peak_pressure)
        highest = &other;
    return {highest->solution.peak_pressure,
            highest->solution.approach,
            highest->measures.width,
            highest->measures.length,
            highest->turn,
            highest->reference.value_or(ContactReference()),
            result.others.size() + 1.};
  }
} // namespace wheelrail
