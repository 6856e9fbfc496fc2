#pragma once

#include <wheelrail/input/cross_checks.h>
#include <wheelrail/scene/scene.h>

namespace wheelrail
{
  /// Adds what the entries of irregularities contradict among each other, as far as no profile is needed: a
  /// shape without depth or file, flats and polygons of a rail, entries without effect.
  void
  check_irregularities(const Scene &scene, Findings &found);
} // namespace wheelrail
