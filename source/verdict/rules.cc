#include <wheelrail/base/format_text.h>
#include <wheelrail/verdict/rules.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    constexpr GradeBounds edge_bounds{0.01, 0.02};   ///< growth of the peak with each halving of elements
    constexpr double      highest_of_any_rail = 4e9; ///< [Pa]
  }                                                  // namespace


  Grade
  graded(const double value, const GradeBounds &bounds)
  {
    return value <= bounds.good   ? Grade::trusted
           : value <= bounds.fair ? Grade::with_care
                                  : Grade::not_trusted;
  }


  std::string
  percent(const double share)
  {
    return std::isfinite(share) ? text("%.1f %%", 100 * std::abs(share)) : "an unknown part";
  }


  void
  add(Verdict &verdict, const Grade grade, std::string sentence)
  {
    if (grade == Grade::trusted)
      return;
    char &first = sentence[0]; // a sentence may begin with the name of a figure
    first       = static_cast<char>(std::toupper(static_cast<unsigned char>(first)));
    verdict.findings.push_back({grade, sentence});
  }


  void
  judge_place(const Measures &m, Verdict &verdict)
  {
    const std::string where = m.place.empty() ? "" : ", " + m.place + ",";
    if (m.peak_pressure > highest_of_any_rail)
      add(verdict,
          Grade::not_trusted,
          "the peak pressure of " + text("%.1f GPa", 1e-9 * m.peak_pressure) + where +
            " is more than any rail steel bears (4 GPa): the profiles touch at an edge, or the steel would "
            "yield; look at the contact with \"./wheelrail geometry\".");
    if (!m.made_up.empty())
      add(verdict,
          Grade::not_trusted,
          "the patch" + where + " lies on " + m.made_up +
            ", which no file holds; take a profile that "
            "reaches farther, or another lateral shift.");
  }


  void
  judge_known(const Known       &known,
              const std::string &what,
              const std::string &cure,
              const Measures    &m,
              Verdict           &verdict)
  {
    if (std::isnan(known.within))
      return;
    const bool noise    = known.cause == "measured input",
               elements = known.cause.find("elements") != std::string::npos;
    add(verdict,
        graded(known.within, {m.wanted, 2 * m.wanted}),
        (noise      ? "the noise in measured points leaves "
         : elements ? "too few elements: they leave "
                    : known.cause + " leave ") +
          what + " uncertain by " + percent(known.within) + "; " +
          (noise ? "take points with less noise, more digits or no gaps" : cure) + ".");
  }


  bool
  without_bound(const Measures &m, const double edge)
  {
    return graded(m.growth(edge), edge_bounds) != Grade::trusted;
  }


  void
  judge_edges(const Measures &m, const bool run, Verdict &verdict)
  {
    const auto tell = [&](const double edge, const std::string &what, const std::string &where) {
      constexpr double square = 1; // more than any edge of a running surface
      const Grade      grade  = graded(m.growth(edge), edge_bounds);
      add(
        verdict,
        run ? std::max(grade, Grade::with_care) : grade,
        what + " does not hold, forces do: " + where +
          (edge > square
             ? " the square end of a rail, where elastic pressure has no bound."
             : text(" an edge of %.3g mrad, where elastic pressure has no bound: each halving of the %s adds "
                    "%.0f MPa; round the edge.",
                    1e3 * edge,
                    run ? "cells" : "elements",
                    1e-6 * m.growth(edge) * m.peak_pressure)));
      return without_bound(m, edge);
    };
    if (tell(m.edge, "the peak pressure", "in the patch lies") ||
        tell(m.edge_on_path, "the largest pressure of the path", "it acts at"))
      return;
    if (m.growth(m.notch) > edge_bounds.good)
      add(verdict,
          Grade::with_care,
          text("in the patch lies a sharp notch of %.3g mrad: peak pressure is that of an edge that stays "
               "sharp; forces hold.",
               1e3 * m.notch));
  }


  void
  judge_sliding(const Measures &m, Verdict &verdict)
  {
    if (!m.slides.empty())
      add(verdict, Grade::with_care, m.slides);
  }


  void
  judge_steel(const Measures &m, Verdict &verdict)
  {
    if (!m.yields.empty())
      add(verdict, Grade::with_care, m.yields);
  }
} // namespace wheelrail
