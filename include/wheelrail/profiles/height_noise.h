#pragma once

#include <wheelrail/geometry/curve.h>
#include <wheelrail/profiles/height_grid.h>

#include <vector>

namespace wheelrail
{
  /// Heights over places, ascending [m].
  using Heights = std::vector<Point2>;

  /// Standard deviation of heights where they are noisiest: parts that are exact, as a flange from a drawing,
  /// do not lower it [m].
  double
  largest_noise(const Heights &heights);

  /// How much longer a line is for the spline that smooths it (smoothing_spline()): where there is noise
  /// lengths count a third, since what deviates from a profile is longer than the arcs of a profile.
  double
  stretch_of(double noise);

  /// The heights without their noise [m], at other places; beyond the ends those of the ends. `draw`: as in
  /// smoothing_spline().
  std::vector<double>
  smoothed(Heights                    heights,
           double                     noise,
           double                     stretch,
           const std::vector<double> &places,
           unsigned int               draw = 0);

  /// Smooths the lines along of a grid. Their noise is that of the lines within 12 mm beside them. With a
  /// `draw` they are lines among which they then lie, all off alike: smoothing itself is an error, too.
  void
  smooth_along(HeightGrid &grid, unsigned int draw = 0);

  /// Sets the noise of heights that were measured one by one: the largest of all lines along; 0 where only
  /// digits make it.
  void
  find_noise(HeightGrid &grid);

  /// The noise that slices have as a whole [m]: how far each stands off its neighbours, the median of lines
  /// along that go through all of them; 0 where only digits make it.
  double
  noise_of_slices(const std::vector<Heights> &lines);

  /// Sets it for a grid.
  void
  find_noise_of_slices(HeightGrid &grid);

  /// Heights with one more draw of their noise on top (0: as they are): one for each height, or for slices
  /// one for all heights of a slice.
  HeightGrid
  with_noise(HeightGrid grid, bool of_slices, unsigned int draw);

  /// Heights that were measured one by one, smoothed across and along by their noise.
  HeightGrid
  smoothed_heights(HeightGrid grid);
} // namespace wheelrail
