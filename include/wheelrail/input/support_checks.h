#pragma once

#include <wheelrail/input/cross_checks.h>

namespace wheelrail
{
  /// Track/Support and its entries against each other and against the rail.
  void
  check_support(const Scene &scene, Findings &found);
} // namespace wheelrail
