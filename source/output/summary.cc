#include <wheelrail/base/errors.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/summary.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace wheelrail
{
  namespace
  {
    /// How a figure is called in the file and how it is shown: label, unit and factor from SI; a figure
    /// without a label is not shown. Counts are whole numbers.
    struct Figure
    {
      const char *key;
      double Summary::*value;
      const char      *label;
      const char      *unit;
      double           factor;
      int              decimals;
      bool             count;
    };

    const std::array<Figure, 28> figures = {
      {{"normal_force_N", &Summary::normal_force, "normal force", "kN", 1e-3, 2, false},
       {"vertical_force_N", &Summary::vertical_force, "vertical force", "kN", 1e-3, 2, false},
       {"longitudinal_force_N",
        &Summary::longitudinal_force,
        "longitudinal force on the wheel",
        "kN",
        1e-3,
        2,
        false},
       {"lateral_force_N", &Summary::lateral_force, "lateral force on the wheel", "kN", 1e-3, 2, false},
       {"max_pressure_Pa", &Summary::max_pressure, "peak pressure", "MPa", 1e-6, 1, false},
       {"max_pressure_fitted_Pa",
        &Summary::max_pressure_fitted,
        "peak pressure, fitted",
        "MPa",
        1e-6,
        1,
        false},
       {"contact_area_m2", &Summary::contact_area, "contact area", "mm2", 1e6, 1, false},
       {"patch_lateral_m", &Summary::patch_lateral, "patch across the rail", "mm", 1e3, 2, false},
       {"patch_longitudinal_m", &Summary::patch_longitudinal, "patch along the rail", "mm", 1e3, 2, false},
       {"patch_centre_lateral_m",
        &Summary::patch_centre_lateral,
        "patch centre, lateral",
        "mm",
        1e3,
        2,
        false},
       {"patch_centre_longitudinal_m",
        &Summary::patch_centre_longitudinal,
        "patch centre, ahead of the axle",
        "mm",
        1e3,
        2,
        false},
       {"max_shear_traction_Pa", &Summary::max_shear_traction, "peak shear traction", "MPa", 1e-6, 1, false},
       {"stick_fraction", &Summary::stick_fraction, "sticking part of the patch", "%", 1e2, 1, false},
       {"creepage", &Summary::creepage, "creepage", "1e-3", 1e3, 3, false},
       {"friction_coefficient", &Summary::friction_coefficient, "friction coefficient", "", 1, 3, false},
       {"max_von_mises_Pa", &Summary::max_von_mises, "largest von Mises stress", "MPa", 1e-6, 1, false},
       {"max_plastic_strain", &Summary::max_plastic_strain, "largest plastic strain", "1e-3", 1e3, 3, false},
       {"max_residual_von_mises_Pa",
        &Summary::max_residual_von_mises,
        "largest residual von Mises stress",
        "MPa",
        1e-6,
        1,
        false},
       {"rolled_distance_m", &Summary::rolled_distance, "rolled distance", "mm", 1e3, 1, false},
       {"velocity_m_per_s", &Summary::velocity, "velocity", "km/h", 3.6, 1, false},
       {"elements", &Summary::elements, "elements", "", 1, 0, true},
       {"time_steps", &Summary::time_steps, "time steps", "", 1, 0, true},
       {"time_step_s", &Summary::time_step, "time step", "ns", 1e9, 2, false},
       {"element_updates_per_second",
        &Summary::element_updates_per_second,
        "element updates per second",
        "million",
        1e-6,
        2,
        false},
       {"energy_error", &Summary::energy_error, "energy error", "%", 1e2, 3, false},
       {"wall_time_s", &Summary::wall_time, "wall time", "s", 1, 1, false},
       {"peak_memory_bytes", &Summary::peak_memory, "peak memory, all ranks", "MB", 1e-6, 0, true},
       {"ranks", &Summary::ranks, "ranks", "", 1, 0, true}}};

    nlohmann::ordered_json
    to_json(const double value, const bool count)
    {
      if (!std::isfinite(value))
        return nullptr;
      if (count)
        return static_cast<std::int64_t>(std::llround(value));
      return value;
    }

    void
    print_line(std::ostream      &stream,
               const std::string &label,
               const std::string &value,
               const std::string &unit)
    {
      stream << "  " << label << std::string(label.size() < 36 ? 36 - label.size() : 1, ' ')
             << std::string(value.size() < 12 ? 12 - value.size() : 0, ' ') << value
             << (unit.empty() ? "" : " ") << unit << '\n';
    }
  } // namespace

  void
  set_figure(Summary &summary, const std::string &key, const double value)
  {
    for (const Figure &figure : figures)
      if (key == figure.key)
        {
          summary.*figure.value = value;
          return;
        }
    for (auto &figure : summary.further)
      if (figure.first == key)
        {
          figure.second = value;
          return;
        }
    summary.further.emplace_back(key, value);
  }

  double
  get_figure(const Summary &summary, const std::string &key)
  {
    for (const Figure &figure : figures)
      if (key == figure.key)
        return summary.*figure.value;
    for (const auto &figure : summary.further)
      if (figure.first == key)
        return figure.second;
    return Summary::none;
  }

  void
  write_summary(const Summary &summary, const std::string &path)
  {
    nlohmann::ordered_json json;
    json["title"]           = summary.title;
    json["program_version"] = summary.program_version;
    for (const Figure &figure : figures)
      json[figure.key] = to_json(summary.*figure.value, figure.count);
    for (const auto &figure : summary.further)
      json[figure.first] = to_json(figure.second, false);
    json["finished"]        = summary.finished;
    json["stopped_because"] = summary.stop_reason;

    // a title may hold bytes that are no UTF-8; they must not stop a run at its end
    replace_file(path, json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  }

  Summary
  read_summary(const std::string &path)
  {
    const auto json = nlohmann::ordered_json::parse(read_whole_file(path), nullptr, false);
    if (!json.is_object())
      throw RunError("The file \"" + path +
                     "\" is no summary of a run; compute it again with \"./wheelrail run\".");

    Summary summary;
    for (const auto &item : json.items())
      if (item.value().is_number())
        set_figure(summary, item.key(), item.value().get<double>());
      else if (item.value().is_string() && item.key() == "title")
        summary.title = item.value().get<std::string>();
      else if (item.value().is_string() && item.key() == "program_version")
        summary.program_version = item.value().get<std::string>();
      else if (item.value().is_string() && item.key() == "stopped_because")
        summary.stop_reason = item.value().get<std::string>();
      else if (item.value().is_boolean() && item.key() == "finished")
        summary.finished = item.value().get<bool>();
      else if (item.value().is_null())
        set_figure(summary, item.key(), Summary::none);
    return summary;
  }

  void
  print_summary(const Summary &summary, std::ostream &stream)
  {
    if (!summary.title.empty())
      stream << summary.title << '\n';
    for (const Figure &figure : figures)
      {
        const double value = summary.*figure.value * figure.factor;
        if (!std::isfinite(value))
          continue;
        char text[64];
        std::snprintf(text, sizeof(text), "%.*f", figure.decimals, value);
        print_line(stream, figure.label, text, figure.unit);
      }
    for (const auto &figure : summary.further)
      if (std::isfinite(figure.second))
        {
          char text[64];
          std::snprintf(text, sizeof(text), "%.6g", figure.second);
          print_line(stream, figure.first, text, "");
        }
    print_line(stream, "finished", summary.finished ? "yes" : "no", "");
    if (!summary.stop_reason.empty())
      stream << "  " << summary.stop_reason << '\n';
  }
} // namespace wheelrail
