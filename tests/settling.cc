// label: fast

// From where on a history stays at its final value.
#include "near.h"

#include <wheelrail/sampling/settling.h>

#include <cmath>
#include <string>

using namespace wheelrail;
using test::near;


BOOST_AUTO_TEST_CASE(times_to_settle)
{
  // 10 exp(-z / 10 mm) above 100, with a ripple of 3 that repeats every millimetre
  std::vector<double> distance, ripple, smooth;
  for (int k = 0; k <= 4000; ++k)
    {
      const double z = 0.1 * k / 4000;
      distance.push_back(z);
      smooth.push_back(100 + 10 * std::exp(-z / 0.01));
      ripple.push_back(smooth.back() + 3 * std::sin(2 * M_PI * z / 1e-3));
    }
  const double exact = 0.01 * std::log(10.);
  BOOST_TEST(
    near(settled_after(distance, smooth, 100, 1, 0), exact, 3e-5, "10 exp(-z/10 mm) falls below 1 [m]"));
  // the mean over 2 mm behind lags by 1 mm
  BOOST_TEST(near(settled_after(distance, ripple, 100, 1, 2e-3),
                  exact + 1e-3,
                  2e-4,
                  "the same under a ripple of the cells [m]"));
  BOOST_TEST(settled_after(distance, ripple, 100, 1, 0) > 0.099,
             "without the window the ripple never settles");
  BOOST_TEST(std::isinf(settled_after(distance, smooth, 105, 1, 0)), "away from the final value: infinity");
  BOOST_TEST(settled_after(distance, smooth, 100, 20, 0) == 0, "settled from the start");
  const Settling calm = settling(distance, ripple, {0.08, 1}, 100, 2e-3);
  BOOST_TEST(near(calm.after, exact + 1e-3, 2e-4, "a figure of 100 comes within 1 % [m]"));
  BOOST_TEST(calm.swing < 1e-3, "and then hardly swings");
  // nodes that flicker by 1 % in pieces of 4 mm to the end: noise that belongs to the figure
  std::vector<double> flicker, stick_slip;
  for (const double z : distance)
    {
      flicker.push_back(100 + 0.9 * std::sin(2 * M_PI * z / 4e-3) + (std::fmod(z, 0.031) < 2e-3 ? 0.6 : 0));
      stick_slip.push_back(2.8e-3 * (1 - std::cos(2 * M_PI * z / 20e-3)));
    }
  BOOST_TEST((settling(distance, flicker, {0.03, 1}, 100, 2e-3).after < 2e-3),
             "noise to the end does not unsettle a figure");
  const Settling wild = settling(distance, stick_slip, {0.06, 1}, 2.8e-3, 2e-3);
  BOOST_TEST(std::isinf(wild.after), "a creepage between 0 and 5.6e-3 is never steady");
  BOOST_TEST(near(wild.swing, 0.70, 0.02, "its swing, 1/sqrt(2) less what the window takes"));
  std::vector<double> leaves = smooth;
  for (std::size_t k = 0; k < leaves.size(); ++k)
    leaves[k] += distance[k] > 0.07 ? 5 : 0;
  BOOST_TEST((settling(distance, leaves, {0.05, 0.07}, 100, 2e-3).after < 0.05),
             "what comes after the stretch of the means does not count");
  BOOST_TEST(std::isinf(settling(distance, leaves, {0.05, 0.1}, 100, 2e-3).after), "within it, it does");
  // slope and noise are judged apart: a trend of 6.9 % over the stretch of the means, clean and under noise
  // that goes on from value to value (blocks count as independent, single values do not)
  std::vector<double> trend, noisy, flat;
  double              walk = 0;
  unsigned int        seed = 1;
  for (const double z : distance)
    {
      seed = 1664525u * seed + 1013904223u;
      walk = 0.97 * walk + 0.2 * (seed / 4294967296. - 0.5); // correlated over 0.8 mm, deviation 0.24
      trend.push_back(100 + 6.9 * (z - 0.08) / 0.04);
      noisy.push_back(trend.back() + walk);
      flat.push_back(100 + walk);
    }
  const Settling clean = settling(distance, trend, {0.06, 0.1}, 100, 2e-3);
  BOOST_TEST(near(clean.drift, 0.069, 1e-4, "a linear trend of 6.9 % is found"));
  BOOST_TEST(clean.swing < 1e-6, "and is no noise");
  BOOST_TEST(clean.after > 0.06, "so the figure is not steady where the means begin");
  const Settling drifts = settling(distance, noisy, {0.06, 0.1}, 100, 2e-3);
  BOOST_TEST(near(drifts.drift, 0.069, 4e-3, "under noise, too"));
  BOOST_TEST(
    near(drifts.swing, settling(distance, flat, {0.06, 0.1}, 100, 2e-3).swing, 5e-4, "which is the same"));
  // how often 100 stretches of nothing but noise are taken for a trend: 2 errors of few blocks, one in ten or
  // so
  int mistaken = 0;
  for (int k = 0; k < 100; ++k)
    {
      std::vector<double> values;
      for (std::size_t i = 0; i < distance.size(); ++i)
        {
          seed = 1664525u * seed + 1013904223u;
          walk = 0.97 * walk + 0.2 * (seed / 4294967296. - 0.5);
          values.push_back(100 + walk);
        }
      mistaken += settling(distance, values, {0.06, 0.1}, 100, 2e-3).drift > 0 ? 1 : 0;
    }
  BOOST_TEST(mistaken <= 15, "noise is rarely taken for a trend: " + std::to_string(mistaken) + " of 100");
  const Mean mean = mean_over(distance, ripple, {0.09, 1});
  BOOST_TEST(near(mean.mean, 100, 2e-3, "mean over the last tenth"));
  BOOST_TEST(near(mean.deviation, 3 / std::sqrt(2.), 5e-3, "deviation of the ripple"));
}
