// Hertz's point, ellipse and line contact, relaxed with the explicit scheme: errors against the exact
// solution at 2 and 1 mm cells, and the loss of pressure by the penalty layer.

#include "parallel.h"
#include "scenes/hertz_scene.h"

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace scenes;
using namespace test;

namespace
{
  HertzRun
  run(const HertzShape shape, const double cell, const double scale, const bool filter = true)
  {
    const HertzRun result = run_hertz(shape, cell, scale, filter);
    std::cout << hertz_row(shape, cell, scale, &result) << (filter ? "" : "  no filter") << std::endl;
    return result;
  }

  void
  cells(const HertzShape shape, const std::string &name)
  {
    const HertzRun coarse = run(shape, 2e-3, 10), fine = run(shape, 1e-3, 10);
    BOOST_TEST(near(fine.force, 0, 1e-4, name + ": the contact carries the load"));
    BOOST_TEST(near(coarse.peak, 0, 0.015, name + ", 2 mm: peak pressure"));
    BOOST_TEST(near(fine.peak, 0, 0.01, name + ", 1 mm: peak pressure"));
    if (shape != HertzShape::line)
      BOOST_TEST(near(fine.approach, 0, 0.01, name + ", 1 mm: approach"));
    BOOST_TEST(near(coarse.area, 0, 0.02, name + ", 2 mm: area or width"));
    BOOST_TEST(near(fine.area, 0, 0.02, name + ", 1 mm: area or width"));
    BOOST_TEST(near(fine.mises, 0, 0.02, name + ", 1 mm: largest von Mises stress"));
    if (shape == HertzShape::point) // Johnson, Contact Mechanics (1985), equation 3.43: -(1 + 2 nu)/2
      BOOST_TEST(
        near(fine.surface, -0.8, 0.03, name + ", 1 mm: stress along the surface over the peak pressure"));
    // the penalty layer, of first order, takes its share of the stress too
    BOOST_TEST((std::abs(fine.peak) < 0.7 * std::abs(coarse.peak) &&
                std::abs(fine.mises) < 0.75 * std::abs(coarse.mises) &&
                std::abs(fine.depth) < 0.5 * std::abs(coarse.depth)),
               name + ": smaller cells are better");
  }

  /// What the surface filter is for: the area of patches that are a few cells wide.
  void
  without_filter()
  {
    const HertzRun with = run(HertzShape::point, 2e-3, 10), without = run(HertzShape::point, 2e-3, 10, false);
    BOOST_TEST(std::abs(with.area) < 0.3 * std::abs(without.area), "2 mm: the filter mends the area");
    BOOST_TEST(std::abs(with.peak) < 0.7 * std::abs(without.peak), "2 mm: and the peak pressure");
  }

  /// A half-space solver with the layer loses this much of the peak pressure (ellipse, 1 mm cells).
  void
  penalty_sweep()
  {
    struct Row
    {
      double scale, peak, area;
    };
    const std::vector<Row> expected = {
      {30, -0.002, 0.005}, {3, -0.020, 0.046}, {1, -0.055, 0.12}, {0.1, -0.325, 0.79}};
    for (const Row &row : expected)
      {
        const HertzRun    result = run(HertzShape::ellipse, 1e-3, row.scale);
        const std::string name   = "f = " + std::to_string(row.scale).substr(0, 4);
        BOOST_TEST(
          near((1 + result.peak) / (1 + row.peak), 1, 0.005, name + ": peak pressure over the half-space's"));
        BOOST_TEST(near((1 + result.area) / (1 + row.area), 1, 0.03, name + ": area over the half-space's"));
      }
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(contact_hertz, test::Parallel)
{
  std::cout << hertz_row(HertzShape::point, 0, 0, nullptr) << std::endl;
  cells(HertzShape::line, "line");
  without_filter();
  if (!sanitized)
    {
      cells(HertzShape::point, "point");
      cells(HertzShape::ellipse, "ellipse");
      penalty_sweep();
    }
}
