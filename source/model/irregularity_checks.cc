#include <wheelrail/base/quantity.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/model/irregularity_checks.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace wheelrail
{
  namespace
  {
    // waves of eight cells are followed within 5 %, of four as a zigzag
    constexpr double cells_needed = 8, cells_least = 4;

    /// What an irregularity is told by: an entry of its own, or of rails by slices, with its value.
    std::string
    told_by(const Scene &scene, const Irregularity &one, const std::string &entry)
    {
      if (one.name != "Profiles")
        return entry_text(scene, one.name, entry);
      return entry_text(scene, one.name, entry == "Place" ? "Rail place" : "Rail");
    }

    void
    check_cells(const Scene &scene, const Irregularity &one, Findings &found)
    {
      if (one.gap)
        {
          const double      length = one.end - one.begin;
          const std::string gap    = entry_text(scene, "Profiles", "Second rail") + ": the gap of " +
                                  rounded_mm(length) + " in front of it ";
          if (scene.cell_size > length)
            found.errors.push_back(gap + "is narrower than a cell; take Mesh/Solution cell size = " +
                                   rounded_mm(std::floor(1e5 * length / 4) / 1e5));
          else if (scene.cell_size > 0.251 * length)
            found.warnings.push_back(gap + "is fewer than four cells wide: it ends up to half a cell off");
          return;
        }
      const double rounded = std::floor(1e5 * one.shortest / cells_needed) / 1e5;
      if (scene.cell_size > one.shortest / cells_least)
        found.errors.push_back(told_by(scene, one, "Kind") + ": rises and falls within " +
                               rounded_mm(one.shortest) + ", which cells of " + rounded_mm(scene.cell_size) +
                               " cannot follow; take Mesh/Solution cell size = " + rounded_mm(rounded));
      else if (scene.cell_size > 1.001 * one.shortest / cells_needed)
        found.warnings.push_back(told_by(scene, one, "Kind") + ": rises and falls within " +
                                 rounded_mm(one.shortest) + ", fewer than eight cells of " +
                                 rounded_mm(scene.cell_size) +
                                 "; take Mesh/Solution cell size = " + rounded_mm(rounded) + " for results");
    }

    /// An irregularity that has next to no height where the wheel can roll: around the contact of the start,
    /// in `at` of the section [m], up to a whole width of the patch to both sides.
    void
    check_across(const Scene         &scene,
                 const Irregularity  &one,
                 const double         at,
                 const ExpectedPatch &patch,
                 Findings            &found)
    {
      constexpr int    along = 61, across = 16;
      constexpr double felt    = 0.02; // of its largest height
      constexpr double reach   = 0.75; // of the width of the patch
      constexpr double off     = 0.37; // of a step, so that waves are not looked at on their crests alone
      double           largest = 0;
      for (int i = 0; i < along; ++i)
        for (int j = -across; j <= across; ++j)
          {
            const double u = one.begin + (one.end - one.begin) * (i + off) / along;
            largest = std::max(largest, std::abs(one.at(at + reach * patch.width * j / across, u).height));
          }
      if (largest < felt * one.measures.largest)
        found.warnings.push_back(told_by(scene, one, "Lateral place") +
                                 ": the wheel rolls beside the irregularity; its patch, about " +
                                 rounded_mm(std::round(1e3 * patch.width) / 1e3) + " wide, lies around " +
                                 rounded_mm(std::round(1e3 * at) / 1e3));
    }

    /// The largest height of irregularities where the wheel stands at the start, around `across` of the
    /// section [m].
    double
    height_at_start(const Irregularities &those,
                    const double          circumference,
                    const double          across,
                    const ExpectedPatch  &patch)
    {
      double largest = 0;
      for (int i = -8; i <= 8; ++i)
        for (int j = -8; j <= 8; ++j)
          largest = std::max(
            largest,
            std::abs(
              height_at(those, circumference, across + 0.5 * patch.width * j / 8, 0.6 * patch.length * i / 8)
                .height));
      return largest;
    }
  } // namespace


  void
  check_irregular_run(const Scene         &scene,
                      const SceneGeometry &geometry,
                      const ExpectedPatch &patch,
                      Findings            &found)
  {
    constexpr double even = 1e-6, sloping = 1e-3; // [m]
    for (const Body body : both_bodies)
      {
        const Irregularities &all  = geometry.surfaces[body].irregularities();
        const double circumference = body == Body::rail ? 0 : 2 * M_PI * geometry.surfaces.rolling_radius,
                     across        = body == Body::rail ? geometry.contact.rail_x : geometry.contact.wheel_x;
        const auto goes_round      = [&](const Irregularity &one) {
          return body == Body::wheel && one.end - one.begin > 0.999 * circumference;
        };
        for (const Irregularity &one : all)
          {
            check_cells(scene, one, found);
            if (one.kinks.empty() && one.shortest < patch.length)
              found.warnings.push_back(
                told_by(scene, one, "Kind") + ": rises and falls within " + rounded_mm(one.shortest) +
                ", the patch is about " + rounded_mm(std::round(1e4 * patch.length) / 1e4) +
                " long: it lies over several waves, and the force follows only a part of their height");
            if (!one.endless && (one.begin > scene.mesh_distance() + 0.5 * patch.length ||
                                 (body == Body::rail && one.end < -0.5 * patch.length)))
              found.warnings.push_back(told_by(scene, one, "Place") +
                                       ": the wheel does not come there within " + path_text(scene));
            else if (!one.endless && !goes_round(one) && one.end + 0.5 * patch.length > scene.mesh_distance())
              found.warnings.push_back(told_by(scene, one, "Place") + ": it ends at " +
                                       rounded_mm(std::round(1e4 * one.end) / 1e4) +
                                       ", where the patch is still on it after " + path_text(scene) +
                                       "; the largest force may come later");
            if (one.name == "Profiles")
              continue; // where the wheel rolls, or not
            check_across(scene, one, across, patch, found);
          }
        // where sections change along a rail the wheel starts on a slope, with the velocity that it has there
        const bool   slopes = std::any_of(all.begin(), all.end(), [](const Irregularity &one) {
          return one.name == "Profiles" && one.endless;
        });
        const double start  = height_at_start(all, circumference, across, patch);
        if (start <= (slopes ? sloping : even))
          continue;
        const Irregularity &highest =
          *std::max_element(all.begin(), all.end(), [&](const Irregularity &a, const Irregularity &b) {
            return height_at_start({a}, circumference, across, patch) <
                   height_at_start({b}, circumference, across, patch);
          });
        found.errors.push_back(
          told_by(scene, highest, "Place") + ": the wheel starts on the " + body_name(body) +
          "'s irregularity (" + in_mm(start, 1e6) +
          " at the patch); a run starts in steady rolling on the smooth profile: " +
          (goes_round(highest) ? "put a crest there, or take less height or longer waves"
                               : "move it at least " + rounded_mm(std::ceil(1e3 * 0.6 * patch.length) / 1e3) +
                                   " away from its begin and end"));
      }
  }
} // namespace wheelrail
