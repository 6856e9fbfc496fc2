// Wear of odd mixes and profiles: two patches on the flange, noise, ends of a profile, bad numbers.

#include "messages.h"
#include "worn_profiles.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/wear/wear_evolution.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

using namespace wheelrail;
using test::near;
using test::worn;

namespace
{
  Scene
  small()
  {
    return test::wearing_scene(0.1, 50e6);
  }

  /// At -5.5 mm tread and flange root carry: both wear, the flange at its side.
  BOOST_AUTO_TEST_CASE(test_flange)
  {
    Scene scene                = small();
    scene.lateral_shift        = -5.5e-3;
    scene.wear_plan.gross_load = 1e6;
    const WearState state      = worn(scene);
    BOOST_TEST(state.finished, "flange wear goes to its end");
    BOOST_TEST(state.steps.back().rail_section > 0, "the rail wears");
    const WornShape &rail   = state.rail;
    double           corner = 0;
    for (std::size_t k = 0; k < rail.depth.size(); ++k)
      if (rail.points[k].x < -20e-3)
        corner = std::max(corner, rail.depth[k]);
    BOOST_TEST(corner > 0.5 * state.steps.back().rail_depth, "most at the gauge corner");
  }

  /// A measured rail with noise of 10 um wears as the clean one, and its noise does not grow.
  BOOST_AUTO_TEST_CASE(test_noise)
  {
    const WornShape clean = rail_shape(read_profiles(Scene()).rail);
    std::ofstream   file("noisy_rail.txt");
    for (std::size_t k = 0; k < clean.points.size(); ++k)
      file << 1e3 * clean.points[k].x << ' '
           << 1e3 * clean.points[k].y + 0.01 * std::sin(12.9898 * double(k) * double(k)) << '\n';
    file.close();
    Scene noisy        = small();
    noisy.rail_profile = "noisy_rail.txt";
    const WearState a = worn(small()), b = worn(noisy);
    BOOST_TEST(b.finished, "a profile with noise wears to the end");
    BOOST_TEST(
      near(b.steps.back().rail_section / a.steps.back().rail_section, 1, 0.1, "as much as the clean one"));
    BOOST_TEST(b.steps.back().mean_pressure < 1.1 * b.steps.front().mean_pressure, "the noise does not grow");
  }

  /// A patch on the end of a profile is told.
  BOOST_AUTO_TEST_CASE(test_ends)
  {
    const WornShape clean = rail_shape(read_profiles(Scene()).rail);
    std::ofstream   file("short_rail.txt");
    for (const Point2 &p : clean.points)
      if (p.x < 1e-3)
        file << 1e3 * p.x << ' ' << 1e3 * p.y << '\n';
    file.close();
    Scene scene        = small();
    scene.rail_profile = "short_rail.txt";
    std::string told;
    try
      {
        const WearState state = worn(scene);
        told                  = state.note;
      }
    catch (const InputError &error)
      {
        told = error.what();
      }
    BOOST_TEST(!told.empty(), "a profile that ends below the patch: " + told);
  }

  BOOST_AUTO_TEST_CASE(test_bad_numbers)
  {
    const std::string prm  = WHEELRAIL_SOURCE_DIR "/prm/wear.prm";
    const auto        said = [&](const std::string &set) {
      std::ostringstream out;
      return test::message_of([&]() { execute({"wear", prm, "--no-pictures", "--set", set}, {}, out); });
    };
    const std::string negative = said("Wear/Gross load = -1 Mt");
    BOOST_TEST(
      (negative.find("Gross load") != std::string::npos && negative.find("0 Mt") != std::string::npos),
      "negative tonnage: " + negative);
    const std::string never = said("Wear/Grind every = 0 Mt");
    BOOST_TEST((never.find("Grind every") != std::string::npos), "no interval: " + never);
    const std::string unknown = said("Wear/Grind to = 99E9");
    BOOST_TEST((unknown.find("99E9") != std::string::npos && unknown.find("54E1") != std::string::npos),
               "an unknown target: " + unknown);
  }

  /// A wheel that locks or spins up is no traffic: its wear would have no end.
  BOOST_AUTO_TEST_CASE(test_sliding)
  {
    for (const double traction : {0.6, -0.6})
      {
        Scene scene                = small();
        scene.traction_coefficient = traction;
        const std::string said     = test::message_of([&]() { worn(scene); });
        BOOST_TEST(
          test::same_text(said,
                          "the scene: friction does not carry the traction, so that the wheel locks or spins "
                          "up; take less traction, or give the creepage of a wheel that slides",
                          "traction beyond friction"));
      }
  }

  /// Weights of 3 and 1 are shares of 3/4 and 1/4.
  BOOST_AUTO_TEST_CASE(test_weights)
  {
    Scene scene         = small();
    scene.wear_plan.mix = "weights.csv";
    std::ofstream("weights.csv") << "lateral shift [mm],weight\n0,3\n1,1\n";
    double     weights = 1;
    const auto rows    = mix_rows(scene, scene.wheel_load, weights);
    BOOST_TEST(near(weights, 4, 1e-12, "what the weights add up to"));
    BOOST_TEST(near(rows[0].share, 0.75, 1e-12, "share of the first row"));
  }
} // namespace
