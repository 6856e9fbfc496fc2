#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/wheel/halfspace_case.h>

#include <ostream>
#include <string>

namespace wheelrail
{
  /// Files to write for the program CONTACT; empty: none.
  struct ContactInputFiles
  {
    std::string basic;      ///< the discrete problem, for the basic module
    std::string wheel_rail; ///< the scene, for the wheel-rail module; two profile files go beside it
  };

  /// Solves the scene by its bodies (solve_with_bodies()), prints the figures, and writes halfspace.h5 (one
  /// tick in the form of a run's patch.h5), slices.h5 (stresses below the contact, as a run's), summary.json,
  /// parameters.prm and pictures into "<Output/Folder>-halfspace". Pictures are left out unless `draws`.
  /// Where file names are given, also writes inputs for the program CONTACT. `geometry` may be null unless
  /// needs_profiles(). Returns the exit code. Throws InputError, RunError.
  int
  run_halfspace_command(Scene                    scene,
                        const SceneGeometry     *geometry,
                        const ContactInputFiles &inputs,
                        bool                     draws,
                        std::ostream            &out);
} // namespace wheelrail
