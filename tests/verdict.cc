// When the figures of a finished run are not to be trusted: noise, energy, settling.

#include <wheelrail/input/parameters.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/run/run_end.h>

#include "check.h"

#include <cmath>
#include <string>
#include <utility>

using namespace wheelrail;
using namespace test;

namespace
{
  /// A quiet run of 100 kN and 1200 MPa, settled after 5 mm.
  Summary
  quiet()
  {
    Summary summary;
    summary.energy_error = 4e-4;
    for (const auto &[key, value] : {std::pair<const char *, double>{"normal_force_N", 1e5},
                                     {"normal_force_std_N", 30.},
                                     {"max_pressure_fitted_Pa", 1.2e9},
                                     {"max_pressure_fitted_std_Pa", 1e6},
                                     {"largest_swing", 2e-3},
                                     {"settled_after_m", 5e-3}})
      set_figure(summary, key, value);
    return summary;
  }

  std::string
  doubts(const char *key, const double value, const double from = 40e-3)
  {
    Summary summary = quiet();
    set_figure(summary, key, value);
    return doubts_about(summary, from);
  }

  void
  holds(const std::string &text, const std::string &part, const std::string &name)
  {
    check(text.find(part) != std::string::npos, name + " [" + text + "]");
  }

  /// A peak that is not that of half-spaces under the same force.
  void
  test_peak()
  {
    const SceneInput    input    = scene_from_text("", "driving", {"Wheelset/Traction coefficient = 0.25"});
    const SceneGeometry geometry = require_touching(input);
    Summary             summary  = quiet();
    set_figure(summary, "patch_lateral_m", 14e-3);
    set_figure(summary, "patch_longitudinal_m", 14e-3);
    set_figure(summary, "vertical_force_N", 1e5);
    judge(input.scene, geometry, 40e-3, summary);
    const double halfspaces = get_figure(summary, "halfspace_max_pressure_Pa");
    set_figure(summary, "max_pressure_Pa", halfspaces);
    set_figure(summary, "max_pressure_fitted_Pa", halfspaces);
    check(judge(input.scene, geometry, 40e-3, summary).empty() && summary.doubts.empty(),
          "the peak of half-spaces is trusted");
    set_figure(summary, "plastic_band_depth_m", 5.9e-3); // five cells of 1 mm are fine, and one more
    check(judge(input.scene, geometry, 40e-3, summary).empty(),
          "steel that flows in fine cells is no matter");
    set_figure(summary, "plastic_band_depth_m", 8.6e-3);
    const auto deep = judge(input.scene, geometry, 40e-3, summary);
    holds(deep.empty() ? "" : deep[0],
          "steel has flowed down to 8.6 mm, below the fine cells, which are 5.0 mm deep: the depth of the "
          "band and the "
          "stresses left there are those of coarser cells; raise Mesh/Fine depth to 10 mm",
          "flow below the fine cells");
    check(summary.doubts.empty(), "is said, and leaves the figures of the patch trusted");
    set_figure(summary, "plastic_band_depth_m", std::nan(""));
    set_figure(summary, "max_pressure_Pa", 0.7 * halfspaces);
    set_figure(summary, "max_pressure_fitted_Pa", 0.7 * halfspaces);
    const auto said = judge(input.scene, geometry, 40e-3, summary);
    check(said.size() == 1, "a peak 30 % lower is told once");
    holds(said.empty() ? "" : said[0],
          "the figures should not be trusted: the peak pressure is 30 % below",
          "how");
    holds(summary.doubts, "the peak pressure is 30 % below", "and written into the summary");
  }
} // namespace

int
main()
{
  test_peak();
  check(doubts_about(quiet(), 40e-3).empty(), "a quiet run is trusted");
  check(doubts("normal_force_std_N", 1900).empty(), "so is one whose force swings by 1.9 %");
  holds(doubts("normal_force_std_N", 8500),
        "the normal force swings by 8.5 % of its mean",
        "contact that chatters is doubted, though its energy is in balance");
  holds(
    doubts("max_pressure_fitted_std_Pa", 9e7), "the peak pressure swings by 7.5 %", "noise of the pressure");
  holds(doubts("energy_error", 0.015), "the energy balance is off by 1.5 %", "energy");
  holds(doubts("settled_after_m", 50e-3),
        "not all figures have come within 1 %",
        "means that begin before the run is steady");
  holds(doubts("largest_swing", 0.3),
        "swings by 30.0 % in the means over 2 mm",
        "a figure that goes on swinging");
  check(doubts("settled_after_m", 50e-3, 0).empty(), "not where the means are those of the whole run");
  holds(
    doubts("normal_force_std_N", std::nan("")), "the normal force", "a value that is no number is doubted");
  return report();
}
