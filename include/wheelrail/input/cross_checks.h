#pragma once

#include <wheelrail/scene/scene.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// What the values of a scene contradict among each other, one sentence each, starting with the
  /// entry to change: "Run/Averaging distance = 20 mm: ...".
  struct Findings
  {
    std::vector<std::string> errors;   ///< the scene cannot be computed, or its figures would be worthless
    std::vector<std::string> warnings; ///< it can be computed, but may not be what was meant
  };

  /// Entries that half-spaces take and contact of the true bodies does not, each with what it is.
  std::vector<std::string>
  refused_by_bodies(const Scene &scene);

  /// The checks of wheel, materials, drive and friction, as far as half-spaces need them, too.
  Findings
  contact_checks(const Scene &scene);

  /// These, and the checks of cells and time steps that need nothing but the entries. Ranges
  /// of single values are the business of the entries, the contact of the profiles and the machine that
  /// of check_scene(). Throws nothing for a scene whose entries are each within their range.
  Findings
  cross_checks(const Scene &scene);

  /// The distances of the run against each other, added to `found`.
  void
  check_distances(const Scene &scene, Findings &found);
} // namespace wheelrail
