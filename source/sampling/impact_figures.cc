#include <wheelrail/output/figures.h>
#include <wheelrail/sampling/impact_figures.h>
#include <wheelrail/sampling/settling.h>

#include <algorithm>
#include <string>

namespace wheelrail
{
  double
  place_of_largest_force(const History &history)
  {
    const auto &force = column(history, "vertical_force");
    return column(history, "rolled_distance")[std::max_element(force.begin(), force.end()) - force.begin()];
  }


  void
  add_impact_figures(const History &history, const double load, Summary &summary)
  {
    constexpr double open    = 1e-3; // of the load
    const auto      *along   = find_column(history, "rolled_distance"),
               *force        = find_column(history, "vertical_force"),
               *acceleration = find_column(history, "axle_acceleration");
    if (!along || !force || force->empty())
      return;
    const auto [least, largest] = std::minmax_element(force->begin(), force->end());
    set_figure(summary, "largest_vertical_force_N", *largest);
    set_figure(summary, "largest_vertical_force_at_m", place_of_largest_force(history));
    set_figure(summary, "least_vertical_force_N", *least);
    set_figure(summary, "least_vertical_force_at_m", (*along)[least - force->begin()]);
    set_figure(summary, "impact_factor", *largest / load);
    double lost = 0;
    for (std::size_t k = 1; k < force->size(); ++k)
      if ((*force)[k] < open * load)
        lost += (*along)[k] - (*along)[k - 1];
    set_figure(summary, "contact_loss_m", lost);
    const auto largest_of = [&](const char *column, const std::string &figure, const std::string &unit) {
      const auto *values = find_column(history, column);
      if (!values)
        return;
      const auto top = std::max_element(values->begin(), values->end());
      set_figure(summary, figure + unit, *top);
      set_figure(summary, figure + "_at_m", (*along)[top - values->begin()]);
    };
    for (const std::string rail : {"first_rail_force", "second_rail_force"})
      largest_of(rail.c_str(), rail, "_N");
    largest_of("max_pressure", "largest_pressure", "_Pa");
    largest_of("max_von_mises", "von_mises_on_way", "_Pa");
    largest_of("max_plastic_strain", "plastic_strain_on_way", "");
    if (acceleration)
      {
        const auto [down, up] = std::minmax_element(acceleration->begin(), acceleration->end());
        set_figure(summary, "axle_acceleration_up_m_per_s2", *up);
        set_figure(summary, "axle_acceleration_down_m_per_s2", -*down);
      }
  }


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
