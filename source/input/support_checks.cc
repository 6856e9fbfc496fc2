#include <wheelrail/base/left_out.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/support_checks.h>
#include <wheelrail/scene/rail_bending.h>

#include <cmath>
#include <string>

namespace wheelrail
{
  namespace
  {
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
  } // namespace


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
} // namespace wheelrail
