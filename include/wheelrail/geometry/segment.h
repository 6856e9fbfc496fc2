#pragma once

#include <wheelrail/geometry/plane.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// One piece of a profile: a line, a circular arc, the graph of a polynomial y = sum c_i x^i, or
  /// a piece of a spline, x = sum a_i u^i and y = sum c_i u^i with u from 0 to 1.
  struct Segment
  {
    enum class Kind
    {
      line,
      arc,
      polynomial,
      spline
    };

    Kind                kind = Kind::line;
    std::string         name;            ///< as in the standard, "crown R300"
    Point2              start, end;      ///< [m]
    Point2              centre;          ///< of an arc [m]
    double              radius      = 0; ///< of an arc [m]
    double              angle_start = 0; ///< polar angle of the start seen from the centre [rad]
    double              angle_end   = 0; ///< of the end; end > start runs counter-clockwise [rad]
    std::vector<double> coefficients;    ///< of a polynomial or spline in metres: y [m]
    std::vector<double> coefficients_x;  ///< of a spline: x [m]
  };

  /// Value and first two derivatives of a polynomial sum c_i x^i.
  struct PolynomialValue
  {
    double value = 0, slope = 0, second = 0;
  };
  PolynomialValue
  evaluate_polynomial(const std::vector<double> &coefficients, double x);

  /// The same segment run through from its end to its start.
  Segment
  reversed(const Segment &segment);

  /// The segment mirrored about the y axis (x to -x), running from the image of its start to the
  /// image of its end. Throws InputError for a polynomial, which no symmetric outline needs.
  Segment
  mirrored(const Segment &segment);

  /// The segment moved by `by` [m]. Throws InputError for a polynomial.
  Segment
  moved(const Segment &segment, const Point2 &by);

  /// The part of a line or arc between the fractions f0 < f1. Throws InputError for others.
  Segment
  part_of(const Segment &segment, double f0, double f1);

  /// The straight segment between two points.
  Segment
  line_segment(const std::string &name, const Point2 &start, const Point2 &end);

  /// A point of a curve.
  struct CurvePoint
  {
    Point2 position;      ///< [m]
    Point2 tangent;       ///< unit vector in the running direction
    double curvature = 0; ///< [1/m], positive when the curve turns counter-clockwise
    int    segment   = 0; ///< index into segments()
  };

  // The functions below take fractions f of a segment from 0 to 1: of the length of a line, the
  // angle of an arc, x of a polynomial, u of a spline.

  /// Position at a fraction [m].
  Point2
  position_on(const Segment &segment, double f);

  /// Position, tangent and curvature at a fraction.
  CurvePoint
  point_on(const Segment &segment, double f);

  /// Length of the derivative of the position with respect to the fraction [m].
  double
  speed_on(const Segment &segment, double f);

  /// Arc length between two fractions [m], f1 >= f0.
  double
  length_on(const Segment &segment, double f0, double f1);

  /// Fraction at arc length `distance` [m] beyond f0; the end must lie within the segment.
  double
  advance_on(const Segment &segment, double f0, double distance);

  /// Fraction of the point closest to p.
  double
  closest_on(const Segment &segment, const Point2 &p);

  /// Number of intervals of a segment between whose ends a smooth function of the position is
  /// taken to change its sign at most once: `full` for the long zones of standard profiles, fewer
  /// for the short pieces of a spline.
  int
  samples_on(const Segment &segment, int full);
} // namespace wheelrail
