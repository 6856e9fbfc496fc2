#include <wheelrail/bodies/kept_tables.h>
#include <wheelrail/mesh/wheel_section.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/reference/body_tables.h>

namespace wheelrail
{
  BodyTables
  make_body_tables(const Scene          &scene,
                   const SceneGeometry  &geometry,
                   const std::string    &folder,
                   const BodyTableSizes &sizes)
  {
    // two blocks around the middle of head and tread, whatever touches where
    const FineStrip       strip{{{0, 0}, 0}, {-sizes.block, 0, sizes.block}};
    const WheelDimensions wheel     = scene.wheel_dimensions();
    const SectionMesh     rail_mesh = mesh_section(
      make_rail_section(geometry.rail, {{0, 0}, 0}, strip, sizes.block), Boundary::foot, sizes.levels);
    const SectionMesh wheel_mesh =
      mesh_section(make_wheel_section(geometry.wheel, wheel, {{0, 0}, 0}, strip, sizes.block),
                   Boundary::bore,
                   sizes.levels);
    return {kept_body_table(
              folder, rail_mesh, geometry.rail.head, elasticity(scene.rail_material), false, 0, sizes.cells),
            kept_body_table(folder,
                            wheel_mesh,
                            geometry.wheel.tread,
                            elasticity(scene.wheel_material),
                            true,
                            wheel.nominal_radius,
                            sizes.cells)};
  }
} // namespace wheelrail
