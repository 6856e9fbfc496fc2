// label: fast

// Numbers with units: every unit, round trips, and what is refused.
#include "error_of.h"
#include "near.h"

#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace wheelrail;
using test::near;
using test::same_text;
using D = Dimension;

namespace
{
  struct Case
  {
    const char *text;
    D           dimension;
    double      value;
  };

  /// Each value must be the very double of the right-hand side: tolerance zero.
  BOOST_AUTO_TEST_CASE(test_units)
  {
    const std::vector<Case> cases = {
      {"1.8 m", D::length, 1.8},
      {"14 mm", D::length, 0.014},
      {"1435 mm", D::length, 1.435},
      {"60 um", D::length, 60e-6},
      {"60 \xC2\xB5m", D::length, 60e-6},
      {"2 km", D::length, 2000},
      {"10 t", D::mass, 10000},
      {"180 kg", D::mass, 180},
      {"5 g", D::mass, 0.005},
      {"3 s", D::time, 3},
      {"2 ms", D::time, 0.002},
      {"2 us", D::time, 2e-6},
      {"140 km/h", D::velocity, 140 / 3.6},
      {"38.9 m/s", D::velocity, 38.9},
      {"5 mm/s", D::velocity, 0.005},
      {"0.05 s/m", D::slowness, 0.05},
      {"2 s/mm", D::slowness, 2000},
      {"12 N", D::force, 12},
      {"100 kN", D::force, 1e5},
      {"0.1 MN", D::force, 1e5},
      {"7 Pa", D::stress, 7},
      {"3 kPa", D::stress, 3000},
      {"480 MPa", D::stress, 480e6},
      {"210 GPa", D::stress, 210e9},
      {"5 N/mm2", D::stress, 5e6},
      {"7900 kg/m3", D::density, 7900},
      {"7900 kg/m^3", D::density, 7900},
      {"7900 kg/m\xC2\xB3", D::density, 7900},
      {"7.9 t/m3", D::density, 7900},
      {"7.9 g/cm3", D::density, 7900},
      {"3 N/m", D::stiffness, 3},
      {"1150 kN/m", D::stiffness, 1.15e6},
      {"1.15 MN/m", D::stiffness, 1.15e6},
      {"1150 N/mm", D::stiffness, 1.15e6},
      {"1.15 kN/mm", D::stiffness, 1.15e6},
      {"500 Hz", D::frequency, 500},
      {"2 kHz", D::frequency, 2000},
      {"2500 N s/m", D::damping, 2500},
      {"2500 N*s/m", D::damping, 2500},
      {"2500 N * s / m", D::damping, 2500},
      {"2500 Ns/m", D::damping, 2500},
      {"2500 N\xC2\xB7s/m", D::damping, 2500},
      {"2.5 kN s/m", D::damping, 2500},
      {"2.5 kNs/m", D::damping, 2500},
      {"1.5 kg m2", D::mass_moment, 1.5},
      {"1.5 kg*m^2", D::mass_moment, 1.5},
      {"1.5 kgm2", D::mass_moment, 1.5},
      {"0.5 t m2", D::mass_moment, 500},
      {"0.025 rad", D::angle, 0.025},
      {"25 mrad", D::angle, 0.025},
      {"180 deg", D::angle, 3.14159265358979323846},
      {"2 1/km", D::spin, 0.002},
      {"1/40", D::none, 0.025},
      {"1 / 40", D::none, 0.025},
      {"-1/4", D::none, -0.25},
      {"0.25", D::none, 0.25},
      {"+0.25", D::none, 0.25},
      {".5", D::none, 0.5},
      {"  2e-3  ", D::none, 0.002},
      {"-3.5mm", D::length, -0.0035},
      {"1e-3 m", D::length, 0.001},
      {"1E-3\tm", D::length, 0.001},
    };
    for (const Case &c : cases)
      BOOST_TEST(near(parse_quantity(c.text, c.dimension), c.value, 0, c.text));
  }

  BOOST_AUTO_TEST_CASE(test_refused)
  {
    struct Refused
    {
      const char *text;
      D           dimension;
      const char *message;
    };
    const std::vector<Refused> cases = {
      {"140", D::velocity, "a bare number; a velocity with its unit is needed, such as 140 km/h"},
      {"140 mph", D::velocity, "the unit \"mph\" is not known here; a velocity takes one of m/s, km/h, mm/s"},
      {"140 kN", D::velocity, "the unit \"kN\" is one of force; a velocity takes one of m/s, km/h, mm/s"},
      {"480 mpa",
       D::stress,
       "the unit \"mpa\" is not known here; a stress takes one of Pa, kPa, MPa, GPa, N/mm2"},
      {"fast", D::velocity, "not a number; a velocity with its unit is needed, such as 140 km/h"},
      {"", D::length, "no value; a length with its unit is needed, such as 1.5 mm"},
      {"1,5 mm", D::length, "a comma in the number; write a decimal point, such as 1.5 mm"},
      {"nan mm", D::length, "not a number; a length with its unit is needed, such as 1.5 mm"},
      {"inf m", D::length, "not a number; a length with its unit is needed, such as 1.5 mm"},
      {"-inf m", D::length, "not a number; a length with its unit is needed, such as 1.5 mm"},
      {"0x10 mm", D::length, "not a decimal number; a length with its unit is needed, such as 1.5 mm"},
      {"1e999 m",
       D::length,
       "a number too large or too small for the computer; a length with its unit is needed, such as 1.5 mm"},
      {"1e308 km",
       D::length,
       "a number too large or too small for the computer; a length with its unit is needed, such as 1.5 mm"},
      {"1 mm 2", D::length, "the unit \"mm 2\" is not known here; a length takes one of m, mm, um, km"},
      {"1 2 mm", D::length, "the unit \"2 mm\" is not known here; a length takes one of m, mm, um, km"},
      {"-", D::none, "not a number; a pure number is needed, such as 0.25 or 1/40"},
      {"--1", D::none, "not a number; a pure number is needed, such as 0.25 or 1/40"},
      {"1/0", D::none, "a division by zero; a pure number is needed, such as 0.25 or 1/40"},
      {"1/40/2",
       D::none,
       "\"/40/2\" after the number is not understood; a pure number is needed, such as 0.25 or 1/40"},
      {"0.3 mm",
       D::none,
       "the unit \"mm\" does not belong here; a pure number is needed, such as 0.25 or 1/40"},
      {"nan", D::none, "not a number; a pure number is needed, such as 0.25 or 1/40"},
      {"0.5 half",
       D::none,
       "\"half\" after the number is not understood; a pure number is needed, such as 0.25 or 1/40"},
    };
    for (const Refused &c : cases)
      {
        const std::string message =
          test::error_of<InputError>([&]() { parse_quantity(c.text, c.dimension); });
        BOOST_TEST(same_text(message, c.message, std::string("refused: \"") + c.text + "\""));
      }
  }

  BOOST_AUTO_TEST_CASE(test_format)
  {
    BOOST_TEST(same_text(format_quantity(0.001, "mm"), "1 mm", "1 mm"));
    BOOST_TEST(same_text(format_quantity(1.435, "mm"), "1435 mm", "1435 mm"));
    BOOST_TEST(same_text(format_quantity(140 / 3.6, "km/h"), "140 km/h", "140 km/h"));
    BOOST_TEST(same_text(format_quantity(1.15e6, "MN/m"), "1.15 MN/m", "1.15 MN/m"));
    BOOST_TEST(same_text(format_quantity(210e9, "GPa"), "210 GPa", "210 GPa"));
    BOOST_TEST(same_text(format_quantity(10000, "t"), "10 t", "10 t"));
    BOOST_TEST(same_text(format_quantity(200000, "N"), "200000 N", "200000 N"));
    BOOST_TEST(same_text(format_quantity(0.3, ""), "0.3", "0.3"));
    BOOST_TEST(same_text(format_quantity(0, "mm"), "0 mm", "0 mm"));
    BOOST_TEST(same_text(format_quantity(-5.5e-3, "mm"), "-5.5 mm", "-5.5 mm"));
  }

  /// Any double, in any unit: the text reads back within one unit in the last place.
  BOOST_AUTO_TEST_CASE(test_round_trip)
  {
    struct UnitOf
    {
      D           dimension;
      const char *unit;
    };
    const std::vector<UnitOf>              units = {{D::none, ""},
                                                    {D::length, "mm"},
                                                    {D::velocity, "km/h"},
                                                    {D::stress, "GPa"},
                                                    {D::stiffness, "MN/m"},
                                                    {D::angle, "deg"},
                                                    {D::damping, "N s/m"},
                                                    {D::mass_moment, "kg m2"}};
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> mantissa(-10, 10), exponent(-12, 12);
    for (const UnitOf &u : units)
      {
        double worst = 0;
        for (unsigned int i = 0; i < 2000; ++i)
          {
            const double value = mantissa(random) * std::pow(10., exponent(random));
            const double back  = parse_quantity(format_quantity(value, u.unit), u.dimension);
            worst              = std::max(worst, std::abs(back / value - 1));
          }
        BOOST_TEST(
          near(worst, 0, 2.3e-16, std::string("round trip in ") + (*u.unit ? u.unit : "pure numbers")));
      }
  }
} // namespace
