// label: long
// Rolling of an elastic wheel with a crowned profile on an elastic rail against CONTACT: force over creepage,
// spin, coefficients without slip, free rolling.

#include "check.h"
#include "reference_table.h"
#include "scenes/rolling_pair.h"

#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>

using namespace scenes;
using namespace test;

namespace
{
  // those of the tables
  constexpr double radius = 0.46, crown = 0.3, friction = 0.5, load = 1e5;

  /// Creepage at which the wheel rolls freely: the strain of its rolling radius, which half-spaces have not.
  /// Measured in spin(); all longitudinal creepages are counted from it.
  constexpr double free_creepage = 6.5e-5;

  /// Force over its bound, along and across, of a row of the table at 0.25 mm; signs of driving and left.
  std::array<double, 2>
  table_row(const std::string &name)
  {
    for (const auto &row : read_table("contact_rolling_hertz.csv"))
      if (row[0] == name && row[1] == "0.25")
        return {-std::stod(row[10]), -std::stod(row[11])};
    check(false, "tests/reference/contact_rolling_hertz.csv has no row " + name);
    return {};
  }

  /// Kalker's coefficients of this ellipse in CONTACT's finest grid: C11, C22, C23.
  std::array<double, 3>
  coefficients()
  {
    const auto row = read_table("contact_kalker_coefficients.csv").back();
    return {std::stod(row[2]), std::stod(row[3]), std::stod(row[4])};
  }

  /// A force over its bound at a somewhat other creepage: 1 - (1 - F)^(1/3) is nearly proportional to it.
  double
  scaled(const double force, const double factor)
  {
    return 1 - std::pow(1 - (1 - std::cbrt(1 - force)) * factor, 3);
  }

  RollingPairSetup
  crowned(const bool whole)
  {
    RollingPairSetup setup;
    setup.strip       = false;
    setup.whole       = whole;
    setup.crown       = crown;
    setup.friction    = {friction};
    setup.velocity    = 60;
    setup.depth       = 30e-3;
    setup.distance    = 55e-3;
    setup.descent     = 94e-6;
    setup.fine_across = 8e-3;
    return setup;
  }

  /// One run and what it is compared by.
  struct Result
  {
    RollingPairRun run;
    Hertz          ellipse{};     ///< of the load found
    double         along, across; ///< force on the wheel over its bound
    double         at_table_load; ///< creepage at the load of the table over that of the run
  };

  Result
  rolled(const RollingPairSetup &setup)
  {
    Result       result{roll(setup), {}, 0, 0, 0};
    const auto  &run     = result.run;
    const double bound   = setup.friction.at_rest * run.force[1];
    result.ellipse       = hertz(run.force[1], radius, crown, 210e9 / (2 * (1 - 0.3 * 0.3)));
    result.along         = run.force[2] / bound;
    result.across        = run.force[0] / bound;
    result.at_table_load = std::cbrt(load / run.force[1]);
    std::cout << std::setprecision(5) << "        friction " << setup.friction.at_rest << ", creepage "
              << setup.creepage << ", lateral " << setup.lateral_creepage << ", spin " << setup.spin
              << " /m: " << 1e-3 * run.force[1] << " kN, forces over bound " << result.along << ", "
              << result.across << ", noise of force " << run.noise << " and peak " << run.peak_noise << ", "
              << run.elements << " cells, " << run.seconds << " s" << std::endl;
    check_near(run.peak / result.ellipse.peak, 1, 0.02, "peak pressure over Hertz's");
    check_near(run.peak_noise, 0, 0.005, "noise of the peak pressure");
    // without slip the springs of nodes that leave the patch keep energy that is dropped with them
    if (setup.friction.at_rest < 1)
      check_near(run.energy_error, 0, 0.01, "springs, friction and damping against the work of the forces");
    return result;
  }

  void
  driving_and_braking()
  {
    const double half = table_row("F1 Fx=0.5")[0];
    for (const double creepage : {2.084e-3, -2.084e-3})
      {
        RollingPairSetup setup = crowned(false);
        setup.creepage         = free_creepage + creepage;
        const Result found     = rolled(setup);
        check_near(std::abs(found.along) / scaled(std::abs(half), found.at_table_load),
                   1,
                   0.03,
                   "half of the bound: force over CONTACT's");
      }
  }

  void
  along_and_across()
  {
    RollingPairSetup setup = crowned(true);
    setup.creepage         = free_creepage + 1e-3;
    setup.lateral_creepage = 1e-3;
    const Result found     = rolled(setup);
    const auto   row       = table_row("xi=1e-3 eta=1e-3");
    const double size = std::hypot(row[0], row[1]), factor = scaled(size, found.at_table_load) / size;
    check_near(std::abs(found.along / (factor * row[0])), 1, 0.05, "creepage along and across: force along");
    check_near(
      std::abs(found.across / (factor * row[1])), 1, 0.05, "creepage along and across: force across");
  }

  /// Forces without slip settle later and swing with the bodies that carry them: larger ones, a longer way
  /// and a mean over most of it.
  void
  without_slip()
  {
    RollingPairSetup setup = crowned(true);
    setup.friction         = {1000};
    setup.depth            = 40e-3;
    setup.width            = 40e-3;
    setup.distance         = 85e-3;
    setup.averaged         = 30e-3;
    const auto c           = coefficients();

    RollingPairSetup creeping = setup;
    creeping.creepage         = free_creepage + 1e-3;
    creeping.lateral_creepage = 1e-3;
    const Result linear       = rolled(creeping);
    const Hertz &h            = linear.ellipse;
    const double unit = Elasticity().shear_modulus() * h.a * h.b * 1e-3, forces = 1000 * linear.run.force[1];
    check_near(std::abs(linear.along) * forces / unit / c[0], 1, 0.05, "no slip: C11 over CONTACT's");
    check_near(std::abs(linear.across) * forces / unit / c[1], 1, 0.05, "no slip: C22 over CONTACT's");

    RollingPairSetup spinning = setup;
    spinning.creepage         = free_creepage;
    spinning.spin             = 0.1;
    const Result spun         = rolled(spinning);
    const double moment       = Elasticity().shear_modulus() * std::pow(spun.ellipse.a * spun.ellipse.b, 1.5);
    check_near(
      std::abs(spun.run.force[0]) / (moment * spinning.spin) / c[2], 1, 0.05, "no slip: C23 over CONTACT's");
  }

  void
  spin()
  {
    RollingPairSetup setup = crowned(true);
    setup.spin             = 0.1;
    const Result found     = rolled(setup);
    // forces of spin over their bound do not depend on the load
    check_near(
      std::abs(found.across / table_row("phi=0.0001")[1]), 1, 0.05, "spin: lateral force over CONTACT's");

    const Hertz &h    = found.ellipse;
    const double unit = Elasticity().shear_modulus() * h.a * h.b * coefficients()[0];
    const double free = -found.run.force[2] / unit;
    std::cout << "        free rolling at a creepage of " << free << std::endl;
    check_near(free, free_creepage, 1e-5, "creepage of free rolling");
  }
} // namespace

int
main(int argc, char **argv)
{
  Program program(argc, argv);
  driving_and_braking();
  along_and_across();
  without_slip();
  spin();
  return report();
}
