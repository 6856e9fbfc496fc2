#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/output/fields.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/wheel/halfspace_case.h>

#include <string>
#include <vector>

namespace wheelrail
{
  class TaskCount;

  /// Where the wheel stands on irregular surfaces.
  struct IrregularPlaces
  {
    bool                pitch = false; ///< values are angles of the wheel, else places along the track
    std::vector<double> values;        ///< [m] or [rad]
  };

  /// Reads the value of --places ("0:100:5 mm", in mm, cm or m) or --pitch ("-7:0:1 deg", in deg, mrad or
  /// rad). Throws InputError that names the option.
  IrregularPlaces
  parse_irregular_places(const std::string &text, bool pitch);

  /// The wheel at rest under its load at one place.
  struct PlaceContact
  {
    double      place         = 0;     ///< along the track, of the lowest line of the smooth wheel [m]
    double      pitch         = 0;     ///< of the wheel, falling in rolling as in CONTACT [rad]
    double      peak_pressure = 0;     ///< [Pa]
    double      area          = 0;     ///< of whole elements with pressure [m2]
    double      width = 0, length = 0; ///< of all patches together [m]
    double      centre_along   = 0;    ///< of pressure, ahead of `place` [m]
    double      centre_lateral = 0;    ///< s of it [m]
    double      approach       = 0;    ///< of the bodies from first touch [m]
    double      drop           = 0;    ///< of the wheel below where it stands on the smooth rail [m]
    double      normal_force   = 0;    ///< [N]
    double      slope_force    = 0;    ///< on the wheel along the track, of the pressure on slopes [N]
    int         patches        = 0;    ///< areas that hang together
    std::string fault;                 ///< why it could not be solved; empty: it was
    Verdict     verdict;               ///< of what was solved
    PatchFields patch;
  };

  /// Solves the normal contact of half-spaces under the vertical load of the scene [N] at each place: at a
  /// place along the track the wheel has rolled there from the start, so that its own irregularities have
  /// turned with it; at a pitch the wheel alone has turned, on the place of the start. Without friction; in
  /// the plane of the smooth contact. `count` is told of each place.
  std::vector<PlaceContact>
  solve_places(const Scene           &scene,
               const SceneGeometry   &geometry,
               double                 load,
               const IrregularPlaces &places,
               TaskCount             *count = nullptr);
} // namespace wheelrail
