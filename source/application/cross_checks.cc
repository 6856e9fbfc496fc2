#include <wheelrail/application/cross_checks.h>
#include <wheelrail/application/entries.h>
#include <wheelrail/base/quantity.h>

#include <cmath>
#include <cstdio>

namespace wheelrail
{
  namespace
  {
    using Sentences = std::vector<std::string>;

    std::string
    mm(const double length)
    {
      // six digits: a sum of user values shows no rounding noise
      return format_number(std::round(length * 1e9) / 1e6) + " mm";
    }

    /// Three digits of a number that was computed.
    std::string
    digits(const double value)
    {
      char out[32];
      std::snprintf(out, sizeof(out), "%.3g", value);
      return out;
    }

    /// "Section/Name = value" as in the listing.
    std::string
    entry_text(const Scene &scene, const std::string &section, const std::string &name)
    {
      return section + "/" + name + " = " + find_entry(section, name)->get(scene);
    }

    void
    check_distances(const Scene &scene, Sentences &found)
    {
      // the patch is about 13 mm long and the stress field below it some 50 mm
      constexpr double clear_end = 0.1;
      const double     needed    = scene.rolling_distance + 2 * clear_end;
      if (needed > scene.rail_length * (1 + 1e-12))
        found.push_back(entry_text(scene, "Run", "Rolling distance") + ": with " + mm(clear_end) +
                        " of free rail at each end this needs a rail of " + mm(needed) +
                        ", and Track/Rail length is " + mm(scene.rail_length) + "; roll at most " +
                        mm(std::max(0., scene.rail_length - 2 * clear_end)) + " or lengthen the rail");
      if (scene.averaging_distance > scene.rolling_distance)
        found.push_back(entry_text(scene, "Run", "Averaging distance") +
                        ": longer than Run/Rolling distance = " + mm(scene.rolling_distance) +
                        "; the mean is taken over the last part of the run, so at most that is possible");
      const double spacing = scene.rolling_distance / scene.ticks;
      if (spacing < 0.5 * scene.cell_size)
        found.push_back(
          entry_text(scene, "Output", "Ticks") + ": one output every " + mm(spacing) +
          " of rolling, which is less than half a cell (" + mm(scene.cell_size) +
          "), shows nothing new; at most " +
          std::to_string(std::max(1, static_cast<int>(2 * scene.rolling_distance / scene.cell_size))) +
          " are accepted");
    }

    void
    check_cells(const Scene &scene, Sentences &found)
    {
      constexpr double largest_cell = 4e-3;
      if (scene.cell_size > largest_cell)
        found.push_back(
          entry_text(scene, "Mesh", "Solution cell size") +
          ": too coarse; a patch is about 13 mm long and needs more than three cells, so at most " +
          mm(largest_cell) + " is accepted, and 1 mm for figures that can be trusted");
      const double levels  = std::log2(scene.coarse_cell_size / scene.cell_size);
      const double nearest = std::max(0., std::round(levels));
      if (std::abs(levels - nearest) > 0.15)
        found.push_back(
          entry_text(scene, "Mesh", "Coarse cell size") + ": " +
          format_number(std::round(100 * scene.coarse_cell_size / scene.cell_size) / 100) +
          " times the solution cell size of " + mm(scene.cell_size) +
          "; cells are halved from coarse to fine, so the ratio must be about 1, 2, 4, 8, 16, ...: take " +
          mm(scene.cell_size * std::exp2(nearest)));
      if (scene.fine_depth < 2 * scene.cell_size)
        found.push_back(entry_text(scene, "Mesh", "Fine depth") + ": less than two cells of " +
                        mm(scene.cell_size) + "; write auto or at least " + mm(2 * scene.cell_size));
      if (scene.fine_margin < scene.cell_size)
        found.push_back(entry_text(scene, "Mesh", "Fine margin") + ": less than one cell of " +
                        mm(scene.cell_size) + "; at least that is needed around the patch");
    }

    void
    check_wheel(const Scene &scene, Sentences &found)
    {
      const WheelDimensions &wheel = scene.wheel;
      // the flange needs no room inwards; the rim must keep a ring of metal below the tread
      constexpr double least_rim = 0.02;
      const auto       inside =
        [&](const char *inner, const char *outer, const double least_gap, const double gap) {
          if (gap < least_gap)
            found.push_back(entry_text(scene, "Wheelset", inner) + ": must be at least " + mm(least_gap) +
                            " smaller than " + entry_text(scene, "Wheelset", outer) +
                            "; the order from the axle outwards is bore, hub, rim, running circle");
        };
      inside("Bore radius", "Hub outer radius", 0.01, wheel.hub_outer_radius - wheel.bore_radius);
      inside("Hub outer radius", "Rim inner radius", 0.01, wheel.rim_inner_radius - wheel.hub_outer_radius);
      inside("Rim inner radius",
             "Nominal rolling radius",
             least_rim,
             wheel.nominal_radius - wheel.rim_inner_radius);

      const auto holds =
        [&](
          const char *part, const char *position, const double middle, const double low, const double high) {
          if (middle - wheel.disc_thickness / 2 < low - 1e-12 ||
              middle + wheel.disc_thickness / 2 > high + 1e-12)
            found.push_back(entry_text(scene, "Wheelset", position) + ": the disc (" +
                            mm(wheel.disc_thickness) + " thick) reaches beyond the " + part +
                            ", which lies from " + mm(low) + " to " + mm(high) + " off the flange back");
        };
      holds("rim", "Disc position", wheel.disc_position, 0, wheel.rim_width);
      holds("hub",
            "Disc position",
            wheel.disc_position,
            wheel.hub_position - wheel.hub_length / 2,
            wheel.hub_position + wheel.hub_length / 2);
      if (scene.track.flange_back_distance >= scene.track.gauge)
        found.push_back(entry_text(scene, "Wheelset", "Flange back distance") + ": not smaller than " +
                        entry_text(scene, "Track", "Gauge") +
                        "; the flanges run between the rails, with 1435 mm the distance is about 1360 mm");
    }

    void
    check_materials(const Scene &scene, Sentences &found)
    {
      const auto check = [&](const std::string &section, const MaterialData &material) {
        if (material.tangent_modulus >= material.youngs_modulus)
          found.push_back(entry_text(scene, section, "Tangent modulus") + ": not smaller than " +
                          entry_text(scene, section, "Young's modulus") +
                          "; beyond yield the stress rises less than before");
      };
      check("Rail material", scene.rail_material);
      check("Wheel material", scene.wheel_material);
    }
  } // namespace

  std::vector<std::string>
  cross_checks(const Scene &scene)
  {
    Sentences found;
    check_wheel(scene, found);
    check_materials(scene, found);
    check_cells(scene, found);
    check_distances(scene, found);
    return found;
  }

  std::vector<std::string>
  scene_notes(const Scene &scene)
  {
    Sentences notes;
    if (scene.drive == Drive::torque && std::abs(scene.traction_coefficient) >= scene.friction_coefficient &&
        scene.traction_coefficient != 0)
      notes.push_back(entry_text(scene, "Wheelset", "Traction coefficient") + ": friction carries at most " +
                      entry_text(scene, "Contact", "Friction coefficient") +
                      ", so the whole patch slides and the wheel " +
                      (scene.traction_coefficient > 0 ? "spins up" : "locks") + " while it rolls");
    const MaterialData &m         = scene.rail_material;
    const double        impedance = std::sqrt(m.density * m.youngs_modulus / (2 + 2 * m.poissons_ratio));
    if (1e9 * steepest_fall(friction_law(scene)) > impedance / 2)
      notes.push_back(
        entry_text(scene, "Contact", "Friction law") + ": friction falls by " +
        digits(steepest_fall(friction_law(scene))) + " per m/s of sliding; at 1 GPa a fall beyond " +
        digits(impedance / 2e9) +
        " feeds sliding more than shear waves carry away, and tractions oscillate from node to node");
    if (scene.friction_law != FrictionKind::constant && scene.friction_coefficient == 0)
      notes.push_back(entry_text(scene, "Contact", "Friction coefficient") +
                      ": 0 at rest, but not at speed with Contact/Friction law = " +
                      (scene.friction_law == FrictionKind::rational ? "rational" : "exponential"));
    if (scene.drive == Drive::torque && scene.creepage != 0)
      notes.push_back(entry_text(scene, "Wheelset", "Creepage") +
                      ": without effect, since Wheelset/Drive = torque");
    return notes;
  }
} // namespace wheelrail
