#pragma once

#include <wheelrail/base/body.h>
#include <wheelrail/input/motion_file.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>

#include <ostream>
#include <string>

namespace wheelrail
{
  /// What is struck, and how.
  struct ReceptanceOptions
  {
    Body        body    = Body::rail;
    bool        lateral = false;
    std::string at;               ///< as rail_places() has it
    double      duration = 40e-3; ///< of the record [s]
    std::string beside;           ///< file of another result, or empty
    bool        waves = true;     ///< of a rail also by the waves of its section
    bool        draws = true;
  };

  /// Carries out `receptance`: a hammer on the rail or the wheel of a scene by itself; receptance, mobility
  /// and accelerance, decay rate along the track and resonances. Writes receptance.csv and .h5,
  /// resonances.csv, of a rail waves.csv, summary.json, and a page where it draws, into the folder of the
  /// scene with -receptance. Throws InputError for a place where the rail cannot be struck. Returns 0.
  int
  run_receptance_command(const Scene             &scene,
                         const SceneGeometry     &geometry,
                         const ReceptanceOptions &options,
                         std::ostream            &out);
} // namespace wheelrail
