#include <wheelrail/base/format_text.h>
#include <wheelrail/base/left_out.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/geometry/track.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/subject_checks.h>
#include <wheelrail/scene/curve_loads.h>
#include <wheelrail/scene/rail_bending.h>

#include <cmath>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using K = IrregularKind;

    bool
    of_wheel(const K kind)
    {
      return kind == K::flat || kind == K::rounded_flat || kind == K::polygon;
    }

    /// Whether a shape gets its depth from other entries.
    bool
    has_depth(const IrregularityData &one)
    {
      return std::isfinite(one.depth) || one.kind == K::flat || one.kind == K::rounded_flat ||
             one.in_file() || (one.kind == K::dipped_joint && std::isfinite(one.angle));
    }

    void
    check_one(const Scene &scene, const std::string &section, const IrregularityData &one, Findings &found)
    {
      const auto entry = [&](const char *name) { return entry_text(scene, section, name); };
      if (!has_depth(one))
        found.errors.push_back(entry("Depth") + ": " + entry("Kind") +
                               " has no depth of its own; give one, such as 0.1 mm");
      if (of_wheel(one.kind) && !one.on_wheel())
        found.errors.push_back(entry("Body") + ": " + entry("Kind") + " is a shape of wheels; write auto");
      if (one.kind == K::flat && std::isfinite(one.depth))
        found.errors.push_back(entry("Depth") +
                               ": that of a fresh flat is length^2/(8 R); write auto and give its length");
      if (one.kind == K::flat && one.length > 0.5 * scene.track.nominal_radius)
        found.errors.push_back(entry("Length") + ": longer than half the radius of the wheel, " +
                               rounded_mm(0.5 * scene.track.nominal_radius) + "; flats have 20 mm to 100 mm");
      if (one.kind == K::dipped_joint && std::isfinite(one.depth) && std::isfinite(one.angle))
        found.errors.push_back(entry("Angle") + ": with " + entry("Depth") +
                               " it says the same twice; write none or auto for one of them");
      if (one.kind == K::corrugation && one.length < one.wavelength)
        found.errors.push_back(entry("Length") + ": shorter than one wave, " + entry("Wavelength") +
                               "; give the length of all waves");
      if (one.in_file() && one.file == "none")
        found.errors.push_back(entry("File") + ": " + entry("Kind") + " needs one");
    }

    /// Entries that are set and count for nothing.
    void
    check_effect(const Scene &scene, const std::string &section, const IrregularityData &one, Findings &found)
    {
      const auto idle = [&](const char *name, const bool counts) {
        const Entry *const entry = find_entry(section, name);
        if (!counts && entry->get(scene) != entry->default_text)
          found.warnings.push_back(entry_text(scene, section, name) + ": without effect, since " +
                                   entry_text(scene, section, "Kind"));
      };
      const K kind = one.kind;
      idle("File", one.in_file());
      idle("Seed", kind == K::roughness);
      idle("Wavelength", kind == K::corrugation);
      idle("Order", kind == K::polygon);
      idle("Angle", kind == K::dipped_joint);
      idle("Length", kind != K::none && kind != K::polygon && kind != K::file);
      idle("Depth", kind != K::none && !one.in_file());
      idle("Width", kind != K::none && kind != K::file);
      idle("Place", kind != K::none);
    }

    /// How many sleepers lie below the rail, whose middle is that of the rolled stretch.
    int
    sleepers_below(const Scene &scene)
    {
      const double middle = 0.5 * scene.mesh_distance() - scene.support.first_sleeper;
      return static_cast<int>(std::floor((middle + 0.5 * scene.rail_length) / scene.support.spacing) -
                              std::ceil((middle - 0.5 * scene.rail_length) / scene.support.spacing)) +
             1;
    }

    void
    check_sleepers(const Scene &scene, Findings &found)
    {
      const SupportData &support = scene.support;
      if (support.pad_length >= support.spacing)
        found.errors.push_back(entry_text(scene, "Track", "Pad length") + ": not shorter than " +
                               entry_text(scene, "Track", "Sleeper spacing") +
                               "; take shorter pads, or Track/Support = continuous pads");
      if (const int below = sleepers_below(scene); below < 2)
        found.errors.push_back(entry_text(scene, "Track", "Sleeper spacing") + ": with " +
                               entry_text(scene, "Track", "First sleeper") + " there " +
                               (below == 1 ? "is one sleeper" : "is no sleeper") + " below " +
                               entry_text(scene, "Track", "Rail length") +
                               ", and a rail needs two at least; take a longer rail or a shorter spacing");
    }

    bool
    of_pads_or_sleepers(const std::string &entry)
    {
      for (const char *begin : {"Pad ", "Sleeper ", "First sleeper", "Ballast "})
        if (entry.rfind(begin, 0) == 0)
          return true;
      return false;
    }

    /// What needs both wheels, or profiles.
    void
    check_both_wheels(const Scene &scene, Findings &found)
    {
      const std::string both = entry_text(scene, "Wheelset", "Wheels");
      if (scene.both_wheels && !is_built(Subject::vehicle))
        found.errors.push_back(left_out(both, Subject::vehicle));
      if (scene.both_wheels && scene.halfspace_distance != "profiles")
        found.errors.push_back(entry_text(scene, "Half-space", "Undeformed distance") + ": " + both +
                               " needs profiles on both rails; set it to profiles, or Wheels to one");
      if (scene.both_wheels)
        return;
      if (scene.pose_balances)
        found.errors.push_back(
          entry_text(scene, "Wheelset", "Pose") +
          ": forces balance on a whole wheelset; set Wheelset/Wheels = both, or write given");
      if (std::isfinite(scene.cant))
        found.errors.push_back(
          entry_text(scene, "Track", "Cant") +
          ": shares the load of an axle between two wheels; set Wheelset/Wheels = both, or write none");
    }

    /// The loads of wheels with the load 1, which touch at their running circles.
    CurveLoads
    loads_in_curve(const Scene &scene)
    {
      return curve_loads(scene, 1, 1, running_circle_distance(scene.track));
    }

    /// How a curve with cant loads the wheels, as half of the running circles' distance has it.
    void
    check_cant(const Scene &scene, std::vector<std::string> &warnings)
    {
      const double over = loads_in_curve(scene).acceleration;
      if (std::isfinite(scene.track_radius) && scene.cant * scene.track_radius < 0)
        warnings.push_back(entry_text(scene, "Track", "Cant") +
                           ": the inner rail of the curve is the higher one; in " +
                           entry_text(scene, "Track", "Radius") + " a cant of the other sign leans inwards");
      if (const std::string lifted = lifted_in_curve(scene); !lifted.empty())
        warnings.push_back(lifted + "; look at radius, cant and velocity");
      else if (std::abs(over) > 2)
        warnings.push_back(
          entry_text(scene, "Wheelset", "Velocity") + ": leaves " + text("%.1f", std::abs(over)) +
          " m/s2 across the track unbalanced, where 1 m/s2 is much; look at radius, cant and velocity");
    }
  } // namespace


  void
  check_irregularities(const Scene &scene, Findings &found)
  {
    for (int k = 0; k < most_irregularities; ++k)
      {
        const std::string       section = "Irregularity " + std::to_string(k + 1);
        const IrregularityData &one     = scene.irregularities[k];
        if (one.kind != IrregularKind::none)
          check_one(scene, section, one, found);
        check_effect(scene, section, one, found);
      }
  }


  void
  check_support(const Scene &scene, Findings &found)
  {
    const SupportData &support = scene.support;
    if (!is_built(Subject::track) && (support.kind != RailSupport::clamped_foot || support.damped_ends > 0))
      found.errors.push_back(left_out(
        entry_text(scene, "Track", support.kind != RailSupport::clamped_foot ? "Support" : "Damped ends"),
        Subject::track));
    if (2 * support.damped_ends + scene.mesh_distance() > scene.rail_length)
      found.errors.push_back(entry_text(scene, "Track", "Damped ends") +
                             ": two of them and the rolled stretch of " + rounded_mm(scene.mesh_distance()) +
                             " are longer than " + entry_text(scene, "Track", "Rail length") +
                             "; take shorter ones or a longer rail");
    if (support.kind == RailSupport::clamped_foot)
      {
        for (const Entry &entry : entries())
          if (entry.section == "Track" && of_pads_or_sleepers(entry.name) &&
              entry.get(scene) != entry.default_text)
            found.warnings.push_back(entry_text(scene, "Track", entry.name) + ": without effect, since " +
                                     entry_text(scene, "Track", "Support"));
        return;
      }
    if (support.pad_damping == PadLoss::constant && support.pad_loss > 0.5)
      found.errors.push_back(
        entry_text(scene, "Track", "Pad loss factor") +
        ": with Track/Pad damping = constant at most 0.5 is possible, which three branches "
        "keep to 4 %; take less, or damper");
    if (support.kind == RailSupport::sleepers)
      check_sleepers(scene, found);
    constexpr double usual_load = 1e5, most = 5e-3;
    if (const double sinks = usual_load * rail_bending(support).deflection; sinks > most)
      found.warnings.push_back(entry_text(scene, "Track", "Pad stiffness") +
                               ": soft with what lies below; under 100 kN the rail sinks by about " +
                               about(1e3 * sinks) + " mm, where a usual track sinks by 1 mm or 2");
    if (support.kind == RailSupport::continuous_pads && support.sleeper_mass != SupportData().sleeper_mass)
      found.warnings.push_back(entry_text(scene, "Track", "Sleeper mass") + ": without effect, since " +
                               entry_text(scene, "Track", "Support") + " rests on rigid ground");
    if (const double length = enough_rail(scene); scene.rail_length < length)
      found.warnings.push_back(
        entry_text(scene, "Track", "Rail length") +
        ": short for this support, on which a rail bends over some " + about(rail_bending(support).length) +
        " m to either side of the wheel; its free ends make it sink and tilt more than a "
        "long one: take " +
        about(std::ceil(10 * length) / 10) + " m");
  }


  std::string
  lifted_in_curve(const Scene &scene)
  {
    if (!std::isfinite(scene.cant))
      return "";
    const CurveLoads loads = loads_in_curve(scene);
    return loads.right > 0 && loads.left > 0
             ? ""
             : entry_text(scene, "Wheelset", "Velocity") + ": " + text("%.1f", std::abs(loads.acceleration)) +
                 " m/s2 beyond what the cant balances lift the " +
                 (loads.acceleration > 0 ? "left" : "right") + "-hand wheel";
  }


  void
  check_wheelset(const Scene &scene, Findings &found)
  {
    if (std::abs(scene.track_radius) < least_track_radius)
      found.errors.push_back(entry_text(scene, "Track", "Radius") + ": too narrow for a track; " +
                             format_quantity(least_track_radius, "m") +
                             " is the least, to either side, or straight");
    check_both_wheels(scene, found);
    if (scene.pose_balances && !scene.rigid_axle)
      found.errors.push_back(entry_text(scene, "Wheelset", "Pose") +
                             ": wheels that turn by themselves do not steer, so that no yaw follows from "
                             "forces; write given, or set Wheelset/Axle = rigid");
    if (std::isfinite(scene.cant))
      check_cant(scene, found.warnings);
  }
} // namespace wheelrail
