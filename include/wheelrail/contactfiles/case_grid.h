#pragma once

#include <wheelrail/contactfiles/contact_case.h>
#include <wheelrail/halfspace/hertz.h>
#include <wheelrail/halfspace/problem.h>

#include <optional>
#include <vector>

namespace wheelrail
{
  /// The grid of a case of module 3, of an ellipse or a strip SCALE times as large.
  HalfspaceGrid
  grid_of(const ContactGrid &given, const std::optional<HertzContact> &hertz);

  /// Undeformed distance at the centres of its elements, by IBASE or of an ellipse [m]; elements outside of a
  /// planform (IPLAN) lie far apart.
  std::vector<double>
  distances(const ContactCase &one, const HalfspaceGrid &grid, const std::optional<HertzContact> &hertz);
} // namespace wheelrail
