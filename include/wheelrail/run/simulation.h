#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>

#include <string>

namespace wheelrail
{
  /// What the command line adds to a scene.
  struct RunOptions
  {
    bool          overwrite        = false; ///< replace a finished run in the output folder
    bool          resume           = false; ///< resume from the last saved state in the output folder
    unsigned long stop_after_steps = 0;     ///< as if interrupted after this step, 0 never; for tests
    std::string   prm_text;        ///< the file and what it includes, then the --set options as comments
    std::string   note;            ///< for the head of the screen, or empty
    std::string   parameters_text; ///< all entries in force, see print_parameters()
    std::string   program_version;
    std::string   whole_folder; ///< of the passages that the run is one of, or empty
  };

  /// Computes one wheel rolling over its rail: a scene with the `geometry` of its profiles
  /// (require_computable()) from static start to summary and writes its output folder. Collective over
  /// MPI_COMM_WORLD; catch_interrupts() has been called.
  ///
  /// Returns the exit code: 0 finished, 3 interrupted and saved. Throws InputError for what cannot
  /// be computed or must not be overwritten, RunError when the run stopped, on all ranks alike.
  int
  run_simulation(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options);
} // namespace wheelrail
