#pragma once

#include <wheelrail/scene/scene.h>

#include <string>

namespace wheelrail
{
  /// Why a run ended before its distance, and what that means for going on from its last saved state. The
  /// steps after a resume are those of the first run, so what stopped it stops it again at the same place,
  /// unless something of what may change is changed.
  struct Stop
  {
    std::string reason;              ///< a sentence; empty: the run has not stopped
    double      rolled_distance = 0; ///< where [m]
    std::string cure;                ///< what a new start needs; empty when the run can simply go on
    double      energy_error = 0;    ///< when it went beyond Run/Energy limit, otherwise 0
  };

  /// Why a run stopped and what a new start needs, in one sentence.
  std::string
  sentence(const Stop &stop);

  /// Why a run that has been stopped so, whose last state has rolled `saved_distance` [m], would stop there
  /// again with the entries of `scene`, and what helps; empty when it would not.
  std::string
  obstacle_of_stop(const Stop &stop, double saved_distance, const RunSettings &scene);
} // namespace wheelrail
