// A Hertzian line load that passes again and again over a strip of perfectly plastic elements, without
// friction: first yield where the stresses of the half-space put it, shakedown below 4 k, flow in every
// passage above. The whole table, with friction and hardening: shakedown_limits.

#include "scenes/rolled_strip.h"

#include "parallel.h"
#include "strip_steel.h"

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace scenes;
using namespace wheelrail;
using test::near;

namespace
{
  const double k = test::strip_k;

  /// How much the largest plastic strain over depth grows in each pass.
  std::vector<double>
  growths(const double peak, const unsigned int passes)
  {
    RolledStrip         strip({peak, 0, 6}, test::strip_steel());
    std::vector<double> result, before(strip.depth.size(), 0.);
    std::cout << "        " << peak / k << " k:";
    for (unsigned int n = 0; n < passes; ++n)
      {
        const StripPass pass = strip.pass();
        result.push_back(growth(before, pass.strain, 1));
        before = pass.strain;
        std::cout << ' ' << 1e6 * result.back();
      }
    std::cout << " [1e-6]\n";
    BOOST_TEST(near(strip.scene.energy().error(), 0, 1e-3, "energy error"));
    return result;
  }

  /// Far from where the load came down, after one pass.
  void
  residual()
  {
    RolledStrip strip({3.8 * k, 0, 6, 24}, test::strip_steel());
    strip.pass();
    const StripResidual left = strip.unload(19, 21);
    std::cout << "        residual stress up to " << left.largest / k << " k\n";
    BOOST_TEST(left.largest > 0.5 * k, "residual stresses are left");
    BOOST_TEST(near(left.other, 0, 0.02, "those that equilibrium does not admit, over the largest"));
    BOOST_TEST(near(left.spread, 0, 0.03, "range along the strip at equal depth, over the largest"));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(shakedown, test::Parallel)
{
  RolledStrip elastic({k, 0, 10, 24}, Setup());
  const auto  largest = elastic.largest_stresses();
  BOOST_TEST(near(std::sqrt(3.) / largest[0] / 3.107, 1, 0.02, "p0 at first yield over 3.107 k"));
  BOOST_TEST(near(1 / largest[1] / 4, 1, 0.01, "p0 at which the shear stress reaches k, over 4 k"));
  if (test::sanitized)
    return;

  const auto down = growths(3.8 * k, 4), on = growths(4.2 * k, 5);
  BOOST_TEST(down[1] > 5e-5, "flows at 3.8 k");
  BOOST_TEST(near(down[3] / down[1], 0, 0.02, "and nearly no more two passes later"));
  BOOST_TEST(on[4] > 0.4 * on[1], "flows on at 4.2 k: " + std::to_string(on[4] / on[1]));
  residual();
}
