#include <wheelrail/base/format_text.h>
#include <wheelrail/base/left_out.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/geometry/track.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/wheelset_checks.h>
#include <wheelrail/scene/curve_loads.h>

#include <cmath>
#include <vector>

namespace wheelrail
{
  namespace
  {
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
