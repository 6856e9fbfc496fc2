#include <wheelrail/output/figures.h>
#include <wheelrail/sampling/settling.h>
#include <wheelrail/sampling/track_figures.h>

#include <algorithm>
#include <string>

namespace wheelrail
{
  void
  add_track_figures(const History &history, const Range &stretch, Summary &summary)
  {
    if (const auto *deflection = find_column(history, "foot_deflection"))
      set_figure(summary,
                 "foot_deflection_m",
                 mean_over(column(history, "rolled_distance"), *deflection, stretch).mean);
    for (const std::string name : {"largest_pad_force", "largest_pad_pull"})
      if (const auto *values = find_column(history, name))
        set_figure(summary, name + "_N", *std::max_element(values->begin(), values->end()));
  }
} // namespace wheelrail
