#include <wheelrail/output/figures.h>
#include <wheelrail/sampling/patch_measures.h>
#include <wheelrail/sampling/recorder.h>
#include <wheelrail/sampling/settling.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Adds one row to a table, value by value; the first row makes the columns.
    class Row
    {
    public:
      explicit Row(History &table)
        : table_(table)
      {
      }

      /// A quantity that is a figure of the summary too; pure numbers have the unit 1.
      void
      put(const std::string &figure, const double value)
      {
        const std::string si = figure_named(figure).si;
        put(figure, si.empty() ? "1" : si, value);
      }

      void
      put(const std::string &name, const std::string &unit, const double value)
      {
        if (column_ == table_.columns.size())
          {
            table_.names.push_back(name);
            table_.units.push_back(unit);
            table_.columns.emplace_back();
          }
        table_.columns[column_++].push_back(value);
      }

    private:
      History    &table_;
      std::size_t column_ = 0;
    };

    const std::vector<double> &
    column(const History &table, const std::string &name)
    {
      for (std::size_t c = 0; c < table.names.size(); ++c)
        if (table.names[c] == name)
          return table.columns[c];
      throw std::logic_error("no history column " + name);
    }
  } // namespace


  Recorder::Recorder(const Model &model)
    : model_(model)
  {
  }


  void
  Recorder::add(const Rolling &rolling, const Axle &axle)
  {
    const ContactSums &c = rolling.contact_sums();
    const EnergyBook  &e = rolling.energy();
    const Point2       t = model_.geometry.frame.tangent(), n = model_.geometry.frame.normal();
    Row                row(state_.history);
    row.put("time", "s", rolling.time());
    row.put("rolled_distance", axle.travelled());
    row.put("normal_force", c.force[0] * n.x + c.force[1] * n.y);
    row.put("vertical_force", c.force[1]);
    row.put("longitudinal_force", c.force[2]);
    row.put("lateral_force", c.force[0]);
    row.put("tangential_lateral_force", "N", c.force[0] * t.x + c.force[1] * t.y);
    row.put("axle_lateral_force", "N", axle.reaction()[0]);
    row.put("axle_vertical_force", "N", axle.reaction()[1]);
    row.put("max_pressure", c.largest_pressure);
    const double radius = model_.geometry.rolling_radius, V = axle.data().velocity;
    row.put("creepage", (axle.pitch_rate() * radius - V) / V);
    row.put("pitch_rate", "rad/s", axle.pitch_rate());
    row.put("drive_torque", "N m", axle.applied_torque());
    row.put("axle_height", "m", axle.height());
    for (const EnergyTerm &term : e.terms())
      row.put(term.name, "J", term.value);
    row.put("energy_residual", "J", e.residual());
    row.put("energy_error", e.error());
  }


  void
  Recorder::add_patch(const PatchFields &patch)
  {
    const PatchMeasures m = measure_patch(patch);
    Row                 row(state_.patches);
    row.put("rolled_distance", patch.rolled_distance);
    row.put("max_pressure", m.peak_pressure);
    row.put("max_pressure_fitted", m.peak_pressure_fitted);
    row.put("contact_area", m.area);
    row.put("patch_lateral", m.width);
    row.put("patch_longitudinal", m.length);
    row.put("patch_centre_lateral", m.centre_lateral);
    row.put("patch_centre_longitudinal", m.centre_along);
    row.put("max_shear_traction", m.max_traction);
    row.put("stick_fraction", m.stick_fraction);
    n_patches_ = m.n_patches;
  }


  void
  Recorder::fill(Summary &summary, const double distance) const
  {
    const History &history = state_.history, &patches = state_.patches;
    if (history.columns.empty())
      return;
    const auto  &rolled   = column(history, "rolled_distance");
    const double from     = rolled.back() - distance;
    const auto   put_mean = [&](const std::string &name, const Mean &mean) {
      const Figure &figure = figure_named(name);
      set_figure(summary, figure.key(), mean.mean);
      set_figure(summary, figure.key("_std"), mean.deviation);
    };
    for (const char *name :
         {"normal_force", "vertical_force", "longitudinal_force", "lateral_force", "creepage"})
      put_mean(name, mean_from(rolled, column(history, name), from));
    set_figure(summary, "energy_error", column(history, "energy_error").back());
    const auto &patch_rolled = column(patches, "rolled_distance");
    for (std::size_t c = 1; c < patches.names.size(); ++c)
      put_mean(patches.names[c], mean_from(patch_rolled, patches.columns[c], from));

    if (n_patches_ > 0)
      set_figure(summary, "patches", n_patches_);

    // within 1 % of the mean over 2 mm, which takes out what repeats from cell to cell (cells of 1 mm); where
    // a force or traction is hardly there, 5 % of what presses counts in place of its mean
    const auto settled = [&](const History &table, const char *name, const char *pressing) {
      const auto  &along = column(table, "rolled_distance"), &values = column(table, name);
      const double final = mean_from(along, values, from).mean;
      const double least = 0.05 * mean_from(along, column(table, pressing), from).mean;
      return settled_after(along, values, final, 0.01 * std::max(std::abs(final), least), 2e-3);
    };
    set_figure(summary,
               "settled_after_m",
               std::max(settled(history, "longitudinal_force", "normal_force"),
                        settled(patches, "max_shear_traction", "max_pressure")));
  }
} // namespace wheelrail
