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

  /// Turns vectors about the unit vector `axis` by `angle` [rad] (Rodrigues 1840).
  class Rotation
  {
  public:
    Rotation(const Vector3 &axis, const double angle)
      : axis_(axis)
      , cosine_(std::cos(angle))
      , sine_(std::sin(angle))
    {
    }

    Vector3
    operator()(const Vector3 &v) const
    {
      Vector3 result = cosine_ * v;
      add(result, sine_, cross(axis_, v));
      add(result, (1 - cosine_) * dot(axis_, v), axis_);
      return result;
    }

  private:
    Vector3 axis_;
    double  cosine_, sine_;
  };
} // namespace wheelrail
