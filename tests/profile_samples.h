#pragma once

// Points of standard profiles with measurement noise, as the text of a profile file.

#include <wheelrail/geometry/profiles.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace test
{
  /// Points of a curve at equal steps [m] with normal noise of standard deviation `noise` [m]; the
  /// sum of twelve uniform numbers, since normal_distribution differs between libraries.
  inline std::vector<wheelrail::Point2>
  sampled(const wheelrail::Curve &curve, const double step, const double noise, const unsigned int seed)
  {
    std::mt19937 generator(seed);
    const auto   normal = [&generator]() {
      double sum = -6;
      for (int i = 0; i < 12; ++i)
        sum += generator() / 4294967296.;
      return sum;
    };
    std::vector<wheelrail::Point2> points;
    const double                   length = curve.length(0, curve.parameter_end());
    const int                      n      = static_cast<int>(length / step);
    for (int i = 0; i <= n; ++i)
      {
        const wheelrail::Point2 p  = curve.at(curve.advance(0, length * i / n)).position;
        const double            dx = noise * normal(), dy = noise * normal();
        points.push_back({p.x + dx, p.y + dy});
      }
    return points;
  }

  /// The same of the head of a standard rail, down to a depth [m].
  inline std::vector<wheelrail::Point2>
  sampled_head(const std::string &name  = "54E1",
               const double       depth = 30e-3,
               const double       step  = 0.5e-3,
               const double       noise = 0,
               const unsigned int seed  = 1)
  {
    std::vector<wheelrail::Point2> points;
    for (const wheelrail::Point2 &p : sampled(wheelrail::rail_profile(name).head, step, noise, seed))
      if (p.y > -depth)
        points.push_back(p);
    return points;
  }

  /// Two columns in millimetres.
  inline std::string
  columns(const std::vector<wheelrail::Point2> &points,
          const double                          x_factor = 1e3,
          const double                          y_factor = 1e3)
  {
    std::string text;
    for (const wheelrail::Point2 &p : points)
      {
        char line[80];
        std::snprintf(line, sizeof line, "%.7f %.7f\n", x_factor * p.x, y_factor * p.y);
        text += line;
      }
    return text;
  }
} // namespace test
