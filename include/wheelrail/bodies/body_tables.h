#pragma once

#include <wheelrail/bodies/body_table.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>

#include <string>

namespace wheelrail
{
  /// How both bodies of a scene deflect: the rail on its clamped foot, the wheel on its bore. They include
  /// neither load nor friction nor speed, nor where wheel and rail touch.
  struct BodyTables
  {
    BodyTable rail, wheel;
  };

  /// How finely the sections are meshed for their tables.
  struct BodyTableSizes
  {
    double       block  = 16e-3; ///< [m]
    unsigned int levels = 3;     ///< rows are parts of blocks: block / 2^levels times `cells`
    unsigned int cells  = 1;     ///< across a row
  };

  /// The sections of both bodies as the tables have them.
  struct BodySections
  {
    SectionMesh rail, wheel;
  };
  BodySections
  body_sections(const Scene &scene, const SceneGeometry &geometry, const BodyTableSizes &sizes = {});

  /// Both tables, made or as they are kept in a folder (kept_tables.h). Throws InputError and RunError as
  /// sections and tables do.
  BodyTables
  make_body_tables(const Scene          &scene,
                   const SceneGeometry  &geometry,
                   const std::string    &folder,
                   const BodyTableSizes &sizes = {});
} // namespace wheelrail
