// label: fast

// Half-spaces have an answer for every drive: where friction does not carry the force the whole patch slides,
// with tractions at Coulomb's bound; braking mirrors driving but for the spin; without torque there is no
// force.

#include "near.h"

#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/wheel/halfspace_case.h>
#include <wheelrail/wheel/halfspace_parts.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;
using test::same_text;

namespace
{
  struct Case
  {
    Case(const std::string &friction, const std::string &traction, const std::vector<std::string> &more = {})
    {
      std::vector<std::string> sets = {"Contact/Friction coefficient = " + friction,
                                       "Wheelset/Traction coefficient = " + traction,
                                       "Half-space/Element size = 0.8 mm"};
      sets.insert(sets.end(), more.begin(), more.end());
      const SceneInput    input    = scene_from_text("", "x.prm", sets);
      const SceneGeometry geometry = require_computable(input);
      result                       = solve_wheel_rail(
        input.scene, geometry, scene_load(input.scene, geometry), scene_offsets(input.scene));
      summary = halfspace_summary(input.scene, result);
    }

    /// Largest distance of a traction from `bound` times pressure, over the peak of the latter.
    double
    off_bound(const double bound) const
    {
      const HalfspaceSolution &s   = result.solution;
      double                   off = 0;
      for (std::size_t e = 0; e < s.pressure.size(); ++e)
        off = std::max(off, std::abs(std::hypot(s.traction_x[e], s.traction_y[e]) - bound * s.pressure[e]));
      return off / (bound * s.peak_pressure);
    }

    WheelRailSolution result;
    Summary           summary;
  };

  BOOST_AUTO_TEST_CASE(test_beyond_friction)
  {
    const Case driven("0.1", "0.25");
    BOOST_TEST(driven.summary.finished, "driven beyond friction: an answer");
    BOOST_TEST(driven.off_bound(0.1) < 1e-9, "tractions are at their bound everywhere");
    BOOST_TEST(near(driven.summary.longitudinal_force / driven.summary.normal_force,
                    0.1,
                    1e-4,
                    "the force is that of friction"));
    BOOST_TEST(std::isnan(driven.summary.creepage), "a wheel that spins up has no creepage of its own");
    BOOST_TEST(near(driven.summary.stick_fraction, 0, 0, "nothing sticks"));
    BOOST_TEST(near(get_figure(driven.summary, "traction_over_friction"), 2.5, 1e-12, "kappa = T / mu"));
    BOOST_TEST(same_text(driven.summary.verdict, "with care", "there is no steady rolling"));
    BOOST_TEST(same_text(
      driven.summary.doubts,
      "The whole patch slides: the wheel spins up, since friction does not carry what drives or brakes it.",
      "the summary says so"));

    const Case braked("0.1", "-0.25");
    BOOST_TEST(near(braked.summary.longitudinal_force / braked.summary.normal_force,
                    -0.1,
                    1e-4,
                    "braked beyond friction: its force, backwards"));
    BOOST_TEST(near(braked.summary.creepage, -1, 0, "the wheel is locked"));
    BOOST_TEST(same_text(
      braked.summary.doubts,
      "The whole patch slides: the wheel locks, since friction does not carry what drives or brakes it.",
      "the summary says so"));
    BOOST_TEST(near(braked.summary.max_pressure / driven.summary.max_pressure,
                    1,
                    1e-3,
                    "the pressure does not know the drive"));
  }

  BOOST_AUTO_TEST_CASE(test_falling_friction)
  {
    // at rest friction would carry the force, at speed it does not
    const Case driven("0.3",
                      "0.25",
                      {"Contact/Friction law = exponential",
                       "Contact/Dynamic friction coefficient = 0.05",
                       "Contact/Friction decay = 20 s/m"});
    BOOST_TEST((driven.summary.finished && !driven.result.solution.within_friction),
               "friction that falls with speed: slides");
    BOOST_TEST(driven.off_bound(0.05) < 1e-6, "with the coefficient of that speed");
  }

  BOOST_AUTO_TEST_CASE(test_within_friction)
  {
    const Case free("0.5", "0"), driven("0.5", "0.25"), braked("0.5", "-0.25");
    BOOST_TEST(
      near(free.summary.longitudinal_force / free.summary.normal_force, 0, 1e-5, "free rolling: no force"));
    BOOST_TEST((free.summary.stick_fraction > 0.5 && free.summary.doubts.find("slides") == std::string::npos),
               "and most of the patch sticks");
    BOOST_TEST((driven.summary.creepage > 0 && braked.summary.creepage < 0),
               "driving and braking have their signs");
    BOOST_TEST(near(
      driven.summary.longitudinal_force / -braked.summary.longitudinal_force, 1, 1e-3, "and equal forces"));
    BOOST_TEST(near(
      get_figure(braked.summary, "traction_over_friction"), -0.5, 1e-12, "kappa has the sign of the drive"));

    const Case yawed("0.5", "0.25", {"Wheelset/Yaw = -50 mrad", "Wheelset/Lateral shift = 4 mm"});
    BOOST_TEST(near(
      yawed.summary.longitudinal_force / 103.2e3, 0.25, 0.05, "yaw: all slides, with the force asked for"));
    BOOST_TEST((yawed.summary.creepage > 0.02 && yawed.summary.creepage < 0.03),
               "so the wheel does not spin up");
    BOOST_TEST(same_text(yawed.summary.doubts.substr(0, 78),
                         "The whole patch slides: friction just carries what drives or brakes the wheel.",
                         "nor does the verdict say so"));

    const Case beside("0.5", "0.25", {"Wheelset/Lateral shift = -4 mm"});
    BOOST_TEST((get_figure(beside.summary, "patches") == 2 &&
                get_figure(beside.summary, "patch_2_stick_fraction") == 0 &&
                beside.summary.doubts.find("slides") == std::string::npos),
               "a patch of some newtons slides beside one that sticks");

    const Case none("0", "0"), spun("0", "0.25");
    BOOST_TEST((none.summary.finished && none.summary.longitudinal_force == 0 && none.summary.doubts.empty()),
               "no friction and no torque: pressure alone");
    BOOST_TEST(
      (spun.summary.finished && spun.summary.longitudinal_force == 0 && !spun.summary.doubts.empty()),
      "no friction and a torque: the wheel spins up");
    BOOST_TEST(std::isnan(get_figure(spun.summary, "traction_over_friction")),
               "kappa is infinite, which no figure is");
  }
} // namespace
