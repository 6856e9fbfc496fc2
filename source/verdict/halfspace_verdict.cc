#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/verdict/rules.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace wheelrail
{
  namespace
  {
    constexpr double most_shift_effect = 0.25;

    /// The elements that bring an interval of order p within what is wanted.
    std::string
    smaller_elements(const Measures &m, const double within, const double order)
    {
      if (!std::isfinite(m.element) || !std::isfinite(within))
        return "take a smaller Half-space/Element size";
      const double size = m.element * std::pow(m.wanted / within, 1 / order);
      return "take Half-space/Element size = " + in_mm(std::max(0.01e-3, 1e-5 * std::floor(1e5 * size)));
    }
  } // namespace


  void
  judge_held(const Measures &m, Verdict &verdict, const bool takes_bodies)
  {
    const bool        answer = takes_bodies && std::isfinite(m.bodies_effect);
    const std::string advice = answer ? "; take Half-space/Bodies = real." : ".";
    if (std::abs(m.bodies_effect) > m.wanted)
      add(verdict,
          Grade::with_care,
          text(
            "the peak pressure is %.0f %% %s that of the true bodies, whose head and rim turn and move under "
            "these forces, which half-spaces do not include",
            100 * std::abs(m.bodies_effect),
            m.bodies_effect < 0 ? "below" : "above") +
            advice);
    else if (m.peak.within <= m.wanted && std::abs(m.bodies_effect) + m.peak.within > m.wanted)
      add(verdict,
          Grade::with_care,
          text("the peak pressure is %.1f %% %s that of the true bodies, and %s %.1f %% of it open",
               100 * std::abs(m.bodies_effect),
               m.bodies_effect < 0 ? "below" : "above",
               m.peak.cause == "measured input" ? "noise in measured points leaves" : "the elements leave",
               100 * m.peak.within) +
            advice);
    else if (m.turn >= most_turn)
      add(
        verdict,
        Grade::with_care,
        text(
          "the surfaces turn by %.0f degrees across the contact, as in the flange root, which half-spaces do "
          "not know: the peak pressure may be off by 10 %% and more",
          m.turn * 180 / M_PI) +
          advice);
    else if (m.shift_effect >= most_shift_effect)
      add(
        verdict,
        Grade::with_care,
        text("the peak pressure changes by %.0f %% within the lateral shift by which wheel and rail give way "
             "under this load (0.2 mm per 100 kN to either side), which half-spaces do not include",
             100 * m.shift_effect) +
          advice);
    if (!m.unheld.empty())
      add(verdict,
          Grade::with_care,
          "true bodies do not confirm these half-spaces: " + m.unheld + (m.unheld.back() == '.' ? "" : "."));
  }


  Verdict
  judge_halfspaces(const Measures &measures)
  {
    Verdict verdict;
    judge_place(measures, verdict);
    judge_edges(measures, false, verdict);
    judge_known(measures.peak,
                "the peak pressure",
                smaller_elements(measures, measures.peak.within, 2),
                measures,
                verdict);
    judge_known(measures.creep,
                "creepage and creep forces",
                smaller_elements(measures, measures.creep.within, 1),
                measures,
                verdict);
    judge_sliding(measures, verdict);
    judge_held(measures, verdict);
    judge_steel(measures, verdict);
    return verdict;
  }
} // namespace wheelrail
