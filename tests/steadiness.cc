// label: fast

// Whether means of a run are steady and known: made-up histories with noise, slopes and forces out of
// balance.
#include "near.h"

#include <wheelrail/base/format_text.h>
#include <wheelrail/sampling/creep_scale.h>
#include <wheelrail/sampling/steadiness.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

using namespace wheelrail;
using test::near;

namespace
{
  constexpr double load = 100e3, friction = 0.5, force = 25e3;

  /// What is wrong with a made-up run.
  struct Faults
  {
    double noise  = 1e-4; ///< of all results, relative, new in every cell
    double slope  = 0;    ///< of the area [1/m], relative
    double load   = 0;    ///< of the vertical force, relative
    double torque = 0;    ///< of the longitudinal force over friction times load
    double rolled = 60e-3;
  };

  /// Rows of a wheel with a patch of 13 x 20 mm on cells of 1 mm, sixteen a cell.
  std::pair<History, History>
  made_up(const Faults &faults)
  {
    History history, patches;
    history.names = split_list(
      "rolled_distance, normal_force, vertical_force, longitudinal_force, lateral_force, creepage, "
      "yaw_moment, drive_torque");
    patches.names = split_list(
      "rolled_distance, max_pressure, max_pressure_fitted, contact_area, patch_lateral, patch_longitudinal, "
      "patch_centre_lateral, patch_centre_longitudinal, max_shear_traction, stick_fraction, t_gamma");
    history.columns.resize(history.names.size());
    patches.columns.resize(patches.names.size());
    std::mt19937                     generator(1);
    std::normal_distribution<double> normal;
    double                           noise = 0;
    int                              cell  = -1;
    for (double z = 0; z < faults.rolled; z += 1e-3 / 16)
      {
        if (int(z / 1e-3) != cell)
          {
            cell  = int(z / 1e-3);
            noise = faults.noise * normal(generator);
          }
        // a ripple that repeats from cell to cell
        const double n   = 1 + noise + 5e-3 * std::sin(2 * M_PI * z / 1e-3);
        const double h[] = {z,
                            load * n,
                            load * n * (1 + faults.load),
                            (force + faults.torque * friction * load) * n,
                            1e3 * n,
                            2e-3 * n,
                            19e3 * n,
                            11.5e3};
        const double p[] = {z,
                            1.2e9 * n,
                            1.2e9 * n,
                            190e-6 * n * (1 + faults.slope * z),
                            20e-3 * n,
                            13e-3 * n,
                            -7e-3,
                            2e-5,
                            570e6 * n,
                            0.7 * n,
                            47 * n};
        for (std::size_t c = 0; c < std::size(h); ++c)
          history.columns[c].push_back(h[c]);
        for (std::size_t c = 0; c < std::size(p); ++c)
          patches.columns[c].push_back(p[c]);
      }
    return {history, patches};
  }

  SteadyBasis
  basis()
  {
    SteadyBasis known;
    known.load         = load;
    known.torque_force = force;
    known.friction     = friction;
    known.slowest      = slow_length(140 / 3.6);
    return known;
  }

  Steadiness
  judged(const Faults &faults)
  {
    const auto [history, patches] = made_up(faults);
    return judge_steadiness(history, patches, basis());
  }

  void
  refused(const Faults &faults, const std::string &reason)
  {
    const Steadiness found = judged(faults);
    BOOST_TEST((!found.steady() && found.open.find(reason) != std::string::npos),
               "not steady: " + reason + " (" + found.open + ")");
  }

  const KnownResult &
  result(const Steadiness &known, const std::string &figure)
  {
    for (const KnownResult &one : known.results)
      if (one.figure == figure)
        return one;
    throw std::logic_error(figure);
  }
} // namespace


BOOST_AUTO_TEST_CASE(steadiness)
{
  const Steadiness calm = judged({});
  BOOST_TEST(calm.steady(), "noise of 0.01 % in every cell is steady " + calm.open);
  const double cells = (calm.stretch.s1 - calm.stretch.s0) / 1e-3;
  BOOST_TEST(near(cells, std::round(cells), 1e-6, "a whole number of cells"));
  BOOST_TEST((cells >= 8 && calm.stretch.s0 >= 13e-3), "a stretch from one patch length past the start on");
  BOOST_TEST(near(result(calm, "contact_area").mean.mean, 190e-6, 2e-8, "the mean of the area [m2]"));
  BOOST_TEST(result(calm, "contact_area").error() < 1e-3 * 190e-6, "and its standard error");

  refused({2e-2}, "noise of the");
  Faults slope;
  slope.slope = 0.3; // 0.03 % a mm, 1 % over the path in which the wheel's slowest mode turns by a radian
  refused(slope, "slope of the contact area");
  // a slope that does not stand out of the noise: the error of the mean holds what it changes in a patch
  // length
  const KnownResult area = result(calm, "contact_area");
  BOOST_TEST((area.drift == 0 && area.trend > 0 && area.error() > area.trend && area.error() > area.noise),
             "no slope of the area is known, and what it may come to is in its error");
  Faults heavy;
  heavy.load = 2e-3;
  refused(heavy, "vertical force against the load");
  Faults driven;
  driven.torque = -3e-3;
  refused(driven, "longitudinal force against the torque");
  Faults brief;
  brief.rolled = 20e-3;
  refused(brief, "results are judged from");

  // a force that is off by 0.05 % of the friction bound, which is let pass, stands in the error of the
  // creepage with what the creep curve makes of it
  Faults slightly;
  slightly.torque           = 5e-4;
  const Steadiness off      = judged(slightly);
  const CreepScale creep    = creep_scale(friction * load, 81e9, 13e-3, 20e-3);
  const double     expected = 5e-4 * friction * load / (creep.stiffness * creep.tangent(force));
  BOOST_TEST(off.steady(), "off by 0.05 % passes " + off.open);
  BOOST_TEST(
    near(result(off, "creepage").balance / expected, 1, 0.1, "its part of the error of the creepage"));

  // Kalker's coefficients of a circle at a Poisson's ratio of 1/4, and the law of Vermeulen and Johnson
  const CreepScale circle = creep_scale(1, 1, 2, 2);
  BOOST_TEST(near(circle.stiffness, 4.12, 1e-12, "C11 of a circle"));
  BOOST_TEST(near(circle.lateral, 3.67, 1e-12, "C22 of a circle"));
  BOOST_TEST(near(circle.tangent(0), 1, 1e-12, "slope without force"));
  BOOST_TEST(near(circle.tangent(1), 0, 1e-12, "slope of a patch that slides"));
  const double c = circle.half_saturation() * circle.stiffness / 3;
  BOOST_TEST(near(1 - std::pow(1 - c, 3), 0.5, 1e-12, "half of the friction bound"));
}
