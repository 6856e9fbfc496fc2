#pragma once

#include <wheelrail/geometry/segment.h>

#include <functional>
#include <vector>

namespace wheelrail
{
  /// A plane curve made of segments that join; the parameter t runs from 0 to n over n segments,
  /// the integer part being the segment (lines by length, arcs by angle, polynomials by x, splines by u).
  /// At a joint the values are those of the segment that starts there.
  class Curve
  {
  public:
    Curve() = default;

    /// Throws InputError when consecutive segments are more than one micrometre apart (the
    /// published S1002 has a joint jump of 0.12 micrometres), or a segment has no length.
    explicit Curve(std::vector<Segment> segments);

    const std::vector<Segment> &
    segments() const
    {
      return segments_;
    }

    double
    parameter_end() const
    {
      return static_cast<double>(segments_.size());
    }

    /// Position, tangent and curvature at parameter t (clamped to the range).
    CurvePoint
    at(double t) const;

    /// Arc length between two parameters [m], t1 >= t0 (closed form for lines and arcs, Gauss
    /// quadrature for polynomials, 1e-12 relative).
    double
    length(double t0, double t1) const;

    /// Parameter at arc length `distance` [m] beyond t0 (before it when negative), clamped to the
    /// range of the curve.
    double
    advance(double t0, double distance) const;

    /// Parameter of the point closest to p, over the whole curve.
    double
    closest(const Point2 &p) const;

    /// All parameters in [t0, t1] where `level(point)` changes sign, ascending, refined to
    /// round-off; used to cut a curve with a line. Each segment is sampled at 64 intervals (8 for a
    /// piece of a spline): two changes within one of them stay unseen, and so does a mere touch.
    std::vector<double>
    roots(const std::function<double(const Point2 &)> &level, double t0, double t1) const;

  private:
    struct Box
    {
      Point2 low, high;
    };

    std::vector<Segment> segments_;
    std::vector<double>  lengths_; ///< of the segments [m]
    std::vector<Box>     boxes_;   ///< around the segments, to skip far ones in closest()
  };
} // namespace wheelrail
