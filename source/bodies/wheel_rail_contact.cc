#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/bodies/kept_tables.h>
#include <wheelrail/bodies/wheel_rail_contact.h>

#include <chrono>

namespace wheelrail
{
  WheelRailSolution
  solve_wheel_rail(const Scene          &scene,
                   const SceneGeometry  &geometry,
                   const WheelRailLoad  &load,
                   const SectionOffsets &offsets)
  {
    const auto        begin = std::chrono::steady_clock::now();
    WheelRailSolution result =
      scene.halfspace_bodies == ContactBodies::real
        ? solve_bodies(scene, geometry, load, make_body_tables(scene, geometry, kept_tables_folder()))
        : solve_halfspaces(scene, geometry, load, offsets);
    name_made_up(geometry, result);
    result.time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
  }
} // namespace wheelrail
