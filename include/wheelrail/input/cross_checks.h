#pragma once

#include <wheelrail/input/machine.h>
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

  /// All checks between entries, and of the entries with the contact of the rigid profiles and with
  /// the machine (what is unknown of it is not checked). Ranges of single values are the business of
  /// the entries. Throws nothing for a scene whose entries are each within their range.
  Findings
  cross_checks(const Scene &scene, const Machine &machine = {});
} // namespace wheelrail
