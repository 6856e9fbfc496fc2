#pragma once

#include <wheelrail/verdict/verdict.h>

#include <string>

namespace wheelrail
{
  /// What the table of `compare` comes to: by how much the peak pressure differs from that of half-spaces,
  /// what that is made of, and why half-spaces are no full reference where they are none. The verdict stands
  /// beside it, see judge_run().
  std::string
  agreement_sentence(const MeshSettings &scene, const Measures &measures, const Verdict &verdict);

  /// Where half-spaces are no full reference and the peak differs by more than a tenth: a sentence that says
  /// so and why, which is no fault of the run; empty otherwise.
  std::string
  difference_of_models(const Measures &measures, const Verdict &verdict);
} // namespace wheelrail
