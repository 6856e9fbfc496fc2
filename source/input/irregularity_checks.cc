#include <wheelrail/base/quantity.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/irregularity_checks.h>

#include <cmath>
#include <string>

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
} // namespace wheelrail
