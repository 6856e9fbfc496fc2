// label: fast

// Natural smoothing splines: what they leave of noise, straight lines and circles.

#include "near.h"

#include <wheelrail/contactfiles/section_line.h>
#include <wheelrail/sections/cubic_spline.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;

namespace
{
  using Values = std::vector<double>;

  /// What a smoothing spline makes least: its natural spline has the integral of f''^2 in closed form.
  double
  cost(const Values &s, const Values &y, const Values &w, const Values &f, const double lambda)
  {
    const Values g   = second_derivatives(s, f, SplineEnds::natural);
    double       sum = 0;
    for (std::size_t k = 0; k < s.size(); ++k)
      sum += w[k] * (y[k] - f[k]) * (y[k] - f[k]);
    for (std::size_t k = 0; k + 1 < s.size(); ++k)
      sum += lambda * (s[k + 1] - s[k]) / 3 * (g[k] * g[k] + g[k] * g[k + 1] + g[k + 1] * g[k + 1]);
    return sum;
  }

  BOOST_AUTO_TEST_CASE(test_least)
  {
    std::mt19937_64                        random(7);
    std::uniform_real_distribution<double> off(-1, 1);
    for (const std::size_t n : {3, 4, 5, 12})
      {
        Values s{0}, y, w;
        for (std::size_t k = 0; k < n; ++k)
          {
            y.push_back(off(random));
            w.push_back(1.5 + off(random));
            if (k > 0)
              s.push_back(s.back() + 1.2 + off(random));
          }
        const Values f     = smoothed_values(s, y, w, 0.3);
        const double least = cost(s, y, w, f, 0.3);
        for (std::size_t k = 0; k < n; ++k)
          for (const double step : {-1e-3, 1e-3})
            {
              Values other = f;
              other[k] += step;
              BOOST_TEST(cost(s, y, w, other, 0.3) > least,
                         std::to_string(n) + " points: no values beside cost less");
            }
        double       one = 0, along = 0; // residuals of a regression line have no mean and no slope
        const Values line = smoothed_values(s, y, w, 1e9);
        for (std::size_t k = 0; k < n; ++k)
          {
            one += w[k] * (y[k] - line[k]);
            along += w[k] * s[k] * (y[k] - line[k]);
            BOOST_TEST(near(smoothed_values(s, y, w, 0)[k], y[k], 1e-15, "without a weight all values stay"));
          }
        BOOST_TEST(near(one, 0, 1e-6, "a large weight leaves a line"));
        BOOST_TEST(near(along, 0, 1e-6, "of least squares"));
      }
  }

  /// SMOOTH of CONTACT's files: noise of 10 um on an arc of radius 50 mm falls, a corner stays.
  BOOST_AUTO_TEST_CASE(test_profile)
  {
    std::mt19937_64                  random(3);
    std::normal_distribution<double> noise(0, 0.01);
    ContactProfile                   profile;
    const auto                       arc = [](const double y) { return 50 - std::sqrt(2500 - y * y); };
    for (int k = -80; k <= 80; ++k)
      profile.points.emplace_back(0.25 * k, arc(0.25 * k) + noise(random));
    const auto off = [&](const double smoothing) {
      profile.smoothing = smoothing;
      double sum        = 0;
      for (const Point2 &p : section_points(profile, false))
        sum += std::pow(1e3 * p.y - arc(1e3 * p.x), 2);
      return std::sqrt(sum / 161);
    };
    BOOST_TEST(near(off(0), 0.01, 0.002, "noise"));
    BOOST_TEST(off(5) < 0.5 * off(0), "a smoothed profile has less of it, " + std::to_string(off(5)) + " mm");

    profile.points    = {{-30, 0}, {-20, 0}, {-10, 0}, {-5, 0}, {0, 0}, {4, 4}, {8, 8}, {20, 20}, {30, 30}};
    profile.smoothing = 1;
    const std::vector<Point2> corner = section_points(profile, true);
    for (std::size_t k = 0; k < corner.size(); ++k)
      BOOST_TEST(
        near(1e3 * corner[k].y, profile.points[k].second, 1e-9, "straight sides and their corner stay"));
  }
} // namespace
