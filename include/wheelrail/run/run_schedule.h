#pragma once

#include <wheelrail/scene/scene.h>

namespace wheelrail
{
  struct Model;

  /// When a run does what besides stepping. Steps count from 1, over all parts of a run that was resumed.
  class RunSchedule
  {
  public:
    /// Over the whole path of a model; `stop_after_steps`: see RunOptions.
    RunSchedule(const Scene &scene, const Model &model, unsigned long stop_after_steps);

    /// The last one.
    unsigned long
    steps() const
    {
      return steps_;
    }

    /// A row of the history: every thousandth of the path, until steady every sixteenth of a cell where that
    /// is less; the first step and the last one.
    bool
    record(unsigned long step) const;

    /// Whether to ask if the run is steady: after every cell that is rolled, at a row of the history; never
    /// where the run does not end by itself.
    bool
    judge(unsigned long step) const;

    /// An output tick of Output/Ticks, at equal steps.
    bool
    tick(unsigned long step) const;

    /// Whether the ranks ask each other for a signal to stop: 20 steps take some hundredths of a second.
    bool
    listen(unsigned long step) const;

    /// The end that a test sets.
    bool
    break_off(unsigned long step) const;

    /// Whether the wheel comes over the place of Run/Evaluate at, on a step from one rolled distance to
    /// another [m].
    bool
    evaluate(double before, double now) const;

  private:
    unsigned long steps_, record_every_, judge_every_, ticks_, stop_after_; ///< judge_every_ 0: never
    double        evaluate_at_;                                             ///< [m]
  };
} // namespace wheelrail
