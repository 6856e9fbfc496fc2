#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// One of the wheels that pass.
  struct PassingWheel
  {
    std::string   name; ///< "wheels.csv: row 2", "heavy.prm"; empty when all are as the scene
    Scene         scene;
    SceneGeometry geometry;
  };

  /// The wheels of one round over the rail: that of the scene, or one for each row or file of Run/Passage
  /// list. All have the fine cells for the largest of their loads (Mesh/Planned load) and, when they touch
  /// the rail at different places, around all these (Mesh/Planned strip). Reads profiles anew where a wheel
  /// has another contact. Throws InputError for a list that cannot be read, for a scene in it that changes
  /// the rail, and for a wheel without contact.
  std::vector<PassingWheel>
  passing_wheels(const Scene &scene, const SceneGeometry &geometry);
} // namespace wheelrail
