#include <wheelrail/bodies/body_tables.h>
#include <wheelrail/bodies/kept_tables.h>
#include <wheelrail/mesh/wheel_section.h>
#include <wheelrail/model/scene_material.h>

// Sections whose tables serve any place of contact (doc/theory/bodies.md, 2.5-D elements): blocks of 16 mm,
// divided three times along the running surface, rail held at its foot, wheel at its bore.

namespace wheelrail
{
  BodySections
  body_sections(const Scene &scene, const SceneGeometry &geometry, const BodyTableSizes &sizes)
  {
    // two blocks around the middle of head and tread, whatever touches where
    const FineStrip strip{{{0, 0}, 0}, {-sizes.block, 0, sizes.block}};
    return {mesh_section(make_rail_section(geometry.rail, {{0, 0}, 0}, strip, sizes.block),
                         Boundary::foot,
                         sizes.levels),
            mesh_section(
              make_wheel_section(geometry.wheel, scene.wheel_dimensions(), {{0, 0}, 0}, strip, sizes.block),
              Boundary::bore,
              sizes.levels)};
  }


  BodyTables
  make_body_tables(const Scene          &scene,
                   const SceneGeometry  &geometry,
                   const std::string    &folder,
                   const BodyTableSizes &sizes)
  {
    // rows of 16 mm/2^3 = 2 mm, one cell each
    const BodySections sections = body_sections(scene, geometry, sizes);
    // names of the files follow from what is given here: other sizes are other tables
    return {
      kept_body_table(
        folder, sections.rail, geometry.rail.head, elasticity(scene.rail_material), false, 0, sizes.cells),
      kept_body_table(folder,
                      sections.wheel,
                      geometry.wheel.tread,
                      elasticity(scene.wheel_material),
                      true,
                      scene.wheel_dimensions().nominal_radius,
                      sizes.cells)};
  }
} // namespace wheelrail
