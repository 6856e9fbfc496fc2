#pragma once

#include <wheelrail/base/log.h>
#include <wheelrail/dynamics/rolling.h>
#include <wheelrail/model/model.h>
#include <wheelrail/sampling/recorder.h>
#include <wheelrail/sampling/run_parts.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/state/checkpoint_files.h>
#include <wheelrail/wheelset/axle.h>

#include <memory>
#include <optional>

namespace wheelrail
{
  /// What the steps of a run change, from the first step of this part of the run on. Its parts refer to each
  /// other, so that it stays where it was made.
  struct RunState
  {
    /// The hub `hub_displacement` [m] above its rigid place, turning with `rate` [rad/s]. The model is at
    /// rest in its static start, or waits for a saved state. Collective.
    RunState(const Scene &scene, Model &&model, double hub_displacement, double rate, MPI_Comm communicator);

    RunState(const RunState &) = delete;
    RunState &
    operator=(const RunState &) = delete;

    /// As others may look at it.
    RunParts
    parts() const
    {
      return {scene, model, axle, rolling, recorder, communicator};
    }

    /// Adds a row to the history, after a step with energy, and one of the patch.
    void
    record();

    const Scene   scene; ///< with the margin of fine cells that the start was found with
    Model         model;
    MPI_Comm      communicator;
    Axle          axle;
    Rolling       rolling;
    Recorder      recorder;
    unsigned int  ticks          = 0; ///< of the schedule, written so far
    unsigned long first_step     = 0; ///< steps before this part of the run
    double        first_distance = 0; ///< rolled before it [m]
    double        wall_before    = 0; ///< computing time before it [s]
    unsigned int  mesh_changes   = 0; ///< of fine cells that move, in this part
  };

  /// The state at the first step: in static equilibrium, with the velocities of rolling, over the `rail` of
  /// an earlier run if there is one (start_on_wide_mesh()). Collective; throws as that.
  std::unique_ptr<RunState>
  start_run(Scene                            scene,
            const SceneGeometry             &geometry,
            Model                            model,
            const std::optional<Checkpoint> &rail,
            Log                             &log,
            MPI_Comm                         communicator);

  /// The state that was saved, on the mesh that it had, with the path to the scene's Run/Rolling distance.
  /// Collective; throws as restore_checkpoint().
  std::unique_ptr<RunState>
  resume_run(const Scene &scene, Model model, const Checkpoint &saved, MPI_Comm communicator);

  // What a run takes from mesh to mesh. Without a moving window none of these changes a mesh.

  /// Moves the window on when the wheel has come to another block; whether it has. Collective.
  bool
  follow_wheel(RunState &run);

  /// Gives the window of a resumed run the path to the scene's Run/Rolling distance. Collective.
  void
  lengthen_path(RunState &run);
} // namespace wheelrail
