#pragma once

// What the shapes of irregular_shapes.h are made of.

#include <wheelrail/geometry/irregular_shapes.h>

#include <functional>

namespace wheelrail
{
  /// A number and its derivative.
  struct Lobe
  {
    double value = 0, slope = 0;
  };

  /// cos^2(pi u/length) within half a length of zero.
  Lobe
  lobe(double u, double length);

  /// A factor of the height over one direction, counted from the middle [m].
  using Along = std::function<Lobe(double)>;

  /// One everywhere.
  Along
  all_across();

  /// One within a quarter of the width of the shape, fading over the next quarter on each side; one
  /// everywhere where the shape has no width.
  Along
  across_plateau(const IrregularSize &size);

  /// The shape -depth x along(u) x across(v) between two places.
  Irregularity
  product(const IrregularSize &size, double begin, double end, Along along, Along across);
} // namespace wheelrail
