#pragma once

#include <array>
#include <cstddef>

namespace wheelrail
{
  /// The two bodies of a scene; also the material id of the cells.
  enum class Body : unsigned char
  {
    rail  = 0,
    wheel = 1
  };

  /// Both, for loops over them.
  constexpr std::array<Body, 2> both_bodies = {Body::rail, Body::wheel};

  /// Place of a body in an array of two.
  constexpr std::size_t
  index(const Body body)
  {
    return static_cast<std::size_t>(body);
  }

  inline const char *
  body_name(const Body body)
  {
    return body == Body::rail ? "rail" : "wheel";
  }

  /// One thing of each body, asked for by the name of the body.
  template <typename T>
  struct PerBody
  {
    T rail{}, wheel{};

    T &
    operator[](const Body body)
    {
      return body == Body::rail ? rail : wheel;
    }
    const T &
    operator[](const Body body) const
    {
      return body == Body::rail ? rail : wheel;
    }
  };
} // namespace wheelrail
