#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/damage/laws.h>
#include <wheelrail/scene/steels.h>
#include <wheelrail/verdict/measures.h>

#include <algorithm>

namespace wheelrail
{
  double
  Measures::mesh_part() const
  {
    if (!(cells >= 3) || cells_across_peak < 3)
      return none;
    const double patch = 1.3 / (cells * cells), ridge = 0.3 / (cells_across_peak * cells_across_peak);
    // a run of an earlier version knows neither its ridge nor what lies between its nodes
    return -(ridge > patch ? ridge : patch) - (between_nodes > 0 ? between_nodes : 0);
  }


  double
  Measures::lost(const bool held) const
  {
    return (held ? 1 : 2) * (-mesh_part() - (std::isnan(penetration) ? 0 : penalty_part()));
  }


  std::string
  place_in_words(const double x)
  {
    return in_mm(std::round(1e4 * std::abs(x)) / 1e4) + " from the running circle to the " +
           (x < 0 ? "field" : "gauge") + " side";
  }


  std::string
  sliding_note(const double longitudinal_force, const bool carried)
  {
    if (carried)
      return "The whole patch slides: friction just carries what drives or brakes the wheel.";
    return std::string("The whole patch slides: the wheel ") +
           (longitudinal_force < 0 ? "locks" : "spins up") +
           ", since friction does not carry what drives or brakes it.";
  }


  std::string
  steel_doubt(const SteelSettings &scene,
              const double         peak_pressure,
              const double         traction,
              const bool           computed)
  {
    Steel weakest{"", std::numeric_limits<double>::infinity()};
    for (const MaterialData *material : {&scene.rail_material, &scene.wheel_material})
      {
        if (computed && material->yields())
          continue;
        Steel steel{material->steel, yield_strength(*material)};
        if (std::isfinite(material->yield_stress))
          steel.name = text("a yield stress of %.0f MPa", 1e-6 * material->yield_stress);
        else if (!std::isfinite(steel.strength))
          steel = {rail_steels().back().name + ", the hardest listed,", rail_steels().back().strength};
        if (steel.strength < weakest.strength)
          weakest = steel;
      }
    const double limit = shakedown_limit(traction) * weakest.strength / std::sqrt(3.);
    if (!(peak_pressure > limit))
      return "";
    return text("this steel yields: elastic bodies bear %.0f MPa, above the limit of shakedown of ",
                1e-6 * peak_pressure) +
           weakest.name +
           text(" %.0f MPa at a traction of %.2f times the normal force", 1e-6 * limit, traction) +
           "; the pressure of yielding bodies is lower (Rail material/Steel, Yield stress).";
  }


  double
  advised_cell(const double size, const double within, const double wanted)
  {
    return size * std::exp2(-std::max(0., std::ceil(0.5 * std::log2(within / wanted))));
  }


  std::string
  wear_doubt(const Scene &scene, const Summary &run)
  {
    constexpr double good = 8, fair = 3;
    const double     cells = (1 - run.stick_fraction) * run.patch_longitudinal / scene.cell_size;
    if (!(cells < good) || scene.friction.frictionless())
      return "";
    return text("Wear is %s: %.1f cells of ", cells < fair ? "not trusted" : "with care", cells) +
           in_mm(scene.cell_size) +
           " lie across the sliding part of the patch (8 are needed); take that of compare, or smaller "
           "cells.";
  }


  Known
  known_peak(const Summary &run)
  {
    const double low = get_figure(run, "max_pressure_low_Pa"), high = get_figure(run, "max_pressure_high_Pa"),
                 noise  = get_figure(run, "noise_effect_max_pressure"),
                 within = std::max(run.max_pressure - low, high - run.max_pressure) / run.max_pressure;
    if (std::isfinite(within) && !(noise > 0.5 * within))
      return {within, "cells and penalty layer"};
    return {std::isfinite(within) ? within : noise, "measured input"};
  }


  Measures
  measures_of_run(const Scene &scene, const Summary &run)
  {
    const auto figure = [&](const char *key) { return get_figure(run, key); };
    Measures   m;
    m.cells             = std::min(run.patch_lateral, run.patch_longitudinal) / scene.cell_size;
    m.cells_across_peak = figure("cells_across_peak");
    if (figure("patches") > 1) // the extents are those of all together
      m.cells = std::min(m.cells, m.cells_across_peak);
    m.between_nodes = figure("peak_between_nodes");
    m.unsteadiness =
      std::max(figure("vertical_force_std_N"), figure("longitudinal_force_std_N")) / run.vertical_force;
    m.pressure_noise = figure("max_pressure_fitted_std_Pa") / run.max_pressure_fitted;
    m.swing          = figure("largest_swing");
    m.swing_of       = run.largest_swing_of;
    m.drift          = figure("largest_drift");
    m.drift_of       = run.largest_drift_of;
    m.means_from     = figure("means_from_m");
    // a figure that never settles is null in the file
    m.settled_after = figure("settled_after_m");
    if (std::isnan(m.settled_after) && std::isfinite(m.means_from))
      m.settled_after = std::numeric_limits<double>::infinity();
    m.wanted           = scene.wanted_accuracy;
    m.peak             = known_peak(run);
    m.energy_error     = run.energy_error;
    const double share = run.vertical_force / figure("wheel_load_N");
    if (scene.motion == "none" && !scene.irregular())
      m.load_miss = share - 1;
    if (!scene.irregular())
      m.torque_miss = figure("torque_miss");
    else
      {
        m.load_share           = share;
        m.force_at             = figure("largest_vertical_force_at_m");
        m.path_end             = run.rolled_distance;
        m.second_rail_force_at = figure("second_rail_force_at_m");
      }
    if (m.off_rail())
      m.cells = m.cells_across_peak = Measures::none;
    m.peak_pressure = run.max_pressure;
    // what friction carries has no room for a steady creepage, but where it all slides across, as under yaw
    constexpr double just_carried = 0.02; // of the force that the torque asks for
    if (const double asked = scene.traction_coefficient;
        scene.drive == Drive::torque && asked != 0 &&
        (run.stick_fraction < 1e-3 || std::abs(asked) >= scene.friction.at(0)))
      m.slides =
        sliding_note(asked, std::abs(asked) < scene.friction.at(0) && std::abs(m.torque_miss) < just_carried);
    if (run.max_plastic_strain > 0)
      m.plastic_strain = run.max_plastic_strain;
    const double largest = figure("largest_pressure_Pa"), traction = figure("utilised_friction");
    m.yields = steel_doubt(scene,
                           std::max(run.max_pressure, std::isfinite(largest) ? largest : 0),
                           std::isfinite(traction) ? traction : 0,
                           true);
    return m;
  }
} // namespace wheelrail
