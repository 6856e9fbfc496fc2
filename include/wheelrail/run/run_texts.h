#pragma once

#include <wheelrail/base/format_text.h>
#include <wheelrail/base/log.h>
#include <wheelrail/model/model.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/sampling/run_parts.h>
#include <wheelrail/state/stop.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Numbers of cells and nodes.
  std::string
  mesh_text(const MeshQuality &q);

  /// Time step [s] and number of steps of a run of `duration` [s], and the cell that limits the step.
  std::string
  time_step_text(double duration, double step, const StableStep &limit);

  /// Writes what a run starts from: the scene in words (scene_head()) with a `note` on it, if any, contact
  /// point, mesh, time step, contact stiffness, the notes on profile files, and the warnings of the checks.
  void
  write_header(Log                            &log,
               const Scene                    &scene,
               const Model                    &model,
               int                             ranks,
               const std::string              &note,
               const std::vector<std::string> &profile_notes,
               const std::vector<std::string> &warnings);

  /// The line of an output tick; this part of the run began after `first_step` steps and `first_distance`
  /// [m], and has gone on for `elapsed` [s].
  TickLine
  tick_line(const RunParts &run, unsigned long first_step, double first_distance, double elapsed);

  /// Writes where the time of the steps went; `mesh_changes`: of fine cells that move.
  void
  write_timing(Log &log, const RunParts &run, const Summary &summary, unsigned int mesh_changes);

  /// Writes what a run that stopped has saved, the state at `saved` [m] rolled of `bytes` on the disk (or no
  /// state, null), and the command that resumes from it on as many ranks, with the scene of `folder`: its
  /// own, or that of all passages; where that would only stop again at the same place, what helps.
  void
  write_path_on(Log               &log,
                const RunSettings &scene,
                const std::string &folder,
                const Stop        &stop,
                const double      *saved,
                double             bytes,
                int                ranks);

  /// Adds the rigid motions of rail head and wheel rim near the contact to the figures of a run, see
  /// fit_pose(). Collective.
  void
  add_pose(Summary                &summary,
           const WheelsetSettings &scene,
           const Model            &model,
           const Axle             &axle,
           MPI_Comm                communicator);
} // namespace wheelrail
