#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/run/run_state.h>
#include <wheelrail/sampling/residual.h>
#include <wheelrail/solid/stress_recovery.h>
#include <wheelrail/state/stop.h>
#include <wheelrail/verdict/interval.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Why a run must not go on after a step with energy, without a reason when it may. A value that is not
  /// finite, an energy balance beyond Run/Energy limit, a patch at the edge of the fine cells.
  Stop
  reason_to_stop(const RunParts &run);

  /// What only the simulation has of a run.
  struct RunTally
  {
    double        wall_time    = 0; ///< with the parts before a resume [s]
    double        loop_seconds = 0; ///< of the steps of this part [s]
    unsigned long first_step   = 0; ///< steps before this part
  };

  /// Puts the verdict into the summary of a finished run (verdict/verdict.h). Its peak pressure is held
  /// against that of half-spaces under its normal force and in its pose, and steady elastic results against
  /// the true bodies, which takes a second; both figures, and the intervals with their `contributions` are
  /// added too. Returns what else is to be said on the screen: where half-spaces are no reference, and a band
  /// of plastic flow that reaches below the fine cells.
  std::vector<std::string>
  judge(const Scene &scene, const SceneGeometry &geometry, Summary &summary, Contributions &contributions);

  /// Adds what the run left in the rail, the components where BB_behind cuts it.
  void
  add_residual(const Residual &residual, Summary &summary);

  /// The figures of a run at its end or where it stopped, without `finished` and the reason; `stress`: of the
  /// moment, see nodal_stress(). Collective.
  Summary
  summary_of(const RunParts &run, const RunTally &tally, const NodalStress &stress);

  /// After a failure: writes why into summary.json, with the means so far where the run has started (else
  /// null), as far as that can still be written. To be called on one rank.
  void
  write_failure(const Scene       &scene,
                const std::string &program_version,
                const RunState    *run,
                const std::string &error);
} // namespace wheelrail
