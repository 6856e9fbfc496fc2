#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/model/scene_head.h>
#include <wheelrail/scene/rail_bending.h>

#include <cmath>
#include <filesystem>

namespace wheelrail
{
  namespace
  {
    /// To four digits, and never -0.
    std::string
    shown(const double value)
    {
      return text("%.4g", value == 0 ? 0. : value);
    }

    /// The name of a profile; of files without the folder.
    std::string
    name(const std::string &path)
    {
      return std::filesystem::path(path).filename().string();
    }

    /// "; left S1002 wheel on worn.prr rail" where the left-hand side of a wheelset differs.
    std::string
    left_bodies(const Scene &scene)
    {
      const std::string &wheel = scene.left_wheel_profile, &rail = scene.left_rail_profile, same = "as right";
      if (!scene.both_wheels || (wheel == same && rail == same))
        return "";
      return "; left " + name(wheel == same ? scene.wheel_profile : wheel) + " wheel on " +
             name(rail == same ? scene.rail_profile : rail) + " rail";
    }

    /// "S1002 wheel on 54E1 rail, inclination 1:40"; of files the name without the folder.
    std::string
    bodies_in_touch(const Scene &scene)
    {
      const double n = 1 / scene.track.inclination;
      return (scene.left_wheel ? "left " : "") + name(scene.wheel_profile) + " wheel on " +
             name(scene.rail_profile) + " rail, inclination " +
             (std::abs(n - std::round(n)) < 1e-9 * n ? "1:" + shown(n) : shown(scene.track.inclination)) +
             left_bodies(scene);
    }

    std::string
    kilometres_per_hour(const WheelsetSettings &scene)
    {
      return shown(3.6 * scene.velocity) + " km/h";
    }

    /// What presses surfaces together that are no profiles, with a comma behind it.
    std::string
    pressed(const Scene &scene, const double wheel_load)
    {
      if (scene.halfspace_approach > 0)
        return entry_text(scene, "Half-space", "Approach") + ", ";
      const double force = scene.halfspace_normal_force > 0 ? scene.halfspace_normal_force : wheel_load;
      return force > 0 ? "normal force " + shown(1e-3 * force) + " kN, " : "";
    }

    /// Load, speed and pose.
    std::string
    running(const WheelsetSettings &scene, const double wheel_load)
    {
      std::string text = wheel_load > 0 ? "wheel load " + shown(1e-3 * wheel_load) + " kN, " : "";
      text += kilometres_per_hour(scene);
      if (scene.pose_balances)
        text += ", lateral shift and yaw from equilibrium";
      else
        text += ", lateral shift " + shown(1e3 * scene.lateral_shift) + " mm, yaw " + shown(1e3 * scene.yaw) +
                " mrad";
      if (scene.roll == RollMode::given)
        text += ", roll " + shown(1e3 * scene.roll_angle) + " mrad";
      else if (scene.roll == RollMode::from_contact)
        text += ", roll from contact";
      if (scene.lateral_creepage != 0)
        text += ", lateral creepage " + shown(100 * scene.lateral_creepage) + " %";
      return text;
    }

    /// "curve of 300 m to the left, cant 100 mm"; empty on straight track without cant.
    std::string
    curve(const Scene &scene)
    {
      std::string text;
      if (std::isfinite(scene.track_radius))
        text = "curve of " + shown(std::abs(scene.track_radius)) + " m to the " +
               (scene.track_radius > 0 ? "left" : "right");
      if (std::isfinite(scene.cant))
        text += (text.empty() ? "straight, cant " : ", cant ") + shown(1e3 * scene.cant) +
                " mm, centre of gravity " + shown(scene.centre_height) + " m above the rails";
      return text;
    }

    /// "sleepers every 600 mm, pads of 300 MN/m, sleepers of 160 kg on ballast of 50 MN/m; a long rail sinks
    /// by about 1.2 mm". `wheel_load` [N].
    std::string
    rail_support(const TrackSettings &scene, const double wheel_load)
    {
      const SupportData &support = scene.support;
      if (support.kind == RailSupport::clamped_foot)
        return "foot and ends of the rail clamped";
      const auto  MN_m = [](const double stiffness) { return shown(1e-6 * stiffness) + " MN/m"; };
      std::string text =
        support.kind == RailSupport::sleepers ? "sleepers every " : "continuous pads, one for ";
      text += in_mm(support.spacing) + ", pads of " + MN_m(support.pad_stiffness);
      if (support.kind == RailSupport::sleepers)
        text += std::isfinite(support.sleeper_mass) ? ", sleepers of " + shown(support.sleeper_mass) +
                                                        " kg on ballast of " + MN_m(support.ballast_stiffness)
                                                    : ", sleepers do not move";
      if (support.damped_ends > 0)
        text += ", damped ends of " + shown(support.damped_ends) + " m";
      return text + "; a long rail sinks by about " +
             about(1e3 * wheel_load * rail_bending(support).deflection) + " mm";
    }

    std::string
    friction(const ContactSettings &scene)
    {
      const std::string at_rest = "friction " + shown(scene.friction.at(0));
      if (scene.friction.kind == FrictionKind::constant)
        return at_rest;
      return at_rest + " at rest, " + shown(scene.friction.sliding()) + " at high sliding speed";
    }

    std::string
    what_drives(const Scene &scene)
    {
      if (scene.drive == Drive::rate)
        return "turning rate held at a creepage of " + shown(100 * scene.creepage) + " %, " + friction(scene);
      const double c = scene.traction_coefficient;
      if (c == 0)
        return "rolling freely, traction coefficient 0, " + friction(scene);
      return (c > 0 ? "driving" : "braking") + (", traction coefficient " + shown(c)) + " of " +
             friction(scene);
    }

    std::string
    steel(const MaterialData &material)
    {
      if (!material.yields())
        return "elastic";
      return (material.law == SteelLaw::chaboche ? "of cyclic hardening, yields at " : "yields at ") +
             shown(1e-6 * material.yield_stress) + " MPa";
    }
  } // namespace


  std::vector<HeadLine>
  scene_head(const Scene &scene, const double wheel_load, const HeadOf of)
  {
    std::vector<HeadLine> head;
    if (of == HeadOf::halfspaces && scene.halfspace_distance != "profiles")
      {
        head.push_back({"surfaces", entry_text(scene, "Half-space", "Undeformed distance")});
        head.push_back({"running", pressed(scene, wheel_load) + kilometres_per_hour(scene)});
      }
    else
      {
        head.push_back({"wheel and rail", bodies_in_touch(scene)});
        head.push_back({"running", running(scene, wheel_load)});
        if (const std::string track = curve(scene); !track.empty())
          head.push_back({"track", track});
        if (scene.both_wheels)
          head.push_back(
            {"axle", scene.rigid_axle ? "both wheels turn at one rate" : "wheels turn by themselves"});
      }
    head.push_back({"drive", what_drives(scene)});
    if (scene.motion != "none")
      head.push_back({"motion", "follows " + scene.motion + "; the values above are those at its start"});
    if (of == HeadOf::halfspaces && scene.both_wheels)
      head.push_back({"bodies",
                      scene.halfspace_bodies == ContactBodies::half_spaces
                        ? "half-spaces"
                        : "these wheels and rails, each with its own elasticity"});
    if (of == HeadOf::halfspaces)
      head.push_back({"elements", "of " + in_mm(scene.halfspace_element_size)});
    else
      {
        head.push_back(
          {"steel", "rail " + steel(scene.rail_material) + ", wheel " + steel(scene.wheel_material)});
        head.push_back({"support", rail_support(scene, wheel_load)});
        head.push_back({"cells", "of " + in_mm(scene.cell_size)});
      }
    return head;
  }
} // namespace wheelrail
