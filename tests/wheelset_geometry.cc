// label: fast

// Wheelset on track: equivalent conicity against closed forms and Klingel's equation, roll that lets
// both wheels touch, further points of contact.

#include "near.h"
#include "reference_table.h"

#include <wheelrail/geometry/conicity.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

using namespace wheelrail;
using test::near;
using test::near_relative;

namespace
{
  constexpr double e = 1.5, r0 = 0.46;

  RadiusDifference
  tabulated(const std::function<double(double)> &f, const double step = 1e-4)
  {
    RadiusDifference result;
    for (int i = 0; i <= 80; ++i)
      {
        result.displacement.push_back(i * step);
        result.value.push_back(f(i * step));
      }
    return result;
  }

  // Wavelength of y'' = -difference(y) / (e r0) by small steps in time (velocity Verlet), from the
  // turning point to the crossing of the track centre: a quarter of it.
  double
  wavelength_by_steps(const RadiusDifference &difference, const double amplitude)
  {
    const double ds           = 2e-4;
    const auto   acceleration = [&](const double y) { return -difference.at(y) / (e * r0); };
    double       y = amplitude, v = 0, s = 0;
    while (true)
      {
        const double a    = acceleration(y);
        const double next = y + ds * v + 0.5 * ds * ds * a;
        if (next <= 0)
          return 4 * (s + ds * y / (y - next));
        v += 0.5 * ds * (a + acceleration(next));
        y = next;
        s += ds;
      }
  }

  BOOST_AUTO_TEST_CASE(test_conicity)
  {
    const auto cone = tabulated([](const double y) { return 2 * 0.05 * y; });
    for (const double amplitude : {1e-3, 3e-3, 7e-3})
      BOOST_TEST(near(equivalent_conicity(cone, amplitude, e, r0),
                      0.05,
                      1e-6,
                      "a cone of 1:20 has conicity 0.05 at " + std::to_string(1e3 * amplitude) + " mm"));

    // a spring with clearance: no difference up to c, then as a cone; the quarter wave is that of the
    // cone from the turning point to c and a straight way across the clearance
    const double c = 1e-3, amplitude = 4e-3, k = 2 * 0.2 / (e * r0);
    const auto   play    = tabulated([c](const double y) { return y < c ? 0 : 2 * 0.2 * (y - c); });
    const double quarter = M_PI / 2 / std::sqrt(k) + c / ((amplitude - c) * std::sqrt(k));
    BOOST_TEST(near(equivalent_conicity(play, amplitude, e, r0),
                    std::pow(M_PI / (4 * quarter), 2) * 2 * e * r0,
                    2e-5,
                    "a clearance of 1 mm before a cone of 0.2"));
    BOOST_TEST(std::isnan(equivalent_conicity(cone, 9e-3, e, r0)), "no conicity beyond the table");
    const auto outwards = tabulated([](const double y) { return -2 * 0.05 * y; });
    BOOST_TEST(std::isnan(equivalent_conicity(outwards, 3e-3, e, r0)),
               "none when the difference pushes outwards");
  }

  BOOST_AUTO_TEST_CASE(test_reference)
  {
    const auto rows = test::read_table("rolling_radius_difference_54E1.csv");
    BOOST_TEST(rows.size() > 60, "the table of rolling radius differences is there");
    RadiusDifference reference;
    for (const auto &row : rows)
      {
        reference.displacement.push_back(1e-3 * std::stod(row[0]));
        reference.value.push_back(1e-3 * std::stod(row[2]));
      }
    const RadiusDifference ours = radius_difference(
      rail_profile("54E1"), wheel_profile("S1002"), TrackDimensions(), RollMode::from_contact, 6e-3, 5e-4);
    double worst = 0;
    for (int i = 0; i <= 12; ++i)
      worst = std::max(worst, std::abs(ours.at(5e-4 * i) - reference.at(5e-4 * i)));
    BOOST_TEST(near(ours.displacement.back(), 6e-3, 1e-15, "difference up to 6 mm [m]"));
    BOOST_TEST(near(worst, 0, 1e-7, "rolling radius difference of S1002 on 54E1 against the table [m]"));
    const RadiusDifference fine = radius_difference(
      rail_profile("54E1"), wheel_profile("S1002"), TrackDimensions(), RollMode::from_contact, 1.1e-3, 1e-6);
    BOOST_TEST(
      near_relative(equivalent_conicity(ours, 1e-3, e, r0),
                    equivalent_conicity(fine, 1e-3, e, r0),
                    1e-3,
                    "conicity at 1 mm, places of jumps found from steps of 0.5 mm, over steps of 1 um"));
    for (const double amplitude : {2e-3, 3e-3, 5e-3})
      {
        const double wavelength = wavelength_by_steps(reference, amplitude);
        BOOST_TEST(near(equivalent_conicity(reference, amplitude, e, r0),
                        std::pow(M_PI / wavelength, 2) * 2 * e * r0,
                        1e-4,
                        "conicity of S1002 on 54E1 at " + std::to_string(1e3 * amplitude) +
                          " mm against Klingel's equation integrated in small steps"));
      }
  }

  // Near the jump of the contact point a second point is about to touch.
  BOOST_AUTO_TEST_CASE(test_further_points)
  {
    const RailProfile  rail  = rail_profile("54E1");
    const WheelProfile wheel = wheel_profile("S1002");
    const auto before = find_contact(rail, wheel, TrackDimensions(), {-4.35e-3, RollMode::from_contact});
    const auto after  = find_contact(rail, wheel, TrackDimensions(), {-4.36e-3, RollMode::from_contact});
    BOOST_TEST((!before.further.empty() && !after.further.empty()),
               "next to a jump there are further points");
    if (before.further.empty() || after.further.empty())
      return;
    BOOST_TEST((before.further[0].gap > 0 && before.further[0].gap < 2e-5 && after.further[0].gap > 0 &&
                after.further[0].gap < 2e-5),
               "whose gap is below 0.02 mm on both sides of it");
    BOOST_TEST(
      near(before.further[0].rail_x, after.rail_x, 1e-4, "the second point becomes the first one [m]"));
    BOOST_TEST(near(after.further[0].rail_x, before.rail_x, 1e-4, "and the other way round [m]"));
    BOOST_TEST(near(before.further[0].angle, after.angle, 0.03, "with its contact angle [rad]"));
  }

  // With roll from contact both wheels touch at the same height of the axle's middle.
  BOOST_AUTO_TEST_CASE(test_roll)
  {
    const RailProfile  rail  = rail_profile("60E1");
    const WheelProfile wheel = wheel_profile("S1002");
    for (const double shift : {-5e-3, -1e-3, 3e-3})
      {
        const auto here  = find_contact(rail, wheel, TrackDimensions(), {shift, RollMode::from_contact});
        const auto there = find_contact(rail, wheel, TrackDimensions(), {-shift, RollMode::from_contact});
        BOOST_TEST(
          near(here.roll, -there.roll, 1e-12, "the two wheels of a wheelset have opposite rolls [rad]"));
        // the middle of the axle lies half the distance of the running circles from the wheel's axle point
        const auto middle = [](const ContactGeometry &c) {
          return c.axle.y + running_circle_distance(TrackDimensions()) * std::sin(c.roll);
        };
        BOOST_TEST(near(middle(here), middle(there), 1e-12, "and the same height of its axle's middle [m]"));
      }
  }
} // namespace
