// label: fast

// Plane waves in bars and blocks: speed, plateau of the stress, reflection, orders of convergence.

#include "scenes/pulse.h"

#include "parallel.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace scenes;
using namespace wheelrail;

namespace
{
  void
  orders(Bar bar)
  {
    const Pulse         pulse{1e-3, 0.5 * bar_length / bar.speed()};
    std::vector<double> error;
    for (const unsigned int cells : {40, 80, 160})
      {
        bar.cells = cells;
        error.push_back(pulse_error(bar, pulse, 0.5 * bar_length / cells / bar.speed()));
      }
    std::cout << "        errors at 40, 80, 160 cells: " << error[0] << " " << error[1] << " " << error[2]
              << "\n";
    BOOST_TEST(
      test::near(std::log2(error[1] / error[2]), 2, 0.1, bar.name() + ": order in cell size and step"));
    BOOST_TEST(error[2] < 1e-3, bar.name() + ": error at 160 cells below 0.1 %");
  }

  /// The step alone: against the solution of the same mesh with a small step.
  void
  order_in_time(Bar bar)
  {
    bar.cells = 40;
    const Pulse  pulse{1e-3, 0.5 * bar_length / bar.speed()};
    const double unit = bar_length / bar.cells / bar.speed(), end = 1.4 * bar_length / bar.speed();
    const auto   places = [&](const double step) {
      BarScene   scene(bar, [=](const double t) { return pulse.displacement(t); });
      const auto steps = static_cast<unsigned int>(std::ceil(end / step));
      scene.time_step  = end / steps;
      while (scene.steps() < steps)
        scene.step();
      return scene.solid.displacement;
    };
    const auto          exact = places(unit / 64);
    std::vector<double> error;
    for (const double part : {0.8, 0.4, 0.2})
      {
        const auto u   = places(part * unit);
        double     sum = 0;
        for (std::size_t k = 0; k < u.size(); ++k)
          sum += std::pow(u[k] - exact[k], 2);
        error.push_back(std::sqrt(sum));
      }
    BOOST_TEST(test::near(std::log2(error[1] / error[2]), 2, 0.1, bar.name() + ": order in the step alone"));
  }

  /// Velocity and stress of the pulse before and at the reflection, and its speed between two places.
  void
  reflection(Bar bar)
  {
    bar.cells      = 120;
    const double c = bar.speed(), rho = bar.setup.material.density;
    const Pulse  pulse{1e-3, 0.5 * bar_length / c};
    BarScene     scene(bar, [=](const double t) { return pulse.displacement(t); });
    const double h = bar_length / bar.cells;
    unsigned int node[3]; // near the start, near the end, at the end
    const double place[3] = {30 * h, 80 * h, bar_length};
    for (int k = 0; k < 3; ++k)
      node[k] = select(scene.solid.mesh, [&](const Vector3 &X) {
                  return norm(X - Vector3{place[k], 0, 0}) < 1e-9;
                }).front();
    double peak = 0, end_velocity = 0, end_stress = 0, sum[2] = {}, moment[2] = {};
    while (scene.time() < 1.5 * bar_length / c)
      {
        scene.step();
        const double t = scene.time() - 0.5 * scene.time_step;
        for (int k = 0; k < 2; ++k)
          if (const double v = scene.solid.velocity[4 * node[k]]; t < place[k] / c + 1.05 * pulse.duration)
            sum[k] += v, moment[k] += v * t;
        peak         = std::max(peak, scene.solid.velocity[4 * node[0]]);
        end_velocity = std::max(end_velocity, scene.solid.velocity[4 * node[2]]);
        end_stress   = std::max(end_stress,
                              std::abs(element_stress(scene.solid.blocks.wheel,
                                                      scene.solid.displacement.data())[bar.cells - 1][0]));
      }
    const double speed = (place[1] - place[0]) / (moment[1] / sum[1] - moment[0] / sum[0]);
    BOOST_TEST(
      test::near(speed / c, 1, 2e-3, bar.name() + ": speed of the pulse over " + std::to_string(c) + " m/s"));
    BOOST_TEST(test::near(peak / pulse.peak, 1, 2e-3, bar.name() + ": peak velocity on the way"));
    if (bar.end == End::free)
      BOOST_TEST(test::near(end_velocity / pulse.peak, 2, 5e-3, bar.name() + ": velocity doubles"));
    else
      BOOST_TEST(test::near(end_stress / (rho * c * pulse.peak), 2, 5e-3, bar.name() + ": stress doubles"));
  }

  /// The end starts to move with a jump: rho c v behind the front.
  void
  plateau(Bar bar)
  {
    const double velocity = 1e-2, c = bar.speed();
    bar.setup.bulk_viscosity = 0.06;
    bar.cells                = 150;
    BarScene scene(bar, [=](const double t) { return velocity * t; });
    while (scene.time() < 0.8 * bar_length / c)
      scene.step();
    const auto   stress = element_stress(scene.solid.blocks.wheel, scene.solid.displacement.data());
    double       mean = 0, largest = 0, front = 0;
    unsigned     count = 0;
    const double exact = bar.setup.material.density * c * velocity;
    for (unsigned int e = 0; e < bar.cells; ++e)
      {
        const double x = (e + 0.5) * bar_length / bar.cells;
        if (x < 0.6 * bar_length)
          mean -= stress[e][0], ++count;
        largest = std::max(largest, -stress[e][0]);
        if (-stress[e][0] > 0.5 * exact)
          front = x + 0.5 * bar_length / bar.cells;
      }
    BOOST_TEST(test::near(mean / count / exact, 1, 2e-3, bar.name() + ": mean of the plateau over rho c v"));
    BOOST_TEST(
      test::near(front / (c * scene.time()), 1, 1e-2, bar.name() + ": place of the front at half height"));
    BOOST_TEST(largest < 1.2 * exact,
               bar.name() + ": overshoot at the front " + std::to_string(largest / exact - 1));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(solid_waves, test::Parallel)
{
  for (const Setup &setup : each_form(Setup()))
    for (const bool confined : {false, true})
      {
        Bar bar{setup, 100, confined, End::free};
        // every node of the bar lies on a free edge, beyond what the estimate of the step covers
        bar.setup.step_factor = confined ? 0.95 : 0.7;
        if (!confined)
          bar.setup.material.poissons_ratio = 0; // a wave of one dimension, exact to all orders
        plateau(bar);
        order_in_time(bar);
        for (const End end : {End::free, End::fixed})
          {
            bar.end = end;
            orders(bar);
            reflection(bar);
          }
      }
}
