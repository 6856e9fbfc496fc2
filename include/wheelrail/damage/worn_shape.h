#pragma once

#include <wheelrail/geometry/curve.h>

#include <cstddef>
#include <vector>

namespace wheelrail
{
  /// A running surface while it wears: points along it in the frame of its section, x descending, as heads
  /// and treads of profiles.h run.
  struct WornShape
  {
    std::vector<Point2> points; ///< [m]
    std::vector<double> depth;  ///< taken off so far, along the normals [m]
    std::vector<double> damage; ///< share of a life until a crack, summed (burstow_damage())
    std::vector<double> cracks; ///< the same from crack_growth() less what was taken off, never below 0
    bool steel_on_left = true;  ///< of the path along the points: a rail; a wheel has it on the right
  };

  /// The part of a curve that lies above `lowest` [m], with points at most `spacing` apart [m].
  WornShape
  worn_shape(const Curve &curve, double lowest, double spacing, bool steel_on_left);

  /// Arc length along the points from the first one [m].
  std::vector<double>
  arc_of(const std::vector<Point2> &points);

  /// The arc length at the place next to p [m].
  double
  arc_next_to(const std::vector<Point2> &points, const std::vector<double> &arc, const Point2 &p);

  /// Lengths that belong to the points: from the middle before to the middle behind [m].
  std::vector<double>
  cell_lengths(const std::vector<double> &arc);

  /// Adds a section [m2] that is spread evenly between two arcs to the cells of the points; what lies beyond
  /// an end is added to the last cell there.
  void
  spread_section(const std::vector<double> &cells,
                 double                     from,
                 double                     to,
                 double                     section,
                 std::vector<double>       &sections);

  /// Sections smoothed along the path by Gauss's filter with a cut-off wavelength [m], at which half of a
  /// wave stays (ISO 16610-21). Each cell's section is spread as a whole, so that none gets lost.
  std::vector<double>
  smoothed_sections(const std::vector<double> &arc, const std::vector<double> &sections, double cut_off);

  /// Unit vector from the point into the steel.
  Point2
  into_steel(const WornShape &shape, std::size_t point);

  /// Takes sections [m2] off at the points, which move into the steel.
  void
  take_off(const std::vector<double> &sections, WornShape &shape);

  /// Area between two polylines [m2].
  double
  section_between(const std::vector<Point2> &before, const std::vector<Point2> &now);
} // namespace wheelrail
