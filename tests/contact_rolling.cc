// label: long
// Rolling of an elastic wheel with a crowned profile on an elastic rail against CONTACT: force over creepage,
// spin, coefficients without slip. The tread of a wheel of finite size is stretched around the patch, so that
// it rolls freely at a small creepage, which half-spaces do not know: driving and braking are run both and
// compared by their mean, coefficients by the change of force from one creepage to another. What is left of
// it is of second order.

#include "parallel.h"
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

  /// Force over its bound, along and across, of a row of the table at 0.25 mm; signs of driving and left.
  std::array<double, 2>
  table_row(const std::string &name)
  {
    for (const auto &row : read_table("contact_rolling_hertz.csv"))
      if (row[0] == name && row[1] == "0.25")
        return {-std::stod(row[10]), -std::stod(row[11])};
    BOOST_TEST(false, "tests/reference/contact_rolling_hertz.csv has no row " + name);
    return {};
  }

  /// Kalker's coefficients of this ellipse in CONTACT's finest grid: C11, C22, C23.
  std::array<double, 3>
  coefficients()
  {
    const auto row = read_table("contact_kalker_coefficients.csv").back();
    return {std::stod(row[2]), std::stod(row[3]), std::stod(row[4])};
  }

  /// A force over its bound at a somewhat other creepage: 1 - (1 - F)^(1/3) is proportional to it (Vermeulen
  /// and Johnson 1964).
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
    BOOST_TEST(near(run.peak / result.ellipse.peak, 1, 0.02, "peak pressure over Hertz's"));
    BOOST_TEST(near(run.peak_noise, 0, 0.005, "noise of the peak pressure"));
    // without slip the springs of nodes that leave the patch keep energy that is dropped with them
    if (setup.friction.at_rest < 1)
      BOOST_TEST(
        near(run.energy_error, 0, 0.01, "springs, friction and damping against the work of the forces"));
    return result;
  }

  BOOST_FIXTURE_TEST_CASE(driving_and_braking, test::Parallel)
  {
    const double half  = std::abs(table_row("F1 Fx=0.5")[0]);
    double       force = 0, expected = 0;
    for (const double creepage : {2.084e-3, -2.084e-3})
      {
        RollingPairSetup setup = crowned(false);
        setup.creepage         = creepage;
        const Result found     = rolled(setup);
        BOOST_TEST(found.along * creepage > 0, "the force drives or brakes as the creepage does");
        force += std::abs(found.along);
        expected += scaled(half, found.at_table_load);
      }
    BOOST_TEST(near(
      force / expected, 1, 0.03, "half of the bound: force of driving and braking over CONTACT's, mean"));
  }

  BOOST_FIXTURE_TEST_CASE(along_and_across, test::Parallel)
  {
    const auto   row   = table_row("xi=1e-3 eta=1e-3");
    const double size  = std::hypot(row[0], row[1]);
    double       along = 0, across = 0, expected = 0;
    for (const double creepage : {1e-3, -1e-3})
      {
        RollingPairSetup setup = crowned(true);
        setup.creepage         = creepage;
        setup.lateral_creepage = 1e-3;
        const Result found     = rolled(setup);
        along += std::abs(found.along);
        across += std::abs(found.across);
        expected += scaled(size, found.at_table_load) / size;
      }
    BOOST_TEST(near(along / (expected * std::abs(row[0])),
                    1,
                    0.05,
                    "creepage along and across: force along over CONTACT's, mean of driving and braking"));
    BOOST_TEST(near(across / (expected * std::abs(row[1])),
                    1,
                    0.05,
                    "creepage along and across: force across over CONTACT's, mean of driving and braking"));
  }

  /// Forces without slip settle later and swing with the bodies that carry them: larger ones, a longer way
  /// and a mean over most of it.
  BOOST_FIXTURE_TEST_CASE(without_slip, test::Parallel)
  {
    RollingPairSetup setup = crowned(true);
    setup.friction         = {1000};
    setup.depth            = 40e-3;
    setup.width            = 40e-3;
    setup.distance         = 85e-3;
    setup.averaged         = 30e-3;
    const auto c           = coefficients();

    /// Force on the wheel over G a b, along and across.
    const auto over_stiffness = [](const Result &result) -> std::array<double, 2> {
      const double unit = Elasticity().shear_modulus() * result.ellipse.a * result.ellipse.b;
      return {result.run.force[2] / unit, result.run.force[0] / unit};
    };

    RollingPairSetup creeping = setup;
    creeping.creepage         = 1e-3;
    creeping.lateral_creepage = 1e-3;
    RollingPairSetup spinning = setup;
    spinning.spin             = 0.1;
    const Result creep = rolled(creeping), spun = rolled(spinning);
    const auto   with = over_stiffness(creep), without = over_stiffness(spun);
    // linear, and spin of an ellipse has no force along: the two runs differ by the creepage
    BOOST_TEST(near((with[0] - without[0]) / 1e-3 / c[0], 1, 0.05, "no slip: C11 over CONTACT's"));
    BOOST_TEST(near(std::abs(with[1]) / 1e-3 / c[1], 1, 0.05, "no slip: C22 over CONTACT's"));
    BOOST_TEST(
      near(std::abs(without[1]) / (std::sqrt(spun.ellipse.a * spun.ellipse.b) * spinning.spin) / c[2],
           1,
           0.05,
           "no slip: C23 over CONTACT's"));
  }

  BOOST_FIXTURE_TEST_CASE(spin, test::Parallel)
  {
    RollingPairSetup setup = crowned(true);
    setup.spin             = 0.1;
    const Result found     = rolled(setup);
    // forces of spin over their bound do not depend on the load
    BOOST_TEST(near(
      std::abs(found.across / table_row("phi=0.0001")[1]), 1, 0.05, "spin: lateral force over CONTACT's"));
  }
} // namespace
