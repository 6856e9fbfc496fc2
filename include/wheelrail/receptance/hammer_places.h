#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/receptance/hammer.h>
#include <wheelrail/scene/scene.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Where the hammer hits a rail, and where the rail is observed.
  struct RailPlaces
  {
    double along = 0; ///< of the hammer, counted as Z of the run [m]
    /// The face that is struck; the same face along the other direction; then faces farther and farther
    /// along.
    std::vector<HammerFace> faces;
    std::vector<double>     distance; ///< of the faces along, from the hammer, beginning with 0 [m]
  };

  /// `at`: "sleeper" or "between" sleepers, nearest to the middle of the rail; a place, "250 mm"; empty: over
  /// a sleeper where there are some, else the middle of the rail. Vertical blows hit the top of the head,
  /// lateral ones the side of the head towards the track centre, 14 mm below the top. The face is observed
  /// along the rail up to 4 m, at most to the damped ends. Throws InputError where there is no such place.
  RailPlaces
  rail_places(const Scene &scene, const Section &rail, const std::string &at, bool lateral);

  /// The same for a wheel: the running surface at the contact of the run, vertical and lateral.
  std::vector<HammerFace>
  wheel_faces(const SceneGeometry &geometry, bool lateral);
} // namespace wheelrail
