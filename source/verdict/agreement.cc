#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/verdict/agreement.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// How far the peaks agree, or why half-spaces are no reference for it.
    std::string
    agreement(const Measures &m, const Verdict &verdict)
    {
      const double difference = std::abs(m.peak_difference);
      if (!std::isfinite(difference))
        return "The run has no peak pressure that could be compared";
      const std::string by = text("%.1f", std::max(0.1, 100 * difference)) + " % in peak pressure";
      if (bodies_judge(m, verdict))
        return "The run differs from the true bodies by " +
               text("%.1f", std::max(0.1, 100 * std::abs(m.bodies_difference))) +
               " % in peak pressure, from half-spaces, which are no reference here since " + verdict.limits +
               ", by " + text("%.1f", std::max(0.1, 100 * difference)) + " %";
      if (!verdict.limits.empty())
        return "The half-space solution is not a reliable reference here, since " + verdict.limits +
               "; run and half-spaces differ by " + by;
      if (difference > 0.02)
        return "The run differs from the half-spaces by " + by;
      // what is not resolved may agree by chance
      return verdict.grade() == Grade::trusted
               ? "The run agrees with the half-spaces within " + by
               : "The run differs from the half-spaces by " + by + ", which may be chance";
    }

    /// What the difference of the peaks is made of; empty where a part is not known.
    std::string
    parts(const Measures &m, const Verdict &verdict)
    {
      const auto   percent = [](const double part) { return text("%+.1f", 100 * part) + " %"; };
      const double rest    = m.peak_difference - m.penalty_part() - m.mesh_part();
      if (!std::isfinite(rest))
        return "";
      return " Of the difference of " + percent(m.peak_difference) +
             " in peak pressure the penalty contact makes about " + percent(m.penalty_part()) +
             ", the cells " + percent(m.mesh_part()) + ", " +
             (verdict.limits.empty() ? "the rest " : "what half-spaces do not have ") + percent(rest) + ".";
    }
  } // namespace


  std::string
  agreement_sentence(const MeshSettings &scene, const Measures &m, const Verdict &verdict)
  {
    std::string sentence = agreement(m, verdict);
    std::string facts;
    const auto  add = [&](const std::string &fact) { facts += (facts.empty() ? ": " : ", ") + fact; };
    if (std::isfinite(m.cells))
      add(text("%.1f", m.cells) + " cells of " + in_mm(scene.cell_size) +
          " lie over the shorter extent of the patch");
    if (std::isfinite(m.penetration))
      add("the penalty contact sinks in by " + text("%.1f", 100 * m.penetration) + " % of the approach");
    if (std::isfinite(m.unsteadiness))
      add("the forces vary by " + text("%.2f", 100 * m.unsteadiness) + " % of the load");
    if (std::isfinite(m.turn))
      add("the surfaces turn by " + text("%.0f", m.turn * 180 / M_PI) + " degrees across the patch");
    std::string beyond;
    for (const std::string &result : m.beyond)
      beyond += (beyond.empty() ? " Beyond their limits: " : ", ") + result;
    return sentence + facts + "." + parts(m, verdict) + beyond + (beyond.empty() ? "" : ".");
  }


  std::string
  difference_of_models(const Measures &m, const Verdict &verdict)
  {
    constexpr double usual = 0.1;
    if (!(std::abs(m.peak_difference) > usual) || verdict.limits.empty())
      return "";
    return "the peak pressure is " + text("%.0f", 100 * std::abs(m.peak_difference)) + " % " +
           (m.peak_difference < 0 ? "below" : "above") +
           " that of half-spaces under the same force and in the same position: the half-space "
           "solution is not a reliable reference here, since " +
           verdict.limits;
  }
} // namespace wheelrail
