#pragma once

#include <wheelrail/verdict/verdict.h>

#include <string>

namespace wheelrail
{
  /// Up to `good` a measure is as it should be, from there to `fair` it asks for care.
  struct GradeBounds
  {
    double good, fair;
  };

  constexpr double most_turn = 0.2; ///< of surfaces that half-spaces stand for [rad]

  /// The grade of a measure that should be small; one that is no number is not trusted.
  Grade
  graded(double value, const GradeBounds &bounds);

  /// A share in words.
  std::string
  percent(double share);

  /// Adds a sentence, unless it is trusted.
  void
  add(Verdict &verdict, Grade grade, std::string sentence);

  /// What no steel bears, and what nobody has measured.
  void
  judge_place(const Measures &m, Verdict &verdict);

  /// An interval that reaches farther than Run/Wanted accuracy. `cure`: of all causes but measured input.
  void
  judge_known(const Known       &known,
              const std::string &what,
              const std::string &cure,
              const Measures    &m,
              Verdict           &verdict);

  /// Whether the pressure at an edge of the surfaces [rad] grows with each halving of cells or elements by
  /// more than is trusted, so that it is no result.
  bool
  without_bound(const Measures &m, double edge);

  /// Kinks in the patch, under which no cells or elements find a pressure; forces, which a run is for there,
  /// hold.
  void
  judge_edges(const Measures &m, bool run, Verdict &verdict);

  /// A driven or braked wheel that friction does not hold.
  void
  judge_sliding(const Measures &m, Verdict &verdict);

  /// Half-spaces beside the true bodies, or what stands for these. `takes_bodies`: the command would take
  /// them.
  void
  judge_held(const Measures &m, Verdict &verdict, bool takes_bodies = true);

  /// An elastic body beyond the shakedown limit of its steel.
  void
  judge_steel(const Measures &m, Verdict &verdict);
} // namespace wheelrail
