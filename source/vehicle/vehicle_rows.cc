#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/vehicle/vehicle_rows.h>

#include <boost/crc.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    /// What the rows give, by which a kept row is known again.
    Json
    given(const MotionFile &motion, const std::size_t row)
    {
      Json json;
      for (std::size_t k = 0; k < motion.columns.size(); ++k)
        json[motion_name(motion.quantities[k])] = motion.columns[k][row];
      return json;
    }

    /// The text of a line with its checksum behind it.
    std::string
    with_sum(const std::string &text)
    {
      boost::crc_32_type sum;
      sum.process_bytes(text.data(), text.size());
      return text + wheelrail::text(" %08x", static_cast<unsigned int>(sum.checksum()));
    }

    /// A line of the file, or null where it is none or its checksum is another: the last one of a call that
    /// was killed may be torn.
    Json
    read_line(const std::string &line)
    {
      const std::string text = line.substr(0, line.rfind(' '));
      const Json        json = line == with_sum(text) ? Json::parse(text, nullptr, false) : Json();
      return json.is_object() ? json : Json();
    }
  } // namespace


  VehicleRows::VehicleRows(std::string path, std::string digest, const MotionFile &motion)
    : motion_(motion)
    , path_(std::move(path))
    , digest_(std::move(digest))
  {
    if (!std::filesystem::exists(path_))
      return;
    std::istringstream lines(read_whole_file(path_));
    std::string        line;
    std::getline(lines, line);
    if (const Json head = read_line(line); head.is_null() || head.value("scene", Json()) != digest_)
      throw InputError(
        "\"" + path_ + "\": rows of " +
        (head.is_null() ? "an unknown scene" : "another scene, or of another version of the program") +
        ", from a call that was interrupted. Set the entries back to continue with them, choose "
        "another Output/Folder, or give --overwrite to start anew.");
    std::map<std::size_t, std::vector<double>> peaks; // of the wheels
    while (std::getline(lines, line))
      if (const Json json = read_line(line); !json.is_null())
        {
          const std::size_t row = json.value("row", motion.rows());
          if (row >= motion.rows() || json.value("given", Json()) != given(motion, row))
            continue;
          kept_[row] = line;
          peaks[row].clear();
          for (const Json &wheel : json.at("wheels"))
            peaks[row].push_back(summary_from_text(wheel.at("figures")).max_pressure);
        }
    for (std::size_t side = 0; !peaks.empty() && side < peaks.begin()->second.size(); ++side)
      {
        std::vector<std::pair<double, std::size_t>> highest;
        for (const auto &[row, of_wheels] : peaks)
          if (of_wheels[side] > 0)
            highest.emplace_back(-of_wheels[side], row);
        std::sort(highest.begin(), highest.end());
        for (std::size_t k = 0; k < std::min(highest.size(), VehicleWheel::rows_with_stresses); ++k)
          solve_again_.insert(highest[k].second);
      }
  }


  bool
  VehicleRows::restore(const std::size_t row, VehicleResult &vehicle) const
  {
    const auto kept = kept_.find(row);
    if (kept == kept_.end() || solve_again_.count(row) > 0)
      return false;
    const Json json = read_line(kept->second);
    for (std::size_t side = 0; side < vehicle.wheels.size(); ++side)
      {
        const Json &wheel                = json.at("wheels").at(side);
        vehicle.wheels[side].rows[row]   = summary_from_text(wheel.at("figures"));
        vehicle.wheels[side].faults[row] = wheel.at("fault");
      }
    if (!vehicle.axle.empty())
      vehicle.axle[row] = summary_from_text(json.at("axle"));
    return true;
  }


  void
  VehicleRows::keep(const std::size_t row, const VehicleResult &vehicle)
  {
    Json json = {{"row", row}, {"given", given(motion_, row)}};
    for (const VehicleWheel &wheel : vehicle.wheels)
      json["wheels"].push_back({{"figures", summary_as_text(wheel.rows[row])}, {"fault", wheel.faults[row]}});
    if (!vehicle.axle.empty())
      json["axle"] = summary_as_text(vehicle.axle[row]);
    const std::string line = with_sum(json.dump(-1, ' ', false, Json::error_handler_t::replace));
    const std::lock_guard<std::mutex> guard(lock_);
    const bool                        first = !std::filesystem::exists(path_);
    // the line feed comes first, so that a torn line harms no other
    append_to_file(path_, (first ? with_sum(Json{{"scene", digest_}}.dump()) : "") + "\n" + line);
    kept_[row] = line;
  }
} // namespace wheelrail
