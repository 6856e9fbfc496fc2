#pragma once

// A rigid wheel on a spring that is its contact at rest: what the finite elements have to come to where waves
// in the bodies matter little.

#include "between_rows.h"

#include <wheelrail/wheel/irregular_places.h>

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

  /// Force of the contact at rest over place and lowering of the wheel: half-spaces solved at places along
  /// the track under several forces, and the elasticity of both bodies far from the contact. So it knows that
  /// a loaded wheel sinks before its flat touches, and that an edge is a softer spring than a round wheel.
  class ContactMap
  {
  public:
    /// The scene's irregularities must not lie at 0. `compliance` of the bodies [m/N].
    ContactMap(const wheelrail::Scene           &scene,
               const wheelrail::SceneGeometry   &geometry,
               const double                      compliance,
               const wheelrail::IrregularPlaces &places)
      : places_(places.values)
    {
      for (const double force : {0.1e3, 5e3, 15e3, 30e3, 60e3, 100e3, 150e3, 220e3, 300e3, 400e3, 600e3})
        {
          const auto          found = wheelrail::solve_places(scene, geometry, force, places);
          std::vector<double> lowered;
          for (const wheelrail::PlaceContact &one : found)
            lowered.push_back(found.front().approach + one.drop + compliance * force);
          forces_.push_back(force);
          lowered_.push_back(lowered);
        }
    }

    /// Of the wheel under `force` at a place, from first touch on smooth surfaces [m].
    double
    lowering(const double place, const double force) const
    {
      std::size_t k = 1;
      while (k + 1 < forces_.size() && forces_[k] < force)
        ++k;
      const double low = at(k - 1, place), high = at(k, place), part = share(k, force);
      return low + part * (high - low);
    }

    /// Force at a place under a lowering; between solved ones its power 2/3 is linear, as Hertz has it [N].
    double
    force(const double place, const double lowered) const
    {
      const double first = at(0, place);
      if (lowered <= first)
        return 0;
      std::size_t k   = 1;
      double      low = first, high = at(1, place);
      while (k + 1 < forces_.size() && high < lowered)
        {
          low  = high;
          high = at(++k, place);
        }
      const double part = (lowered - low) / (high - low), q0 = std::pow(forces_[k - 1], 2. / 3),
                   q1 = std::pow(forces_[k], 2. / 3);
      return std::pow(q0 + part * (q1 - q0), 1.5);
    }

  private:
    double
    at(const std::size_t k, const double place) const
    {
      return between_rows(places_, lowered_[k], place);
    }

    double
    share(const std::size_t k, const double force) const
    {
      const double q0 = std::pow(forces_[k - 1], 2. / 3), q1 = std::pow(forces_[k], 2. / 3);
      return (std::pow(force, 2. / 3) - q0) / (q1 - q0);
    }

    std::vector<double>              places_, forces_;
    std::vector<std::vector<double>> lowered_; ///< for each force at each place [m]
  };

  /// `spring`: force over time and height of the wheel [N]. Starts with `height` (upwards) and `speed`, in
  /// balance with the suspension; central differences.
  inline ReducedMotion
  reduced_motion(const ReducedWheel                          &wheel,
                 const std::function<double(double, double)> &spring,
                 double                                       height,
                 double                                       speed,
                 const double                                 duration,
                 const double                                 step = 1e-7)
  {
    ReducedMotion motion;
    const double  start = height;
    for (double t = 0; t < duration; t += step)
      {
        const double force = spring(t, height);
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
} // namespace test
