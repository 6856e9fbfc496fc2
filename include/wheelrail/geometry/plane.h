#pragma once

#include <cmath>

namespace wheelrail
{
  /// A point or vector of a plane section [m].
  struct Point2
  {
    double x = 0, y = 0;
  };

  inline Point2
  operator+(const Point2 &a, const Point2 &b)
  {
    return {a.x + b.x, a.y + b.y};
  }

  inline Point2
  operator-(const Point2 &a, const Point2 &b)
  {
    return {a.x - b.x, a.y - b.y};
  }

  inline Point2
  operator*(const double f, const Point2 &a)
  {
    return {f * a.x, f * a.y};
  }

  inline double
  dot(const Point2 &a, const Point2 &b)
  {
    return a.x * b.x + a.y * b.y;
  }

  /// Third component of the cross product, positive when b lies counter-clockwise of a.
  inline double
  cross(const Point2 &a, const Point2 &b)
  {
    return a.x * b.y - a.y * b.x;
  }

  inline double
  norm(const Point2 &a)
  {
    return std::sqrt(dot(a, a));
  }

  /// Place and angle of a rail or wheel section in the track plane.
  ///
  /// Section frames have x positive to the field side and y up; the track plane has X positive to
  /// the track centre and Y up. A section point is mirrored (x to -x), turned counter-clockwise by
  /// `angle` [rad], and moved by `origin` [m].
  struct Placement
  {
    Point2 origin;
    double angle = 0;

    Point2
    to_track(const Point2 &p) const
    {
      const double c = std::cos(angle), s = std::sin(angle);
      return {origin.x - c * p.x - s * p.y, origin.y - s * p.x + c * p.y};
    }

    Point2
    to_section(const Point2 &p) const
    {
      const double c = std::cos(angle), s = std::sin(angle);
      const Point2 d = p - origin;
      return {-(c * d.x + s * d.y), -s * d.x + c * d.y};
    }
  };

  /// Contact frame in the track plane: s along the common tangent (towards +X), n along the normal
  /// that points up, out of the rail.
  struct ContactFrame
  {
    Point2 origin;
    double angle = 0; ///< of the s axis against +X, counter-clockwise [rad]

    Point2
    tangent() const
    {
      return {std::cos(angle), std::sin(angle)};
    }

    Point2
    normal() const
    {
      return {-std::sin(angle), std::cos(angle)};
    }

    /// (s, n) of a point of the track plane.
    Point2
    to_frame(const Point2 &p) const
    {
      return {dot(p - origin, tangent()), dot(p - origin, normal())};
    }

    /// Point of the track plane at (s, n).
    Point2
    to_track(const Point2 &q) const
    {
      return origin + q.x * tangent() + q.y * normal();
    }
  };
} // namespace wheelrail
