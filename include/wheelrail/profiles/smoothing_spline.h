#pragma once

#include <wheelrail/geometry/segment.h>

#include <vector>

namespace wheelrail
{
  /// Median of the distances between successive points [m]; 0 for fewer than two.
  double
  median_step(const std::vector<Point2> &points);

  /// Whether a step [m] between two points of a profile is a gap, `usual` the median step.
  bool
  is_gap(double step, double usual);

  /// A curve of spline pieces through measured points [m], in their order, that leaves out noise of
  /// standard deviation `noise` at each point [m] (at least 0.02 micrometres is assumed) and keeps curvature:
  /// x and y are cubic splines over the chord length whose third derivative is penalised, weakly where the
  /// curvature of the points changes and strongly where it does not (doc/theory/geometry.md). In gaps pieces
  /// are 0.5 mm long, so that draws differ there. Neighbouring pieces have equal curvature, except at the
  /// kinks, where the curve passes exactly through the point with two tangents.
  ///
  /// `kinks` are indices of points, ascending. `draw`: not the smoothest curve but, the same for the same
  /// number, one of those among which the profile lies by the points (Wahba 1983); 0: the smoothest. Throws
  /// InputError when fewer than four points lie between two kinks.
  std::vector<Segment>
  smoothing_spline(const std::vector<Point2>      &points,
                   const std::vector<std::size_t> &kinks,
                   const std::vector<double>      &noise,
                   unsigned int                    draw = 0);

  /// Indices of the points at which the outline has a kink of more than 20 degrees: where the turn
  /// of the tangent stays when the tangents are taken over half the length. Lengths grow with the noise at
  /// the point [m] until 20 degrees are six times what it turns them by.
  std::vector<std::size_t>
  find_kinks(const std::vector<Point2> &points, const std::vector<double> &noise);
} // namespace wheelrail
