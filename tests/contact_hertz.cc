// Hertz's point, ellipse and line contact, relaxed with the explicit scheme: errors against the exact
// solution at 2 and 1 mm cells, and the loss of pressure by the penalty layer.

#include "check.h"
#include "scenes/hertz_scene.h"

using namespace scenes;
using namespace test;

namespace
{
  HertzRun
  run(const HertzShape shape, const double cell, const double scale)
  {
    const HertzRun result = run_hertz(shape, cell, scale);
    std::cout << hertz_row(shape, cell, scale, &result) << std::endl;
    return result;
  }

  void
  cells(const HertzShape shape, const std::string &name)
  {
    const HertzRun coarse = run(shape, 2e-3, 10), fine = run(shape, 1e-3, 10);
    check_near(fine.force, 0, 1e-4, name + ": the contact carries the load");
    check_near(fine.peak, 0, 0.01, name + ", 1 mm: peak pressure");
    if (shape != HertzShape::line)
      check_near(fine.approach, 0, 0.01, name + ", 1 mm: approach");
    check_near(fine.mises, 0, 0.03, name + ", 1 mm: largest von Mises stress");
    check_near(fine.area, 0, 0.05, name + ", 1 mm: area or width");
    check(std::abs(fine.peak) < 0.7 * std::abs(coarse.peak) && std::abs(fine.area) < std::abs(coarse.area) &&
            std::abs(fine.mises) < 0.6 * std::abs(coarse.mises),
          name + ": smaller cells are better");
  }

  /// With the surface filter, as the program computes by default.
  void
  filtered(const HertzShape shape, const std::string &name, const double cell, const double limit)
  {
    const HertzRun result = run_hertz(shape, cell, 10, true);
    std::cout << hertz_row(shape, cell, 10, &result) << "  filtered" << std::endl;
    check_near(result.force, 0, 1e-4, name + ", filtered: the contact carries the load");
    check_near(result.peak, 0, limit, name + ", filtered: peak pressure");
    if (shape != HertzShape::line)
      check_near(result.approach, 0, 0.01, name + ", filtered: approach");
    check_near(result.area, 0, 0.02, name + ", filtered: area or width");
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
        check_near(result.peak, row.peak, 0.01, name + ": loss of peak pressure");
        check_near(result.area, row.area, 0.04, name + ": growth of the area");
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  Program program(argc, argv);
  std::cout << hertz_row(HertzShape::point, 0, 0, nullptr) << std::endl;
  cells(HertzShape::ellipse, "ellipse");
  cells(HertzShape::line, "line");
  filtered(HertzShape::point, "point, 2 mm", 2e-3, 0.015);
  filtered(HertzShape::point, "point, 1 mm", 1e-3, 0.01);
  filtered(HertzShape::line, "line, 1 mm", 1e-3, 0.01);
  penalty_sweep();
  return report();
}
