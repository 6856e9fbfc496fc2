#include <wheelrail/application/compared_figures.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/output/figures.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace wheelrail
{
  namespace
  {
    /// What the difference of a figure is held against.
    struct Limit
    {
      double share  = 0; ///< of the value of the half-spaces; 0: no limit
      double amount = 0; ///< by itself [SI]; the wider one of both counts
    };

    /// A figure of the table.
    struct Compared
    {
      const char *name;
      Limit       limit;
    };

    // differences that cells of 1 mm, the penalty and the noise of a run explain, with room of about two
    // (doc/manual/compare.md)
    constexpr Limit load_limit{0.01, 0}; ///< of the lateral force of a straight wheelset: of the load

    /// The figures of the table; the first two are given to the half-spaces.
    const Compared compared[] = {{"vertical_force", {}},
                                 {"longitudinal_force", {}},
                                 {"normal_force", {0.01, 0}},
                                 {"lateral_force", {0.05, 0}},
                                 {"max_pressure", {0.05, 0}},
                                 {"max_pressure_fitted", {}},
                                 {"contact_area", {0.05, 0}},
                                 {"patch_lateral", {0.05, 0}},
                                 {"patch_longitudinal", {0.05, 0}},
                                 {"max_shear_traction", {0.05, 0}},
                                 {"creepage", {0.05, 0.15e-3}},
                                 {"t_gamma", {0.08, 2}},
                                 {"archard_section", {}},
                                 {"archard_depth", {}},
                                 {"stick_fraction", {0, 0.05}},
                                 {"surface_von_mises", {}},
                                 {"von_mises_below_cell", {0.05, 0}},
                                 {"von_mises_below_cell_depth", {0, 0.5e-3}}};

    /// Of a wheelset with yaw besides.
    const Compared compared_with_yaw[] = {{"yaw_moment", {}},
                                          {"reference_creepage", {}},
                                          {"reference_lateral_creepage", {}},
                                          {"reference_spin", {}}};

    /// Of true bodies besides: where they turn and move to is their own result.
    const Compared compared_with_bodies[] = {{"rail_head_lateral", {}},
                                             {"rail_head_roll", {}},
                                             {"wheel_rim_lateral", {}},
                                             {"wheel_rim_roll", {}}};

    bool
    is_given(const std::string &name)
    {
      return name == "vertical_force" || name == "longitudinal_force";
    }

    /// The unit of a difference of two values of a figure, behind a number: " mm", of parts " points".
    std::string
    unit_of_difference(const Figure &figure)
    {
      const std::string unit = figure.unit;
      return unit.empty() ? "" : unit == "%" ? " points" : " " + unit;
    }

    /// A limit as the table shows it, in the unit of the figure: "5 %", "5 % or 0.15 1e-3", "0.5 mm".
    std::string
    limit_text(const Limit &limit, const Figure &figure)
    {
      std::string shown = limit.share > 0 ? text("%g", 100 * limit.share) + " %" : "";
      if (limit.amount > 0)
        shown += (shown.empty() ? "" : " or ") + text("%g", figure.factor * limit.amount) +
                 unit_of_difference(figure);
      return shown;
    }

    /// A difference as the table shows it: in the unit of the figure where its limit is an amount, else over
    /// the value of the half-spaces, or over the load.
    std::string
    difference_text(double amount, double relative, const Limit &limit, bool of_load, const Figure &figure)
    {
      const bool in_units = limit.share == 0 && limit.amount > 0;
      if (!std::isfinite(in_units ? amount : relative))
        return "-";
      if (in_units)
        return text("%+.*f", figure.decimals, figure.factor * amount) + unit_of_difference(figure);
      return text("%+.2f", 100 * relative) + " %" + (of_load ? " of load" : "");
    }

    bool
    has_yaw(const Summary &run)
    {
      return std::isfinite(get_figure(run, "yaw_rad"));
    }

    /// Whether a figure counts over the vertical load: the lateral force of a straight wheelset, which is
    /// small beside it and may be about zero.
    bool
    over_load(const std::string &name, const Summary &run)
    {
      return name == "lateral_force" && !has_yaw(run);
    }

    double
    relative_difference(const double fe, const double hs, const double base)
    {
      return base > 0 ? (fe - hs) / base : Summary::none;
    }

    /// One row on the screen.
    void
    print_row(const std::string &label,
              const char        *unit,
              const std::string &fe,
              const std::string &hs,
              const std::string &difference,
              const std::string &limit,
              std::ostream      &out)
    {
      out << text("  %-40s %-5s %11s %12s %22s  %s\n",
                  label.c_str(),
                  unit,
                  fe.c_str(),
                  hs.c_str(),
                  difference.c_str(),
                  limit.c_str());
    }
  } // namespace


  nlohmann::ordered_json
  json_number(const double value)
  {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
  }


  Comparison
  compare_figures(Summary &run, const Summary &halfspace, const ComparedWith &reference, std::ostream &out)
  {
    Comparison comparison;
    print_row("", "", "finite el.", reference.title, "difference", "limit", out);
    std::vector<Compared> rows(std::begin(compared), std::end(compared));
    if (has_yaw(run))
      rows.insert(rows.end(), std::begin(compared_with_yaw), std::end(compared_with_yaw));
    if (std::isfinite(get_figure(halfspace, "rail_head_roll_rad")))
      rows.insert(rows.end(), std::begin(compared_with_bodies), std::end(compared_with_bodies));
    for (const auto &[name, own_limit] : rows)
      {
        const Figure     &figure = figure_named(name);
        const std::string label  = std::string(figure.label) + (is_given(name) ? " (given)" : "");
        const double      fe = get_figure(run, figure.key()), hs = get_figure(halfspace, figure.key());
        const bool        of_load = over_load(name, run);
        const double difference   = relative_difference(fe, hs, of_load ? run.vertical_force : std::abs(hs));
        const char *const relative_to = of_load ? "load" : "";
        const Limit       limit       = of_load ? load_limit : own_limit;
        const double      off         = of_load ? std::abs(difference) : std::abs(fe - hs);
        const double      most   = of_load ? limit.share : std::max(limit.share * std::abs(hs), limit.amount);
        const bool        beyond = most > 0 && off > most;
        const std::string apart  = difference_text(fe - hs, difference, limit, of_load, figure),
                          bound  = limit_text(limit, figure) + (of_load ? " of load" : "");
        print_row(label,
                  figure.unit,
                  figure.shown(fe),
                  figure.shown(hs),
                  apart,
                  bound + (beyond ? "  beyond" : ""),
                  out);
        if (beyond)
          comparison.beyond.push_back(
            std::string(label).append(" by ").append(apart).append(" (limit ").append(bound).append(")"));
        set_figure(run, reference.figures + figure.key(), hs);
        set_figure(run, std::string(reference.differences) + name, difference);
        comparison.table.push_back({{"key", figure.key()},
                                    {"label", label},
                                    {"unit", figure.unit},
                                    {"factor", figure.factor},
                                    {"decimals", figure.decimals},
                                    {"fe", json_number(fe)},
                                    {"fe_std", json_number(get_figure(run, figure.key("_std")))},
                                    {reference.json, json_number(hs)},
                                    {"relative_difference", json_number(difference)},
                                    {"relative_to", relative_to},
                                    {"difference", apart},
                                    {"limit", bound},
                                    {"beyond", beyond}});
      }
    return comparison;
  }
} // namespace wheelrail
