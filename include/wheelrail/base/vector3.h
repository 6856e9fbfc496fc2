#pragma once

#include <array>
#include <cmath>

namespace wheelrail
{
  /// A vector of space in the track frame X, Y, Z.
  using Vector3 = std::array<double, 3>;

  inline Vector3
  operator+(const Vector3 &a, const Vector3 &b)
  {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  }

  inline Vector3
  operator-(const Vector3 &a, const Vector3 &b)
  {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }

  inline Vector3
  operator*(const double f, const Vector3 &a)
  {
    return {f * a[0], f * a[1], f * a[2]};
  }

  inline void
  add(Vector3 &sum, const double f, const Vector3 &a)
  {
    for (int i = 0; i < 3; ++i)
      sum[i] += f * a[i];
  }

  inline double
  dot(const Vector3 &a, const Vector3 &b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  inline Vector3
  cross(const Vector3 &a, const Vector3 &b)
  {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  inline double
  norm(const Vector3 &a)
  {
    return std::sqrt(dot(a, a));
  }

  inline Vector3
  normalised(const Vector3 &a)
  {
    return (1 / norm(a)) * a;
  }

  /// v turned by `angle` [rad] about the unit vector `axis` (Rodrigues 1840).
  inline Vector3
  rotated(const Vector3 &v, const Vector3 &axis, const double angle)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    Vector3      result = c * v;
    add(result, s, cross(axis, v));
    add(result, (1 - c) * dot(axis, v), axis);
    return result;
  }
} // namespace wheelrail
