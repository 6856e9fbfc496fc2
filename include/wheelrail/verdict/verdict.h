#pragma once

#include <wheelrail/output/summary.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/verdict/measures.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// How far figures can be trusted. The numbers stand in tables of several results.
  enum class Grade
  {
    not_trusted = 0,
    with_care   = 1,
    trusted     = 2
  };

  /// "trusted", "with care", "not trusted".
  std::string
  grade_word(Grade grade);

  /// One thing that is off: by how much, and what to do.
  struct Finding
  {
    Grade       grade;
    std::string sentence;
  };

  /// The one judgement of a result, which screen, pages and tables all show.
  struct Verdict
  {
    std::vector<Finding> findings;
    /// Why half-spaces are no full reference, so that the peak is not held against them; empty: they are one.
    std::string limits;
    /// Whether those are limits of elastic, smooth bodies as well, and not of half-spaces alone.
    bool limits_of_bodies = false;

    /// The lowest grade of the findings.
    Grade
    grade() const;

    /// The findings as sentences, the worst ones first.
    std::string
    doubts() const;
  };

  /// Adds it, unless it was told before.
  void
  add_finding(const Finding &finding, Verdict &verdict);

  /// Judges a finished run by the rules of doc/manual/compare.md. Cells, penalty, steadiness, balances and
  /// places are judged whatever the reference; the difference to half-spaces where they are one.
  Verdict
  judge_run(const Scene &scene, const Measures &measures);

  /// Whether true bodies are the reference in place of half-spaces: where only the shape of the contact is
  /// what half-spaces do not have, and a comparison with the bodies is there.
  bool
  bodies_judge(const Measures &measures, const Verdict &verdict);

  /// Judges half-spaces that have converged: their pressure, what they touch, edges, elements, sliding, and
  /// `measures.turn`, which true bodies leave NaN.
  Verdict
  judge_halfspaces(const Measures &measures);

  /// Puts it into a summary that is finished; one that is not is not trusted.
  void
  set_verdict(Summary &summary, const Verdict &verdict);

  /// The grade that a summary holds, also one written before there were three.
  Grade
  grade_of(const Summary &summary);
} // namespace wheelrail
