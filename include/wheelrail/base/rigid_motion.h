#pragma once

#include <wheelrail/base/vector3.h>

#include <array>

namespace wheelrail
{
  /// A turn and a move of space, x -> R x + move.
  struct RigidMotion
  {
    std::array<Vector3, 3> rows = {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}}; ///< of R, orthogonal
    Vector3                move{};                                           ///< [m]

    Vector3
    operator()(const Vector3 &x) const
    {
      return turned(x) + move;
    }

    /// R v: the image of a direction.
    Vector3
    turned(const Vector3 &v) const
    {
      return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
    }

    /// R' v: the direction whose image is v.
    Vector3
    turned_back(const Vector3 &v) const
    {
      return v[0] * rows[0] + v[1] * rows[1] + v[2] * rows[2];
    }

    /// The place whose image is x.
    Vector3
    back(const Vector3 &x) const
    {
      return turned_back(x - move);
    }
  };

  /// The motion `first`, then `second`.
  inline RigidMotion
  then(const RigidMotion &first, const RigidMotion &second)
  {
    RigidMotion both;
    for (int k = 0; k < 3; ++k)
      {
        const Vector3 column = second.turned({first.rows[0][k], first.rows[1][k], first.rows[2][k]});
        for (int i = 0; i < 3; ++i)
          both.rows[i][k] = column[i];
      }
    both.move = second(first.move);
    return both;
  }

  /// The motion back.
  inline RigidMotion
  inverse(const RigidMotion &motion)
  {
    RigidMotion back;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        back.rows[i][k] = motion.rows[k][i];
    back.move = motion.back({});
    return back;
  }
} // namespace wheelrail
