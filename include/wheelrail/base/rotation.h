#pragma once

#include <wheelrail/base/vector3.h>

#include <cmath>

namespace wheelrail
{
  /// Turns many vectors by the same angle, as rotated() turns one: Rodrigues (1840).
  class Rotation
  {
  public:
    /// About the unit vector `axis` by `angle` [rad].
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
