#pragma once

#include <wheelrail/input/cross_checks.h>
#include <wheelrail/scene/scene.h>

#include <string>

namespace wheelrail
{
  /// Adds what the entries of irregularities contradict among each other, as far as no profile is needed: a
  /// shape without depth or file, flats and polygons of a rail, entries without effect.
  void
  check_irregularities(const Scene &scene, Findings &found);

  /// Track/Support and its entries against each other and against the rail.
  void
  check_support(const Scene &scene, Findings &found);

  /// "Wheelset/Velocity = ...: ... lift the left-hand wheel" where the curve of a scene does so
  /// (curve_loads()); empty where both wheels carry.
  std::string
  lifted_in_curve(const Scene &scene);

  /// Adds what is wrong, or to be warned of, with curve, cant and both wheels of a wheelset: entries that
  /// contradict each other, and a velocity at which the curve overturns what rests on the axle.
  void
  check_wheelset(const Scene &scene, Findings &found);
} // namespace wheelrail
