#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/scene/rail_bending.h>
#include <wheelrail/verdict/rules.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    // doc/manual/compare.md has this table, with what the main scene has
    constexpr GradeBounds unsteadiness_bounds{0.01, 0.05};
    constexpr GradeBounds pressure_noise_bounds{0.05, 0.1};
    constexpr GradeBounds swing_bounds{0.02, 0.05};
    constexpr GradeBounds drift_bounds{0.01, 0.05};
    constexpr GradeBounds energy_bounds{0.005, 0.01};
    constexpr GradeBounds load_bounds{0.01, 0.03};
    constexpr GradeBounds torque_bounds{0.01, 0.05};
    constexpr GradeBounds force_bounds{0.02, 0.05}; ///< some 0.15e-3 and 0.4e-3 of creepage
    constexpr GradeBounds beside_bounds{0.005, 0.05};
    constexpr double      most_strain_loss = 0.25; ///< of the plastic strain to the cells

    bool
    bodies_differ(const Measures &m)
    {
      return !m.has_yielded() && std::abs(m.bodies_difference) > m.wanted;
    }

    /// What cells and penalty leave open of the peak pressure: its interval, where it has one, else what both
    /// take by the laws of Measures.
    void
    judge_peak(const MeshSettings &scene, const Measures &m, Verdict &verdict)
    {
      const bool   known = std::isfinite(m.peak.within) && m.peak.cause != "measured input";
      const double lost  = m.lost(known || std::isfinite(m.bodies_difference));
      // of fewer than three cells no rule is known, and nothing can be trusted
      const bool few = !std::isnan(m.cells) && std::isnan(lost);
      if (bodies_differ(m) && lost <= m.wanted)
        return; // no cause of that difference
      const double within = known ? m.peak.within : lost;
      if (std::isnan(m.cells) || (!few && within <= m.wanted))
        return;
      const Grade       grade = few ? Grade::not_trusted : graded(within, {m.wanted, 2 * m.wanted});
      const std::string open  = text("leave the peak pressure uncertain by %.1f %%", 100 * within);
      if (m.penalty_part() < m.mesh_part())
        return add(verdict,
                   grade,
                   "the penalty contact, which sinks in by " + percent(m.penetration) +
                     " of the approach, and the cells " + open + "; raise Contact/Penalty scale.");
      const bool   ridge   = 2 * m.cells_across_peak < m.cells;
      const bool   between = lost > m.wanted && lost - m.between_nodes <= m.wanted;
      const double across  = ridge ? m.cells_across_peak : m.cells,
                   most =
                     few ? std::max(1.3 / std::pow(ridge ? 2 * across : across, 2), 2 * m.wanted) : within;
      // never coarser than what was told before the run
      const double size = advised_cell(
        scene.cell_size, std::max(most, std::isnan(m.expected_loss) ? 0 : m.expected_loss), m.wanted);
      add(verdict,
          grade,
          "too few cells: " + text("%.1f of ", across) + in_mm(scene.cell_size) + " lie across the " +
            (ridge ? "highest pressure" : "patch") + (between ? ", its peak between two nodes" : "") +
            (few ? "" : ", and " + open) + "; take Mesh/Solution cell size = " + in_mm(size) + ".");
    }

    /// Plastic strain is of first order in the cell.
    void
    judge_strain(const MeshSettings &scene, const Measures &m, Verdict &verdict)
    {
      // 3.2, 4.2e-3 on cells of 2, 1 mm (material.md, paper.md), thus 5.2e-3 at last
      if (const double loss = 2.5 / m.cells; m.has_yielded() && loss > most_strain_loss)
        add(verdict,
            Grade::with_care,
            "the largest plastic strain is that of cells of " + in_mm(scene.cell_size) +
              (loss < 0.5 ? text(", about %.0f %%", 100 * loss) : ", far") +
              " below that of the steel; take smaller cells.");
    }

    /// Contact that the run cannot have, since its solution cells end before it.
    void
    judge_beside(const Measures &m, Verdict &verdict)
    {
      if (m.beside > 0)
        add(verdict,
            graded(m.beside, beside_bounds),
            "the true bodies carry " + percent(m.beside) +
              " of the load beside the patch of the run, whose solution cells may end there; take Mesh/Fine "
              "margin = " +
              in_mm(m.margin) + ".");
    }

    /// What a run does that has not rolled far enough.
    std::string
    roll_on(const Scene &scene)
    {
      if (scene.until_steady())
        return "roll farther (Run/Longest distance)";
      // passages over a yielding rail, of which this may be one, all roll as far
      if (scene.motion != "none" || scene.rail_material.yields() || scene.irregular())
        return "roll farther (Run/Rolling distance)";
      return "roll until steady (Run/Rolling distance = until steady)";
    }

    /// Noise and trend over the stretch of the means, each by itself.
    void
    judge_steadiness(const Scene &scene, const Measures &m, Verdict &verdict)
    {
      add(verdict,
          graded(m.unsteadiness, unsteadiness_bounds),
          "the forces vary by " + percent(m.unsteadiness) +
            " of the load (standard deviation; 1 % is usual at most).");
      add(verdict,
          graded(m.pressure_noise, pressure_noise_bounds),
          "the peak pressure fluctuates by " + percent(m.pressure_noise) +
            " of its mean (standard deviation; 5 % are usual at most).");
      if (m.swing > swing_bounds.good)
        add(verdict,
            graded(m.swing, swing_bounds),
            m.swing_of + " fluctuates by " + percent(m.swing) + " in the means over 2 mm and is not steady.");
      if (m.drift > drift_bounds.good)
        add(verdict,
            graded(m.drift, drift_bounds),
            m.drift_of + " still changes, by " + percent(m.drift) +
              " from the first to the last millimetre of the means; " + roll_on(scene) + ".");
      else if (!(m.swing > swing_bounds.good) && m.means_from > 0 && m.settled_after > m.means_from)
        add(verdict,
            Grade::with_care,
            "not all results have come within 1 % of their means before " +
              text("%.1f mm", 1e3 * m.means_from) + " rolled, where the means begin; " + roll_on(scene) +
              ".");
    }

    /// What is known exactly: energy, weight, torque.
    void
    judge_balances(const Scene &scene, const Measures &m, Verdict &verdict)
    {
      add(verdict,
          graded(m.energy_error, energy_bounds),
          "the energy balance is off by " + percent(m.energy_error) +
            " of strain plus dissipated energy; take a smaller Run/Time step factor.");
      if (!std::isnan(m.load_miss))
        add(verdict,
            graded(std::abs(m.load_miss), load_bounds),
            "the mean vertical force is " + percent(m.load_miss) + (m.load_miss < 0 ? " below" : " above") +
              " the wheel load: the wheel has not come to rest on its contact; " + roll_on(scene) + ".");
      if (!std::isnan(m.torque_miss))
        add(verdict,
            graded(std::abs(m.torque_miss), torque_bounds),
            "the longitudinal force is off by " + percent(m.torque_miss) +
              " from what the torque of the wheel demands: the wheel still speeds up or slows down, and "
              "creepage and T-gamma are not steady; " +
              roll_on(scene) + ", where friction can carry the torque.");
    }

    /// A creepage that is given leaves the longitudinal force to the run.
    void
    judge_creep_force(const Measures &m, Verdict &verdict)
    {
      if (!std::isnan(m.force_difference) && !m.has_yielded())
        add(verdict,
            graded(std::abs(m.force_difference), force_bounds),
            "the longitudinal force is " + percent(m.force_difference) + " of the load " +
              (m.force_difference < 0 ? "below" : "above") +
              " that of the true bodies with the same creepage; take finer cells, or roll farther "
              "(Run/Rolling distance).");
    }

    /// Over irregular surfaces: whether the means are those of a contact, and the largest force is known.
    void
    judge_path(const Measures &m, Verdict &verdict)
    {
      constexpr double short_path = 0.5e-3; // what the force still rises over [m]
      if (m.off_rail())
        add(verdict,
            Grade::with_care,
            "the wheel carries " + percent(m.load_share) +
              " of its load where the means are taken: it is off the rail there, and they say nothing of the "
              "contact; take Run/Evaluate at = largest force.");
      const auto at_end = [&](const std::string &force, const double at) {
        if (at > m.path_end - short_path)
          add(verdict,
              Grade::with_care,
              "the largest vertical force" + force + " acts at the end of the path, " +
                text("%.1f mm", 1e3 * at) +
                ", so that a larger one may come behind it; roll farther (Run/Rolling distance).");
      };
      at_end("", m.force_at);
      if (m.force_at <= m.path_end - short_path)
        at_end(" on the second rail", m.second_rail_force_at);
    }

    /// On irregular surfaces the force depends on how the rail gives way from 200 Hz to 2 kHz.
    void
    judge_support(const Scene &scene, Verdict &verdict)
    {
      if (scene.support.kind != RailSupport::clamped_foot)
        {
          if (const double enough = enough_rail(scene); scene.rail_length < enough)
            add(verdict,
                Grade::with_care,
                "the rail of " + text("%.3g m is short for its support: its free ends ", scene.rail_length) +
                  (scene.irregular() ? "throw waves back and make" : "make") +
                  " it sink and tilt more than a long one; take Track/Rail length = " +
                  text("%.1f m.", std::ceil(10 * enough) / 10));
        }
      else if (scene.irregular())
        add(verdict,
            Grade::with_care,
            "the rail's foot is clamped: the largest force may be twice that of a rail on sleepers; take "
            "Track/Support = sleepers, as prm/sleepers.prm does.");
    }

    void
    find_limits(const Scene &scene, const Measures &m, Verdict &verdict)
    {
      const auto limit = [&](const std::string &why) {
        verdict.limits += (verdict.limits.empty() ? "" : " and ") + why;
      };
      if (scene.irregular())
        limit("the surfaces are irregular, so that means are not those of one place");
      if (m.has_yielded())
        limit("steel has yielded (plastic strain up to " + text("%.2g", 1e3 * m.plastic_strain) + "e-3)");
      verdict.limits_of_bodies = !verdict.limits.empty();
      if (m.turn >= most_turn)
        limit("the surfaces turn by " + text("%.0f", m.turn * 180 / M_PI) + " degrees across the patch");
      if (m.patches > 1)
        limit("the run has " + text("%.0f", m.patches) + " patches");
    }

    /// The difference that nothing before explains, where half-spaces are a reference.
    void
    judge_agreement(const Measures &m, Verdict &verdict)
    {
      if (!m.no_reference.empty())
        add(verdict, Grade::with_care, m.no_reference);
      const bool   bodies     = std::isfinite(m.bodies_difference) && !verdict.limits_of_bodies;
      const double difference = bodies ? m.bodies_difference : m.peak_difference;
      if (std::isnan(difference) || (!bodies && !verdict.limits.empty()))
        return;
      add(verdict,
          graded(std::abs(difference), {m.wanted, 2 * m.wanted}),
          "the peak pressure is " + text("%.0f %% ", 100 * std::abs(difference)) +
            (difference < 0 ? "below" : "above") +
            (bodies ? " that of the true bodies under the same forces"
                    : " that of half-spaces under the same force and in the same position") +
            (verdict.findings.empty()
               ? ", and the usual causes (cells, penalty, unsteady forces) do not explain it."
               : "."));
    }
  } // namespace


  bool
  bodies_judge(const Measures &measures, const Verdict &verdict)
  {
    return !verdict.limits.empty() && !verdict.limits_of_bodies && std::isfinite(measures.bodies_difference);
  }


  std::string
  grade_word(const Grade grade)
  {
    return grade == Grade::trusted ? "trusted" : grade == Grade::with_care ? "with care" : "not trusted";
  }


  Grade
  Verdict::grade() const
  {
    Grade lowest = Grade::trusted;
    for (const Finding &finding : findings)
      lowest = std::min(lowest, finding.grade);
    return lowest;
  }


  std::string
  Verdict::doubts() const
  {
    std::vector<Finding> sorted = findings;
    std::stable_sort(
      sorted.begin(), sorted.end(), [](const Finding &a, const Finding &b) { return a.grade < b.grade; });
    std::string sentences;
    for (const Finding &finding : sorted)
      sentences += (sentences.empty() ? "" : " ") + finding.sentence;
    return sentences;
  }


  void
  add_finding(const Finding &finding, Verdict &verdict)
  {
    if (std::none_of(verdict.findings.begin(), verdict.findings.end(), [&](const Finding &told) {
          return told.sentence == finding.sentence;
        }))
      verdict.findings.push_back(finding);
  }


  Verdict
  judge_run(const Scene &scene, const Measures &measures)
  {
    Verdict verdict;
    judge_place(measures, verdict);
    judge_edges(measures, true, verdict);
    judge_sliding(measures, verdict);
    judge_peak(scene, measures, verdict);
    judge_strain(scene, measures, verdict);
    judge_beside(measures, verdict);
    if (scene.irregular())
      judge_path(measures, verdict);
    else
      judge_steadiness(scene, measures, verdict);
    judge_balances(scene, measures, verdict);
    judge_creep_force(measures, verdict);
    judge_support(scene, verdict);
    find_limits(scene, measures, verdict);
    judge_agreement(measures, verdict);
    if (measures.peak.cause == "measured input")
      judge_known(measures.peak, "the peak pressure", "", measures, verdict);
    if (measures.creep.within > measures.wanted && verdict.grade() == Grade::trusted)
      add(verdict,
          Grade::with_care,
          measures.creep.cause + " leave creepage or T-gamma uncertain by " + percent(measures.creep.within) +
            "; " + (measures.creep.cause == "noise and trend" ? roll_on(scene) : "take smaller cells") + ".");
    judge_steel(measures, verdict);
    return verdict;
  }


  void
  set_verdict(Summary &summary, const Verdict &verdict)
  {
    summary.verdict = grade_word(verdict.grade());
    summary.doubts  = verdict.doubts();
  }


  Grade
  grade_of(const Summary &summary)
  {
    const std::string word = verdict_of(summary);
    for (const Grade grade : {Grade::trusted, Grade::with_care})
      if (word == grade_word(grade))
        return grade;
    return Grade::not_trusted;
  }
} // namespace wheelrail
