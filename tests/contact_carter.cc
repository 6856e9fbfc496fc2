// Rolling of an elastic cylinder on an elastic strip against Carter's solution: force and creepage, pressure,
// noise.

#include "parallel.h"
#include "scenes/rolling_pair.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

using namespace scenes;
using namespace test;

namespace
{
  constexpr double radius = 0.46, friction = 0.5, cell = 1e-3;

  /// Peak pressure and half-width for the load per width (Hertz), force over its bound for the creepage
  /// (Carter 1926): xi = mu (a - a')/R, F/(mu N) = 1 - (a'/a)^2.
  struct Carter
  {
    double half_width, peak, force;
  };

  Carter
  carter(const double load, const double creepage)
  {
    const double modulus = Elasticity().youngs_modulus / (2 * (1 - 0.3 * 0.3));
    const double a       = std::sqrt(4 * load * radius / (M_PI * modulus));
    const double stick   = std::max(0., 1 - std::abs(creepage) * radius / (friction * a));
    return {a, 2 * load / (M_PI * a), std::copysign(1 - stick * stick, creepage)};
  }

  RollingPairSetup
  strip()
  {
    RollingPairSetup setup;
    setup.cell     = cell;
    setup.friction = {friction};
    // a thin strip settles sooner: the force approaches its steady value over a length that grows with the
    // depth
    setup.depth    = 30e-3;
    setup.descent  = 65e-6;
    setup.distance = 70e-3;
    return setup;
  }

  double
  over_bound(const RollingPairRun &run)
  {
    return run.force[2] / (friction * run.force[1]);
  }

  void
  print(const RollingPairSetup &setup, const RollingPairRun &run)
  {
    const Carter line = carter(run.force[1] / cell, setup.creepage);
    std::cout << std::setprecision(5) << "        creepage " << setup.creepage << ": "
              << 1e-3 * run.force[1] / cell << " N/mm, half-width " << 1e3 * line.half_width
              << " mm, F/(mu N) " << over_bound(run) << " (Carter " << line.force << "), noise of force "
              << run.noise << " and peak " << run.peak_noise << ", " << run.steps << " steps, " << run.seconds
              << " s" << std::endl;
  }

  void
  driving_and_braking()
  {
    RollingPairSetup setup = strip();
    double           sum = 0, expected = 0;
    for (const double creepage : {1.592e-3, -1.592e-3})
      {
        setup.creepage           = creepage;
        const RollingPairRun run = roll(setup);
        print(setup, run);
        const Carter line = carter(run.force[1] / cell, creepage);
        BOOST_TEST(near(run.peak / line.peak, 1, 0.01, "peak pressure over Hertz's"));
        BOOST_TEST(near(run.noise, 0, 0.01, "noise of the normal force"));
        BOOST_TEST(near(run.peak_noise, 0, 0.01, "noise of the peak pressure"));
        BOOST_TEST(
          near(run.energy_error, 0, 0.01, "springs, friction and damping against the work of the forces"));
        BOOST_TEST(run.friction_energy > 0.9 * (run.friction_energy + run.damping_energy),
                   "heat is friction's");
        sum += std::abs(over_bound(run));
        expected += std::abs(line.force);
      }
    // driving and braking differ by the strain of the rolling radius, which Carter's half-planes have not
    BOOST_TEST(near(sum / expected, 1, 0.03, "force of driving and braking over Carter's"));
  }

  /// Stations of the wheel that are not those of the rail: the mean holds, the peak is no longer quiet.
  void
  other_stations()
  {
    RollingPairSetup setup     = strip();
    setup.distance             = 50e-3;
    setup.creepage             = 1.592e-3;
    const RollingPairRun equal = roll(setup);
    print(setup, equal);
    setup.wheel_cell_along     = 1.25e-3;
    const RollingPairRun other = roll(setup);
    std::cout << "        cells of the wheel 1.25 mm long:" << std::endl;
    print(setup, other);
    BOOST_TEST(
      near(other.force[1] / equal.force[1], 1, 0.02, "other stations: normal force over that of equal ones"));
    BOOST_TEST(near(
      over_bound(other) / over_bound(equal), 1, 0.03, "other stations: shear force over that of equal ones"));
    BOOST_TEST(other.peak_noise > 2 * equal.peak_noise, "other stations: more noise");
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(contact_carter, test::Parallel)
{
  driving_and_braking();
  if (!sanitized)
    other_stations();
}
