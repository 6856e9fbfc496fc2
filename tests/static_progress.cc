// label: fast

// When the search for the static equilibrium is given up.

#include <wheelrail/statics/static_progress.h>

#include "near.h"

#include <cmath>
#include <functional>

using namespace wheelrail;
using namespace test;

namespace
{
  /// Steps until the search counts as stuck, at most 60; `norm`: what is out of balance after a step.
  int
  steps_until_stuck(const std::function<double(int)> &norm)
  {
    StaticProgress progress;
    for (int step = 0; step < 60; ++step)
      if (progress.stuck(norm(step)))
        return step;
    return 60;
  }
} // namespace


BOOST_AUTO_TEST_CASE(static_progress)
{
  BOOST_TEST((steps_until_stuck([](const int k) { return std::pow(0.97, k); }) == 60),
             "slow steps go on: a tenth takes four of them");
  BOOST_TEST((steps_until_stuck([](const int k) { return k % 7 == 0 ? std::pow(0.5, k) : 2.; }) == 60),
             "so do steps that get better now and then");
  BOOST_TEST((steps_until_stuck([](const int k) { return k % 2 == 0 ? 1. : 1.5; }) == 10),
             "a circle of two places ends after ten steps");
  BOOST_TEST((steps_until_stuck([](const int k) { return k < 5 ? 1. / (1 + k) : 0.19; }) == 14),
             "the ten count from the last gain");
  BOOST_TEST((steps_until_stuck([](int) { return std::nan(""); }) <= 10),
             "values that are no numbers get nowhere");
}
