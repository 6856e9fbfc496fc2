#include <wheelrail/base/errors.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/wear/wear_files.h>

#include <boost/crc.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    /// A value of a state: its name in tables, its unit, and its place.
    struct Quantity
    {
      const char *name, *unit;
      double &(*of)(WearStep &);
    };

    const std::vector<Quantity> &
    quantities()
    {
      using S                                 = WearStep;
      static const std::vector<Quantity> list = {
        {"passages", "1", [](S &s) -> double & { return s.passages; }},
        {"gross_load_kg", "kg", [](S &s) -> double & { return s.gross_load; }},
        {"distance_m", "m", [](S &s) -> double & { return s.distance; }},
        {"step_depth_m", "m", [](S &s) -> double & { return s.step_depth; }},
        {"rail_depth_m", "m", [](S &s) -> double & { return s.rail_depth; }},
        {"wheel_depth_m", "m", [](S &s) -> double & { return s.wheel_depth; }},
        {"rail_section_m2", "m2", [](S &s) -> double & { return s.rail_section; }},
        {"wheel_section_m2", "m2", [](S &s) -> double & { return s.wheel_section; }},
        {"rail_height_loss_m", "m", [](S &s) -> double & { return s.dimensions.rail_height; }},
        {"rail_side_wear_m", "m", [](S &s) -> double & { return s.dimensions.rail_side; }},
        {"flange_height_m", "m", [](S &s) -> double & { return s.dimensions.flange_height; }},
        {"flange_thickness_m", "m", [](S &s) -> double & { return s.dimensions.flange_thickness; }},
        {"flange_gradient_m", "m", [](S &s) -> double & { return s.dimensions.flange_gradient; }},
        {"equivalent_conicity", "1", [](S &s) -> double & { return s.conicity; }},
        {"mean_peak_pressure_Pa", "Pa", [](S &s) -> double & { return s.mean_pressure; }},
        {"largest_peak_pressure_Pa", "Pa", [](S &s) -> double & { return s.peak_pressure; }},
        {"mean_t_gamma_N", "N", [](S &s) -> double & { return s.mean_t_gamma; }},
        {"largest_t_gamma_N", "N", [](S &s) -> double & { return s.peak_t_gamma; }},
        {"rail_damage", "1", [](S &s) -> double & { return s.rail_damage; }},
        {"wheel_damage", "1", [](S &s) -> double & { return s.wheel_damage; }},
        {"rail_net_cracks", "1", [](S &s) -> double & { return s.rail_cracks; }},
        {"wheel_net_cracks", "1", [](S &s) -> double & { return s.wheel_cracks; }},
        {"rail_ground_section_m2", "m2", [](S &s) -> double & { return s.rail_ground; }},
        {"wheel_turned_section_m2", "m2", [](S &s) -> double & { return s.wheel_turned; }},
        {"halfspace_peak_beyond_bodies_low", "1", [](S &s) -> double & { return s.bodies_low; }},
        {"halfspace_peak_beyond_bodies_high", "1", [](S &s) -> double & { return s.bodies_high; }},
        {"mean_peak_pressure_low_Pa", "Pa", [](S &s) -> double & { return s.pressure_within.low; }},
        {"mean_peak_pressure_high_Pa", "Pa", [](S &s) -> double & { return s.pressure_within.high; }},
        {"mean_t_gamma_low_N", "N", [](S &s) -> double & { return s.t_gamma_within.low; }},
        {"mean_t_gamma_high_N", "N", [](S &s) -> double & { return s.t_gamma_within.high; }},
        {"rail_section_low_m2", "m2", [](S &s) -> double & { return s.rail_within.low; }},
        {"rail_section_high_m2", "m2", [](S &s) -> double & { return s.rail_within.high; }},
        {"wheel_section_low_m2", "m2", [](S &s) -> double & { return s.wheel_within.low; }},
        {"wheel_section_high_m2", "m2", [](S &s) -> double & { return s.wheel_within.high; }},
        {"share_with_care", "1", [](S &s) -> double & { return s.with_care; }},
        {"share_not_trusted", "1", [](S &s) -> double & { return s.not_trusted; }}};
      return list;
    }

    Json
    as_json(const WornShape &shape)
    {
      Json json{{"depth", shape.depth},
                {"damage", shape.damage},
                {"cracks", shape.cracks},
                {"steel_on_left", shape.steel_on_left}};
      for (const Point2 &p : shape.points)
        {
          json["x"].push_back(p.x);
          json["y"].push_back(p.y);
        }
      return json;
    }

    std::string
    checksum(const std::string &text)
    {
      boost::crc_32_type sum;
      sum.process_bytes(text.data(), text.size());
      return std::to_string(sum.checksum());
    }

    WornShape
    shape_from(const Json &json)
    {
      WornShape shape{{}, json.at("depth"), json.at("damage"), json.at("cracks"), json.at("steel_on_left")};
      for (std::size_t k = 0; k < shape.depth.size(); ++k)
        shape.points.push_back({json.at("x").at(k), json.at("y").at(k)});
      return shape;
    }
  } // namespace


  std::string
  wear_state_as_text(const WearState &state, const std::string &digest)
  {
    const Verdict verdict = wear_verdict(state);
    Json          json{{"scene", digest},
              {"finished", state.finished},
              {"verdict", grade_word(verdict.grade())},
              {"doubts", verdict.doubts()},
              {"worst_row", state.doubts},
              {"note", state.note},
              {"beside_bodies", beside_bodies(state)},
              {"passages", state.passages},
              {"rail_ground", state.rail_ground},
              {"wheel_turned", state.wheel_turned},
              {"grindings", state.grindings},
              {"turnings", state.turnings},
              {"new_rail", as_json(state.new_rail)},
              {"new_wheel", as_json(state.new_wheel)},
              {"rail", as_json(state.rail)},
              {"wheel", as_json(state.wheel)}};
    for (WearStep step : state.steps)
      for (const Quantity &quantity : quantities()) // JSON has null for what is no number
        json["steps"][quantity.name].push_back(quantity.of(step));
    json["checksum"] = checksum(json.dump());
    return json.dump() + "\n";
  }


  std::optional<KeptWear>
  read_wear_state(const std::string &path)
  {
    if (!std::filesystem::exists(path))
      return {};
    const InputError damaged(
      "\"" + path +
      "\": damaged, so that it cannot be resumed. Choose another Output/Folder, or give "
      "--overwrite to start anew.");
    try
      {
        Json              json = Json::parse(read_whole_file(path));
        const std::string sum  = json.at("checksum");
        json.erase("checksum");
        if (checksum(json.dump()) != sum)
          throw damaged;
        WearState state{shape_from(json.at("new_rail")),
                        shape_from(json.at("new_wheel")),
                        shape_from(json.at("rail")),
                        shape_from(json.at("wheel")),
                        json.at("passages"),
                        json.at("rail_ground"),
                        json.at("wheel_turned"),
                        json.at("grindings"),
                        json.at("turnings"),
                        {},
                        json.at("finished"),
                        json.at("worst_row"),
                        json.at("note")};
        state.steps.resize(json.at("steps").at("passages").size());
        for (const Quantity &quantity : quantities())
          for (std::size_t k = 0; k < state.steps.size(); ++k)
            {
              const Json &value           = json.at("steps").at(quantity.name).at(k);
              quantity.of(state.steps[k]) = value.is_null() ? std::nan("") : value.get<double>();
            }
        return KeptWear{json.at("scene"), std::move(state)};
      }
    catch (const Json::exception &)
      {
        throw damaged;
      }
  }


  FigureTable
  wear_table(const WearState &state)
  {
    FigureTable table;
    for (const Quantity &quantity : quantities())
      {
        std::vector<double> column;
        for (WearStep step : state.steps)
          column.push_back(quantity.of(step));
        table.add(quantity.name, quantity.unit, std::move(column));
      }
    return table;
  }
} // namespace wheelrail
