#pragma once

#include <wheelrail/base/machine.h>
#include <wheelrail/input/cross_checks.h>
#include <wheelrail/input/parameters.h>

namespace wheelrail
{
  /// Whether a scene can be computed: the checks between entries (cross_checks()), then those of the entries
  /// with the contact of the rigid profiles and with the machine (what is unknown of it is not checked).
  /// Throws nothing for a scene whose entries are each within their range.
  Findings
  scene_checks(const Scene &scene, const Machine &machine = {});

  /// Throws InputError with all errors of scene_checks(), each after the place where its entry was set.
  void
  require_computable(const SceneInput &input);
} // namespace wheelrail
