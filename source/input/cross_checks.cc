#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/input/cross_checks.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/study_cases.h>
#include <wheelrail/input/subject_checks.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    using Sentences = std::vector<std::string>;

    /// Three digits of a number that was computed.
    std::string
    digits(const double value)
    {
      return text("%.3g", value);
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
      const double steps = scene.path() / scene.velocity / step;
      if (steps > 2e6)
        warnings.push_back(path_text(scene) + ": takes about " + about_count(steps) + " time steps at " +
                           entry_text(scene, "Wheelset", "Velocity") + ", " +
                           entry_text(scene, "Mesh", "Solution cell size") + " and " +
                           entry_text(scene, "Run", "Time step factor") +
                           ", days of computing; a higher speed or a shorter distance takes less");
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
          " times the solution cell size of " + rounded_mm(scene.cell_size) +
          "; cells are halved from coarse to fine, so the ratio must be about 1, 2, 4, 8, 16, ...: take " +
          rounded_mm(scene.cell_size * std::exp2(nearest)));
      if (scene.depth_of_fine_cells() < 2 * scene.cell_size)
        found.push_back(entry_text(scene, "Mesh", "Fine depth") + ": less than two cells of " +
                        rounded_mm(scene.cell_size) + "; write auto or at least " +
                        rounded_mm(2 * scene.cell_size));
      if (scene.fine_margin < scene.cell_size)
        found.push_back(entry_text(scene, "Mesh", "Fine margin") + ": less than one cell of " +
                        rounded_mm(scene.cell_size) + "; at least that is needed around the patch");
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
            found.push_back(entry_text(scene, "Wheelset", inner) + ": must be at least " +
                            rounded_mm(least_gap) + " smaller than " + entry_text(scene, "Wheelset", outer) +
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
                            rounded_mm(wheel.disc_thickness) + " thick) reaches beyond the " + part +
                            ", which lies from " + rounded_mm(low) + " to " + rounded_mm(high) +
                            " off the flange back");
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

    /// The constants of Chaboche's law.
    void
    check_hardening(const Scene        &scene,
                    const std::string  &section,
                    const MaterialData &material,
                    Findings           &found)
    {
      const auto             entry  = [&](const char *name) { return entry_text(scene, section, name); };
      const CyclicHardening &cyclic = material.cyclic;
      if (material.law != SteelLaw::chaboche)
        {
          if (!cyclic.moduli.empty() || !cyclic.rates.empty() || cyclic.isotropic != 0)
            found.warnings.push_back(
              entry("Law") +
              ": without effect are Isotropic hardening, Kinematic moduli and Kinematic rates, which "
              "belong to Chaboche");
          return;
        }
      if (!material.yields())
        found.errors.push_back(entry("Yield stress") + ": Law = Chaboche needs one, such as 380 MPa");
      if (cyclic.moduli.size() != cyclic.rates.size())
        found.errors.push_back(entry("Kinematic rates") + ": " + std::to_string(cyclic.rates.size()) +
                               " for the " + std::to_string(cyclic.moduli.size()) + " moduli of " +
                               entry("Kinematic moduli") + "; each back stress needs both");
      if (material.yields() && material.yield_stress + cyclic.isotropic <= 0.01 * material.yield_stress)
        found.errors.push_back(entry("Isotropic hardening") +
                               ": softens the steel to nothing; at least a "
                               "hundredth of " +
                               entry("Yield stress") + " must be left");
      if (cyclic.isotropic * cyclic.isotropic_rate <
          -1.5 * material.youngs_modulus / (1 + material.poissons_ratio))
        found.errors.push_back(
          entry("Isotropic rate") + ": with " + entry("Isotropic hardening") +
          " the stress falls faster than elastic unloading, which no state follows; take a "
          "smaller rate");
      for (std::size_t i = 0; i < std::min(cyclic.moduli.size(), cyclic.rates.size()); ++i)
        if (cyclic.rates[i] > 0 && cyclic.moduli[i] / cyclic.rates[i] < 1e-3 * material.yield_stress)
          found.warnings.push_back(
            entry("Kinematic rates") + ": back stress " + std::to_string(i + 1) +
            " is bounded by C / gamma = " + digits(1e-6 * cyclic.moduli[i] / cyclic.rates[i]) +
            " MPa, next to nothing beside the yield stress");
    }

    void
    check_material(const Scene        &scene,
                   const std::string  &section,
                   const MaterialData &material,
                   Findings           &found)
    {
      const auto entry = [&](const char *name) { return entry_text(scene, section, name); };
      check_hardening(scene, section, material, found);
      if (material.law == SteelLaw::bilinear && material.yields() &&
          material.tangent_modulus >= material.youngs_modulus)
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
      if (scene.drive == Drive::torque && std::abs(scene.traction_coefficient) >= scene.friction.at(0) &&
          scene.traction_coefficient != 0)
        warnings.push_back(entry_text(scene, "Wheelset", "Traction coefficient") +
                           ": friction transmits at most " +
                           entry_text(scene, "Contact", "Friction coefficient") +
                           ", so the whole patch slides and the wheel " +
                           (scene.traction_coefficient > 0 ? "spins up" : "locks") + " while it rolls");
      const MaterialData &m         = scene.rail_material;
      const double        impedance = std::sqrt(m.density * m.youngs_modulus / (2 + 2 * m.poissons_ratio));
      if (1e9 * scene.friction.steepest_fall() > impedance / 2)
        warnings.push_back(
          entry_text(scene, "Contact", "Friction law") + ": friction falls by " +
          digits(scene.friction.steepest_fall()) + " per m/s of sliding; at 1 GPa a fall beyond " +
          digits(impedance / 2e9) +
          " feeds sliding more than shear waves carry away, and tractions oscillate from node to node");
      if (scene.friction.kind != FrictionKind::constant && scene.friction.at(0) == 0)
        warnings.push_back(entry_text(scene, "Contact", "Friction coefficient") +
                           ": 0 at rest, but not at speed with Contact/Friction law = " +
                           (scene.friction.kind == FrictionKind::rational ? "rational" : "exponential"));
      if (scene.drive == Drive::torque && scene.creepage != 0)
        warnings.push_back(entry_text(scene, "Wheelset", "Creepage") +
                           ": without effect, since Wheelset/Drive = torque");
      if (scene.wheel_load > 0 && scene.sprung_mass != Scene().sprung_mass)
        warnings.push_back(entry_text(scene, "Wheelset", "Sprung mass") + ": without effect, since " +
                           entry_text(scene, "Wheelset", "Wheel load") + " is set");
      if (scene.sprung_mass < 100 && !(scene.wheel_load > 0))
        warnings.push_back(entry_text(scene, "Wheelset", "Sprung mass") +
                           ": next to nothing presses the wheel on the rail; a railway vehicle has some 10 t "
                           "per wheel");
    }

    void
    check_strip(const Scene &scene, Sentences &errors)
    {
      const std::vector<double> &strip = scene.planned_strip;
      if (strip.empty())
        return;
      const std::string entry = entry_text(scene, "Mesh", "Planned strip");
      if (strip.size() != 2 || !(strip[0] < strip[1]))
        errors.push_back(entry +
                         ": two places are needed, the one nearer to the track centre first, such as "
                         "-15 mm, 12 mm");
      else if (scene.yaw != 0)
        errors.push_back(entry + ": is for wheels without yaw; write none, or Wheelset/Yaw = 0 mrad");
    }

    /// A rail has the same cells from wherever the wheel starts only where these move with it.
    void
    check_start(const Scene &scene, Sentences &errors)
    {
      const char *entry = scene.start_offset > 0       ? "Start offset"
                          : scene.staggered_starts > 1 ? "Staggered starts"
                                                       : nullptr;
      if (entry && scene.window == MeshWindow::fixed)
        errors.push_back(
          entry_text(scene, "Run", entry) + ": with " + entry_text(scene, "Mesh", "Window") +
          " the cells of the rail change with the start; leave it out, or set Mesh/Window = moving");
    }

  } // namespace


  std::vector<std::string>
  refused_by_bodies(const Scene &scene)
  {
    std::vector<std::string> refused;
    const auto               refuse = [&](const bool found, const char *entry, const char *what) {
      if (found)
        refused.push_back(entry_text(scene, "Half-space", entry) + ": " + what);
    };
    const char *const one_spin = "one spin for the whole contact",
                      *by_hand = "a position given by hand, where the bodies find their own";
    refuse(scene.halfspace_distance != "profiles", "Undeformed distance", "a distance without bodies");
    refuse(scene.halfspace_spin == HalfspaceSpin::contact, "Spin", one_spin);
    refuse(std::isfinite(scene.halfspace_given_spin), "Given spin", one_spin);
    refuse(scene.halfspace_lateral != 0, "Lateral offset", by_hand);
    refuse(scene.halfspace_inclination != 0, "Extra inclination", by_hand);
    return refused;
  }


  Findings
  contact_checks(const Scene &scene)
  {
    Findings found;
    check_wheelset(scene, found);
    check_wheel(scene, found.errors);
    check_material(scene, "Rail material", scene.rail_material, found);
    check_material(scene, "Wheel material", scene.wheel_material, found);
    check_drive(scene, found.warnings);
    if (scene.halfspace_bodies == ContactBodies::real)
      for (const std::string &refused : refused_by_bodies(scene))
        found.errors.push_back(refused + "; " + entry_text(scene, "Half-space", "Bodies") +
                               " does not take it: write half-spaces there, or leave this entry out");
    check_irregularities(scene, found);
    if (!(scene.wear.damage_begins < scene.wear.damage_peak &&
          scene.wear.damage_peak < scene.wear.damage_ends))
      found.errors.push_back(entry_text(scene, "Wear", "Damage peak at") + ": must lie between " +
                             entry_text(scene, "Wear", "Damage begins at") + " and " +
                             entry_text(scene, "Wear", "Damage ends at"));
    return found;
  }


  Findings
  cross_checks(const Scene &scene)
  {
    Findings found = contact_checks(scene);
    if (std::isfinite(scene.track_radius) && std::abs(scene.track_radius) >= least_track_radius)
      found.errors.push_back(entry_text(scene, "Track", "Radius") +
                             ": a run rolls straight on; write straight, or compute half-spaces (halfspace, "
                             "vehicle), which take curves");
    if (scene.both_wheels)
      found.errors.push_back(
        entry_text(scene, "Wheelset", "Wheels") +
        ": a run has one wheel; run --wheelset rolls the modelled one as it rolls on the "
        "wheelset, Wheels = one by itself");
    check_support(scene, found);
    check_cells(scene, found.errors);
    check_steps(scene, found.warnings);
    if (scene.several_passages() && !scene.rail_material.yields())
      found.errors.push_back(entry_text(scene, "Run", scene.passages == 1 ? "Passage list" : "Passages") +
                             ": the rail does not yield, so that every passage is the first one; give Rail "
                             "material/Yield stress");
    else if (scene.rail_from != "new" && !scene.rail_material.yields())
      found.errors.push_back(
        entry_text(scene, "Run", "Rail") +
        ": a rail that does not yield keeps nothing of earlier runs; write new, or give Rail "
        "material/Yield stress");
    check_strip(scene, found.errors);
    check_start(scene, found.errors);
    for (const std::string &fault : study_faults(scene))
      found.errors.push_back(fault);
    return found;
  }


  void
  check_distances(const Scene &scene, Findings &found)
  {
    if (scene.prepared_distance > 0 && scene.window == MeshWindow::moving)
      found.errors.push_back(entry_text(scene, "Mesh", "Prepared distance") +
                             ": not needed with Mesh/Window = moving, where a resumed run may roll on as far "
                             "as the rail goes; leave it out, or set Mesh/Window = fixed");
    else if (scene.mesh_distance() < scene.path())
      found.errors.push_back(entry_text(scene, "Mesh", "Prepared distance") + ": shorter than " +
                             path_text(scene) +
                             "; write auto, or a longer distance for a run that is to be resumed with more");
    if (scene.averaging_distance > scene.path())
      found.errors.push_back(
        entry_text(scene, "Run", "Averaging distance") + ": longer than " + path_text(scene) +
        "; the mean is taken over the last part of the run, so at most that is possible");
    else if (scene.evaluate_at != 0 && scene.until_steady())
      found.errors.push_back(
        entry_text(scene, "Run", "Evaluate at") +
        ": a run with Run/Rolling distance = until steady finds the stretch of its means by itself; write "
        "Evaluate at = end, or a Rolling distance in mm");
    else if (scene.evaluate_at == Scene::at_largest_force && !scene.irregular())
      found.errors.push_back(
        entry_text(scene, "Run", "Evaluate at") +
        ": on smooth surfaces the largest force is chance; write Evaluate at = end, or add an Irregularity");
    else if (scene.evaluate_at > 0 &&
             (scene.evaluate_at - 0.5 * scene.averaging_distance < -1e-9 ||
              scene.evaluate_at + 0.5 * scene.averaging_distance > scene.path() + 1e-9))
      found.errors.push_back(entry_text(scene, "Run", "Evaluate at") +
                             ": half of Run/Averaging distance = " + rounded_mm(scene.averaging_distance) +
                             " on either side of it must lie on the path, from 0 mm to " + path_text(scene));
    const double spacing = scene.path() / scene.ticks;
    if (scene.ticks > 1 && spacing < 0.1 * scene.cell_size)
      found.errors.push_back(
        entry_text(scene, "Output", "Ticks") + ": one output every " + rounded_mm(spacing) +
        " of rolling, which is less than a tenth of a cell (" + rounded_mm(scene.cell_size) +
        "), shows nothing new; at most " +
        std::to_string(std::max(1, static_cast<int>(10 * scene.path() / scene.cell_size))) + " are accepted");
  }
} // namespace wheelrail
