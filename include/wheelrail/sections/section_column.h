#pragma once

#include <wheelrail/geometry/plane.h>
#include <wheelrail/sections/cubic_spline.h>

#include <cstddef>
#include <vector>

namespace wheelrail
{
  /// The section of a surface at one place along the track: a spline in the arc length through its lines, in
  /// the track plane.
  class SectionColumn
  {
  public:
    SectionColumn() = default;

    /// `points` of the lines from number `first` on, and their change along the track.
    SectionColumn(std::size_t first, std::vector<Point2> points, std::vector<Point2> along);

    struct Point
    {
      Point2 position; ///< in the track plane [m]
      Point2 tangent;  ///< over the arc length
      Point2 along;    ///< over the place along the track
    };
    /// At an arc length [m].
    Point
    at(double s) const;

    bool
    empty() const
    {
      return points_.empty();
    }

    /// Numbers of its first line, and of the one behind its last.
    std::size_t
    first() const
    {
      return first_;
    }
    std::size_t
    end() const
    {
      return first_ + points_.size();
    }

    /// Arc length at a line, also between two [m].
    double
    arc(double line) const;

    /// Line at an arc length.
    double
    line(double s) const;

    double
    length() const
    {
      return x_.places().back();
    }

    const std::vector<Point2> &
    points() const
    {
      return points_;
    }

  private:
    std::size_t         first_ = 0;
    std::vector<Point2> points_, along_;
    CubicSpline         x_, y_;
  };
} // namespace wheelrail
