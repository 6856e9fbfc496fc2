#pragma once

// A wheel on an irregular rail with two degrees of freedom, its height and that of the sprung mass: what the
// finite elements have to come to where waves in the bodies matter little.

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace test
{
  /// A rigid unsprung mass on Hertz's spring and the elasticity of both bodies far from the contact,
  ///
  ///   approach = hertz F^(2/3) + compliance F,
  ///
  /// under a load that the suspension keeps. SI units.
  struct ReducedWheel
  {
    double unsprung   = 0; ///< wheel and half axle [kg]
    double load       = 0; ///< [N]
    double hertz      = 0; ///< [m/N^(2/3)]
    double compliance = 0; ///< [m/N]
    double suspension = 0; ///< stiffness [N/m]; the sprung mass stays where it is

    double
    approach(const double force) const
    {
      return hertz * std::pow(force, 2. / 3) + compliance * force;
    }

    /// Force of an approach, by Newton's method in F^(1/3), whose polynomial is convex [N].
    double
    force(const double approached) const
    {
      if (approached <= 0)
        return 0;
      double r = std::sqrt(approached / hertz);
      for (int k = 0; k < 50; ++k)
        {
          const double step =
            ((compliance * r + hertz) * r * r - approached) / ((3 * compliance * r + 2 * hertz) * r);
          r -= step;
          if (std::abs(step) < 1e-12 * r)
            break;
        }
      return r * r * r;
    }
  };

  /// What became of it.
  struct ReducedMotion
  {
    std::vector<double> time, force, height; ///< height of the axle against first touch of smooth surfaces

    double
    peak() const
    {
      return *std::max_element(force.begin(), force.end());
    }
    double
    least() const
    {
      return *std::min_element(force.begin(), force.end());
    }
    /// How long the longest contact after a time without lasts [s].
    double
    longest_contact() const
    {
      double longest = 0, begin = -1;
      for (std::size_t k = 0; k < time.size(); ++k)
        {
          if (force[k] > 0 && begin < 0)
            begin = time[k];
          if (force[k] <= 0 && begin >= 0)
            {
              longest = std::max(longest, time[k] - begin);
              begin   = -1;
            }
        }
      return longest;
    }
  };

  /// `path`: height at which the rigid wheel would touch, over time [m]. Starts with `height` and `speed`
  /// (downwards negative); central differences.
  inline ReducedMotion
  reduced_motion(const ReducedWheel                  &wheel,
                 const std::function<double(double)> &path,
                 double                               height,
                 double                               speed,
                 const double                         duration,
                 const double                         step = 1e-7)
  {
    ReducedMotion motion;
    const double  start = height;
    for (double t = 0; t < duration; t += step)
      {
        const double force = wheel.force(path(t) - height);
        motion.time.push_back(t);
        motion.force.push_back(force);
        motion.height.push_back(height);
        const double acceleration =
          (force - wheel.load - wheel.suspension * (height - start)) / wheel.unsprung;
        speed += (t == 0 ? 0.5 : 1) * step * acceleration;
        height += step * speed;
      }
    return motion;
  }

  /// Height at which a rigid wheel with a fresh flat touches a plane rail, its centre over x, the middle of
  /// the flat over `place` [m]: it pivots about one edge, then about the other.
  inline double
  rigid_path_of_flat(const double x, const double place, const double length, const double radius)
  {
    const double half = std::asin(0.5 * length / radius), angle = std::abs(x - place) / radius;
    return angle < half ? -radius * (1 - std::cos(half - angle)) : 0;
  }
} // namespace test
