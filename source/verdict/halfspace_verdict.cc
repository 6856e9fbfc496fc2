#include <wheelrail/base/format_text.h>
#include <wheelrail/verdict/rules.h>

#include <cmath>
#include <string>

namespace wheelrail
{
  namespace
  {
    constexpr double most_shift_effect = 0.25;
    // changes on elements twice as large: pressure errs by a third of that, creep by about as much
    constexpr GradeBounds pressure_effect_bounds{0.1, 0.2}, creep_effect_bounds{0.05, 0.1};

    /// Elements of half-spaces.
    void
    judge_elements(const Measures &m, Verdict &verdict)
    {
      const auto told = [&](const double       effect,
                            const GradeBounds &bounds,
                            const std::string &what,
                            const std::string &verb) {
        if (!std::isnan(effect))
          add(verdict,
              graded(effect, bounds),
              "too few elements: " + what + " " + verb + text(" by %.0f %%", 100 * effect) +
                " on elements twice as large; take a smaller Half-space/Element size.");
      };
      told(m.pressure_effect, pressure_effect_bounds, "the peak pressure", "changes");
      told(m.creep_effect, creep_effect_bounds, "creepage and creep forces", "change");
    }
  } // namespace


  void
  judge_held(const Measures &m, Verdict &verdict, const bool takes_bodies)
  {
    const bool        answer = takes_bodies && std::isfinite(m.bodies_effect);
    const std::string advice = answer ? "; take Half-space/Bodies = real." : ".";
    if (std::abs(m.bodies_effect) > peak_bounds.good)
      add(verdict,
          Grade::with_care,
          text(
            "the peak pressure is %.0f %% %s that of the true bodies, whose head and rim turn and move under "
            "these forces, which half-spaces do not know",
            100 * std::abs(m.bodies_effect),
            m.bodies_effect < 0 ? "below" : "above") +
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
             "under this load (0.2 mm per 100 kN to either side), which half-spaces do not know",
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
    judge_elements(measures, verdict);
    judge_sliding(measures, verdict);
    judge_held(measures, verdict);
    judge_steel(measures, verdict);
    return verdict;
  }
} // namespace wheelrail
