#pragma once

#include <wheelrail/base/parallel.h>
#include <wheelrail/input/cross_checks.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/model/scene_geometry.h>

#include <optional>

namespace wheelrail
{
  /// Whether a scene can be computed, and its profiles in touch, so that they are read once.
  struct CheckedScene
  {
    Findings                     found;
    std::optional<SceneGeometry> geometry; ///< none where an error forbids it
  };

  /// Rail that a scene needs before its start and beyond the end of its path [m]: the stress field below a
  /// patch of 13 mm reaches some 50 mm, and a few coarse cells must lie beyond the fine ones.
  double
  free_rail(const MeshSettings &scene, double patch_length);

  /// The checks between entries (cross_checks()), then those of the entries with the contact of the rigid
  /// profiles and with the machine (what is unknown of it is not checked). Reads the profiles. Throws nothing
  /// for a scene whose entries are each within their range.
  CheckedScene
  check_scene(const Scene &scene, const Machine &machine = {});

  /// The same checks where the profiles are read and in touch.
  Findings
  check_scene(const Scene &scene, const SceneGeometry &geometry, const Machine &machine);

  /// The geometry of a scene whose profiles touch, which half-spaces need: cells, rail and machine are not
  /// looked at. Throws InputError as require_computable().
  SceneGeometry
  require_touching(const SceneInput &input);

  /// The geometry of a scene that can be computed. Throws InputError with all errors of check_scene(), each
  /// after the place where its entry was set.
  SceneGeometry
  require_computable(const SceneInput &input);
} // namespace wheelrail
