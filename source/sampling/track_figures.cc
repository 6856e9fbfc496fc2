#include <wheelrail/output/figures.h>
#include <wheelrail/sampling/settling.h>
#include <wheelrail/sampling/track_figures.h>

#include <algorithm>
#include <string>
#include <vector>

namespace wheelrail
{
  void
  add_track_figures(const History &history, const Range &stretch, Summary &summary)
  {
    const auto has = [&](const char *name) {
      return std::find(history.names.begin(), history.names.end(), name) != history.names.end();
    };
    if (!has("foot_deflection"))
      return;
    set_figure(
      summary,
      "foot_deflection_m",
      mean_over(column(history, "rolled_distance"), column(history, "foot_deflection"), stretch).mean);
    if (!has("largest_pad_force"))
      return;
    for (const std::string name : {"largest_pad_force", "largest_pad_pull"})
      {
        const std::vector<double> &values = column(history, name);
        set_figure(summary, name + "_N", *std::max_element(values.begin(), values.end()));
      }
  }
} // namespace wheelrail
