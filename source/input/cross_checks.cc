#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/input/cross_checks.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/model.h>
#include <wheelrail/model/scene_geometry.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

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

    /// `value` to two digits: what is estimated should look so.
    std::string
    about(const double value)
    {
      char out[32];
      std::snprintf(out, sizeof(out), "%.1e", value);
      return format_number(std::strtod(out, nullptr));
    }

    /// A number of things: 97000, 17 million.
    std::string
    about_count(const double value)
    {
      return value < 1e6 ? about(value) : about(1e-6 * value) + " million";
    }

    void
    check_distances(const Scene &scene, const std::optional<ExpectedPatch> &patch, Sentences &found)
    {
      // the stress field below a patch of 13 mm reaches some 50 mm; the rail needs a few coarse cells
      // beyond the fine ones
      const double reach = patch ? 0.7 * patch->length : 0;
      const double needed =
        std::max(0.1, std::ceil(1e3 * (reach + scene.fine_margin + 3 * scene.coarse_cell_size)) / 1e3);
      const double length = scene.mesh_distance() + 2 * needed;
      if (length > scene.rail_length * (1 + 1e-12))
        found.push_back((scene.prepared_distance > 0 ? entry_text(scene, "Mesh", "Prepared distance")
                                                     : entry_text(scene, "Run", "Rolling distance")) +
                        ": with " + mm(needed) + " of free rail at each end this needs a rail of " +
                        mm(length) + ", and Track/Rail length is " + mm(scene.rail_length) + "; " +
                        (scene.rail_length > 2 * needed
                           ? "roll at most " + mm(scene.rail_length - 2 * needed) + " or lengthen the rail"
                           : "lengthen the rail"));
      if (scene.mesh_distance() < scene.rolling_distance)
        found.push_back(entry_text(scene, "Mesh", "Prepared distance") + ": shorter than " +
                        entry_text(scene, "Run", "Rolling distance") +
                        "; write auto, or a longer distance for a run that is to be resumed with more");
      if (scene.averaging_distance > scene.rolling_distance)
        found.push_back(entry_text(scene, "Run", "Averaging distance") +
                        ": longer than Run/Rolling distance = " + mm(scene.rolling_distance) +
                        "; the mean is taken over the last part of the run, so at most that is possible");
      const double spacing = scene.rolling_distance / scene.ticks;
      if (spacing < 0.1 * scene.cell_size)
        found.push_back(
          entry_text(scene, "Output", "Ticks") + ": one output every " + mm(spacing) +
          " of rolling, which is less than a tenth of a cell (" + mm(scene.cell_size) +
          "), shows nothing new; at most " +
          std::to_string(std::max(1, static_cast<int>(10 * scene.rolling_distance / scene.cell_size))) +
          " are accepted");
    }

    /// Steps of the explicit scheme: the step is a little less than the time a pressure wave takes
    /// through a solution cell.
    void
    check_steps(const Scene &scene, Sentences &warnings)
    {
      double fastest = 0;
      for (const MaterialData &m : {scene.rail_material, scene.wheel_material})
        fastest = std::max(fastest,
                           std::sqrt(m.youngs_modulus * (1 - m.poissons_ratio) /
                                     ((1 + m.poissons_ratio) * (1 - 2 * m.poissons_ratio) * m.density)));
      const double step  = 0.9 * scene.time_step_factor * scene.cell_size / fastest;
      const double steps = scene.rolling_distance / scene.velocity / step;
      if (steps > 2e6)
        warnings.push_back(entry_text(scene, "Run", "Rolling distance") + ": takes about " +
                           about_count(steps) + " time steps at " +
                           entry_text(scene, "Wheelset", "Velocity") + ", " +
                           entry_text(scene, "Mesh", "Solution cell size") + " and " +
                           entry_text(scene, "Run", "Time step factor") +
                           ", days of computing; a higher speed or a shorter distance takes less");
    }

    void
    check_patch(const Scene &scene, const ExpectedPatch &patch, Findings &found)
    {
      const double      smallest = std::min(patch.length, patch.width);
      const std::string size     = "a patch of about " + about(1e3 * patch.width) + " mm x " +
                               about(1e3 * patch.length) + " mm (width x length) is expected";
      if (scene.cell_size > patch.length / 3)
        found.errors.push_back(entry_text(scene, "Mesh", "Solution cell size") + ": too coarse; " + size +
                               " and needs three cells in length, so at most " +
                               mm(std::floor(1e4 * patch.length / 3) / 1e4) +
                               " is accepted, and a tenth of the patch for figures that can be trusted");
      else if (scene.cell_size > smallest / 6)
        found.warnings.push_back(entry_text(scene, "Mesh", "Solution cell size") + ": coarse; " + size +
                                 ", which is less than six cells in one direction, so the peak pressure "
                                 "will be some 10 % or more off; take " +
                                 mm(std::max(1e-4, std::floor(1e4 * smallest / 10) / 1e4)) + " for figures");
    }

    void
    check_cells(const Scene &scene, Sentences &found)
    {
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

    std::string
    gigabytes(const double bytes)
    {
      return about(1e-9 * bytes) + " GB";
    }

    /// Cells against what indices and memory hold, ranks against cores.
    void
    check_size(const Scene &scene, const ExpectedPatch &patch, const Machine &machine, Findings &found)
    {
      constexpr double  most_elements = 5e7; // the unknowns of the static start are counted in 32 bits
      const double      elements      = expected_elements(scene, patch);
      const double      memory        = expected_memory(elements, machine.ranks);
      const std::string advice =
        "; take larger cells, a shorter rolling distance or a smaller fine depth or margin";
      const std::string need = entry_text(scene, "Mesh", "Solution cell size") + ": with " +
                               entry_text(scene, "Mesh", "Coarse cell size") + " this makes about " +
                               about_count(elements) + " cells";
      if (elements > most_elements)
        found.errors.push_back(need + ", and " + about_count(most_elements) + " are possible" + advice);
      else if (machine.memory > 0 && memory > 2 * machine.memory)
        found.errors.push_back(need + " and needs some " + gigabytes(memory) +
                               " of memory, this machine has " + gigabytes(machine.memory) + advice);
      else if (machine.free > 0 && memory > machine.free)
        found.warnings.push_back(need + " and may need some " + gigabytes(memory) + " of memory, " +
                                 gigabytes(machine.free) + " are free" + advice);
      if (machine.cores > 0 && machine.ranks > machine.cores)
        found.warnings.push_back(
          "--ranks " + std::to_string(machine.ranks) + ": more than the " + std::to_string(machine.cores) +
          " cores of this machine; ranks that wait for each other take turns, which is "
          "slower than fewer ranks");
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
    check_material(const Scene        &scene,
                   const std::string  &section,
                   const MaterialData &material,
                   Findings           &found)
    {
      const auto entry = [&](const char *name) { return entry_text(scene, section, name); };
      if (material.tangent_modulus >= material.youngs_modulus)
        found.errors.push_back(entry("Tangent modulus") + ": not smaller than " + entry("Young's modulus") +
                               "; beyond yield the stress rises less than before");
      if (material.youngs_modulus < 50e9 || material.youngs_modulus > 400e9)
        found.warnings.push_back(entry("Young's modulus") + ": steel has about 210 GPa");
      if (material.density < 2000 || material.density > 12000)
        found.warnings.push_back(entry("Density") + ": steel has about 7900 kg/m3");
      if (material.poissons_ratio > 0.45)
        found.warnings.push_back(
          entry("Poisson's ratio") +
          ": nearly incompressible; steel has about 0.3, and the stable time step falls "
          "to zero towards 0.5");
    }

    void
    check_drive(const Scene &scene, Sentences &warnings)
    {
      if (scene.drive == Drive::torque &&
          std::abs(scene.traction_coefficient) >= scene.friction_coefficient &&
          scene.traction_coefficient != 0)
        warnings.push_back(entry_text(scene, "Wheelset", "Traction coefficient") +
                           ": friction carries at most " +
                           entry_text(scene, "Contact", "Friction coefficient") +
                           ", so the whole patch slides and the wheel " +
                           (scene.traction_coefficient > 0 ? "spins up" : "locks") + " while it rolls");
      const MaterialData &m         = scene.rail_material;
      const double        impedance = std::sqrt(m.density * m.youngs_modulus / (2 + 2 * m.poissons_ratio));
      if (1e9 * steepest_fall(friction_law(scene)) > impedance / 2)
        warnings.push_back(
          entry_text(scene, "Contact", "Friction law") + ": friction falls by " +
          digits(steepest_fall(friction_law(scene))) + " per m/s of sliding; at 1 GPa a fall beyond " +
          digits(impedance / 2e9) +
          " feeds sliding more than shear waves carry away, and tractions oscillate from node to node");
      if (scene.friction_law != FrictionKind::constant && scene.friction_coefficient == 0)
        warnings.push_back(entry_text(scene, "Contact", "Friction coefficient") +
                           ": 0 at rest, but not at speed with Contact/Friction law = " +
                           (scene.friction_law == FrictionKind::rational ? "rational" : "exponential"));
      if (scene.drive == Drive::torque && scene.creepage != 0)
        warnings.push_back(entry_text(scene, "Wheelset", "Creepage") +
                           ": without effect, since Wheelset/Drive = torque");
      if (scene.sprung_mass < 100)
        warnings.push_back(entry_text(scene, "Wheelset", "Sprung mass") +
                           ": next to nothing presses the wheel on the rail; a railway vehicle has some 10 t "
                           "per wheel");
    }

    /// Whether blocks of the wanted size fit into both sections: lays them out, which takes 20 ms.
    void
    check_sections(const Scene &scene, const SceneGeometry &geometry, Sentences &errors)
    {
      // with very many blocks that would take long; smaller ones fit better than large ones
      if (scene.coarse_cell_size < 4e-3)
        return;
      try
        {
          sweep_plan(scene, geometry);
        }
      catch (const std::exception &error)
        {
          errors.push_back(entry_text(scene, "Mesh", "Coarse cell size") +
                           ": rail and wheel cannot be divided into cells at " +
                           entry_text(scene, "Wheelset", "Lateral shift") + ": " + error.what());
        }
    }

    /// The profiles in touch; nothing, and an error, when they cannot be read or do not touch.
    std::optional<SceneGeometry>
    find_geometry(const Scene &scene, Sentences &errors)
    {
      SceneProfiles profiles;
      try
        {
          profiles = read_profiles(scene);
        }
      catch (const InputError &error) // it names its entry
        {
          errors.push_back(error.what());
          return {};
        }
      try
        {
          return make_geometry(scene, std::move(profiles));
        }
      catch (const InputError &error)
        {
          errors.push_back(entry_text(scene, "Wheelset", "Lateral shift") + ": " + error.what());
          return {};
        }
    }
  } // namespace

  Findings
  cross_checks(const Scene &scene, const Machine &machine)
  {
    Findings found;
    check_wheel(scene, found.errors);
    check_material(scene, "Rail material", scene.rail_material, found);
    check_material(scene, "Wheel material", scene.wheel_material, found);
    check_cells(scene, found.errors);
    check_drive(scene, found.warnings);
    check_steps(scene, found.warnings);
    // what follows from a wrong track or wheel would only be said twice
    const std::optional<SceneGeometry> geometry =
      found.errors.empty() ? find_geometry(scene, found.errors) : std::optional<SceneGeometry>();
    std::optional<ExpectedPatch> patch;
    if (geometry)
      {
        patch = expected_patch(scene, *geometry);
        check_patch(scene, *patch, found);
        check_size(scene, *patch, machine, found);
      }
    check_distances(scene, patch, found.errors);
    if (geometry && found.errors.empty())
      check_sections(scene, *geometry, found.errors);
    return found;
  }
} // namespace wheelrail
