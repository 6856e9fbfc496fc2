// Cases of CONTACT on rails and wheels by slices, and on a curved surface of reference, against what CONTACT
// prints.

#include "contact_inputs.h"
#include "near.h"
#include "reference_table.h"
#include "slices_files.h"

#include <wheelrail/contactfiles/inp_file.h>
#include <wheelrail/contactfiles/solve_cases.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>

using namespace wheelrail;
using test::near;
using test::near_relative;

namespace
{
  /// One case of steady rolling: digits D and N, C; lines of elements, track, rail, wheelset, wheel, pose.
  struct Parts
  {
    std::string words = " 1203000\n 0022033\n 0000320\n", shear = "82000";
    std::string influence; ///< of C = 4
    std::string elements, track, rail, wheelset, wheel, position, velocity;
  };

  CaseResult
  solve(const Parts &p)
  {
    std::string text = " 1 MODULE\n" + p.words;
    text += "999 100 30 5 1e-5\n0.3 0.3\n" + p.influence + "0.28 0.28 " + p.shear + ' ' + p.shear + '\n';
    text += p.elements + " 1 90d 8 4\n" + p.track + " 0\n'" + p.rail + " -1\n0 0 0 0 0 0\n" + p.wheelset +
            "\n'" + p.wheel + " -1\n" + p.position + '\n' + p.velocity + "\n 0 MODULE\n";
    std::string digits = text;
    digits.replace(digits.find("0000320"), 7, "0000321");
    CaseResult result = solve_cases(read_inp_text(digits, "x.inp")).front();
    for (const std::string &sentence : result.refused)
      std::cout << "        refused: " << sentence << '\n';
    return result;
  }

  /// Nose and wing of artificial crossings, at given heights.
  BOOST_AUTO_TEST_CASE(test_rails)
  {
    // in the axes of CONTACT: y to the field side, z down
    std::ifstream profile(std::string(WHEELRAIL_TEST_DIR) + "/profiles/manchester_S1002.txt");
    std::ofstream out("S1002.prw");
    std::string   line;
    std::getline(profile, line);
    for (double y = 0, height = 0; profile >> y >> height;)
      out << -y << ' ' << -height << '\n';
    out.close();
    for (const auto &row : test::read_table("contact_crossing.csv"))
      {
        const bool nose = row[0] == "cross_brute";
        if ((!nose && row[0] != "wing_brute") || row[2] == "all")
          continue;
        test::write_part(nose ? "nose" : "wing");
        Parts p;
        p.words           = " 1203000\n 0052033\n 0000320\n"; // D = 5
        p.elements        = "0.2 0.05";
        p.track           = "-1 750 0";
        p.rail            = nose ? "nose.slcs' 0 1 0" : "wing.slcs' 0 1 0";
        p.wheelset        = "1360 -70 460";
        p.wheel           = "S1002.prw' 0 1 0";
        p.position        = (nose ? "0 0 " : "100 0 ") + row[4] + " 0 0 0";
        p.velocity        = "2000 0 0 0 0 -4.3481181";
        const auto result = solve(p).wheel_rail;
        BOOST_REQUIRE_MESSAGE(result && result->patches.size() == 1,
                              row[0] + ": one patch, of " +
                                (result ? std::to_string(result->patches.size()) : "no result"));
        const WheelRailPatch &patch = result->patches.front();
        const auto            value = [&](const std::size_t k) { return std::stod(row[k]); };
        BOOST_TEST(near(1e3 * patch.in_track[0], value(9), 0.05, row[0] + ": place along the track"));
        BOOST_TEST(near(1e3 * patch.on_rail[1], value(10), 0.05, row[0] + ": place on the rail"));
        BOOST_TEST(near(patch.angle, value(11), 1e-3, row[0] + ": contact angle"));
        BOOST_TEST(near(patch.solution.fn, value(12), 50, row[0] + ": normal force"));
        BOOST_TEST(near(patch.solution.fx, value(13), 50, row[0] + ": longitudinal force"));
        BOOST_TEST(near_relative(patch.creepage, value(15), 0.01, row[0] + ": creepage"));
        BOOST_TEST(near_relative(1e3 * patch.solution.approach, value(18), 5e-3, row[0] + ": approach"));
        BOOST_TEST(
          near_relative(1e-6 * patch.solution.peak_pressure, value(19), 5e-3, row[0] + ": peak pressure"));
      }
  }

  /// A wheel with a flat on a round crown, turned by a pitch.
  BOOST_AUTO_TEST_CASE(test_wheel)
  {
    test::write_flat("flat.slcw");
    std::ofstream crown("crown.prr");
    crown.precision(12);
    for (int k = -100; k <= 100; ++k)
      crown << 0.3 * k << ' ' << 300 - std::sqrt(9e4 - 0.09 * k * k) << '\n';
    crown.close();
    for (const auto &row : test::read_table("contact_rounded_flat.csv"))
      {
        const std::string pitch = row[0];
        if (pitch == "-7" || pitch == "0") // peaks at an edge of the grid
          continue;
        Parts p;
        p.words           = " 1203100\n 0022033\n 0000320\n";
        p.elements        = "0.2 0.2";
        p.track           = "-1 0 0";
        p.rail            = "crown.prr' 0 1 0";
        p.wheelset        = "0 0 450";
        p.wheel           = "flat.slcw' 0 1 0";
        p.position        = "0 0 10000 0 0 " + pitch + "d";
        p.velocity        = "2000 0 0 0 0 -4.44444444";
        const auto result = solve(p).wheel_rail;
        BOOST_REQUIRE_MESSAGE(result && result->patches.size() == 1, "pitch " + pitch + ": one patch");
        const HalfspaceSolution &s = result->patches.front().solution;
        BOOST_TEST(
          near(1e3 * result->height, std::stod(row[1]), 5e-4, "pitch " + pitch + ": height of the wheelset"));
        BOOST_TEST(near_relative(1e3 * s.approach, std::stod(row[2]), 5e-3, "pitch " + pitch + ": approach"));
        // at -5 deg the peak stands beside the kink where the flat ends, on a spline that rings there
        BOOST_TEST(near_relative(1e-6 * s.peak_pressure,
                                 std::stod(row[3]),
                                 pitch == "-5" ? 0.03 : 5e-3,
                                 "pitch " + pitch + ": peak pressure"));
        BOOST_TEST(near_relative(1e6 * s.area, std::stod(row[4]), 0.01, "pitch " + pitch + ": area"));
      }
  }

  /// What is answered to slices that do not fit.
  BOOST_AUTO_TEST_CASE(test_messages)
  {
    test::write_flat("flat.slcw");
    test::write_part("wing");
    std::ofstream("crown.prr") << "-40 1\n-20 0.2\n0 0\n20 0.2\n40 1\n";
    Parts p;
    p.elements      = "0.2 0.2";
    p.track         = "-1 0 0";
    p.rail          = "crown.prr' 0 1 0";
    p.wheelset      = "0 0 450";
    p.wheel         = "wing.slcs' 0 1 0";
    p.position      = "0 0 1 0 0 0";
    p.velocity      = "2000 0 0 0 0 -4.44444444";
    const auto said = [&p]() {
      const CaseResult result = solve(p);
      return result.refused.empty() ? std::string("no message") : result.refused.front();
    };
    BOOST_TEST(
      test::same_text(said(), "wing.slcs: slices of a rail (.slcs) stand for a wheel", "slices of a rail"));
    p.rail  = "flat.slcw' 0 1 0";
    p.wheel = "S1002.prw' 0 1 0";
    BOOST_TEST(
      test::same_text(said(), "flat.slcw: slices of a wheel (.slcw) stand for a rail", "slices of a wheel"));
    // ten slices around the axle: a part ends behind the seventh, or is shorter from the eighth on
    const auto write_parts =
      [](const std::string &name, const int features, const std::string &first, const std::string &last) {
        std::ofstream file(name);
        file << "0 1 TH_OFFSET TH_SCALE\n10 NSLC\n" << features << " 0 0 NFEAT NKINK NACCEL\n1 TH_INTPOL\n";
        for (int k = 0; k < 10; ++k)
          file << 0.1 * (k - 5) << " 'flat_1.txt'\n";
        for (int k = 0; k < 10; ++k)
          file << 0.1 * (k - 5) << (k < 7 ? first : last);
      };
    write_parts("parts.slcw", 3, " 0 20 999\n", " 0 20 -1\n");
    write_parts("short.slcw", 2, " 0 999\n", " 0 20\n");
    p.rail  = "crown.prr' 0 1 0";
    p.wheel = "parts.slcw' 0 1 0";
    BOOST_TEST(
      test::same_text(said(),
                      "parts.slcw: parts of the wheel begin or end between slices; all need the same",
                      "a wheel of parts"));
    p.wheel = "short.slcw' 0 1 0";
    BOOST_TEST(
      test::same_text(said(), "short.slcw: nothing is at 5.755 degrees", "between slices of unlike lengths"));
  }

  /// A wheel with a tread of 10 mm in a groove, on a curved surface of reference.
  BOOST_AUTO_TEST_CASE(test_groove)
  {
    const auto write = [](const std::string &file, const double radius, const double sign) {
      std::ofstream out(file);
      out.precision(12);
      for (int k = -180; k <= 180; ++k)
        {
          const double angle = k * M_PI / 400;
          out << radius * std::sin(angle) << ' ' << sign * radius * (std::cos(angle) - 1) << '\n';
        }
    };
    write("tread.prw", 10, 1);
    for (const auto &row : test::read_table("contact_groove.csv"))
      {
        const bool flat = row[0] == "half-space";
        if (!flat && row[1] == "10.05") // takes 3 s
          continue;
        const std::string name = row[0] + ", groove of " + row[1] + " mm: ";
        write("groove.prr", std::stod(row[1]), 1);
        Parts p;
        p.words           = flat ? " 1203110\n 0042033\n 0000320\n" : " 1203110\n 0044033\n 0000320\n";
        p.influence       = flat ? "" : "1 3\n";
        p.shear           = "80000";
        p.elements        = "0.095833 0.25";
        p.track           = "-1 0 0";
        p.rail            = "groove.prr' 0 1 0";
        p.wheelset        = "0 0 420";
        p.wheel           = "tread.prw' 0 1 0";
        p.position        = "0 0 10000 0 0 0";
        p.velocity        = "420 0 0 0 0 0";
        const auto result = solve(p).wheel_rail;
        BOOST_REQUIRE_MESSAGE(result && result->patches.size() == 1, name + "one patch");
        const WheelRailPatch    &patch = result->patches.front();
        const HalfspaceSolution &s     = patch.solution;
        BOOST_TEST(near_relative(1e-6 * s.peak_pressure, std::stod(row[2]), 5e-3, name + "peak pressure"));
        BOOST_TEST(near_relative(1e6 * s.area, std::stod(row[3]), 0.01, name + "area"));
        BOOST_TEST(near_relative(1e6 * s.adhesion_area, std::stod(row[4]), 0.02, name + "adhesion"));
        BOOST_TEST(near_relative(1e3 * s.approach, std::stod(row[7]), 5e-3, name + "approach"));
        BOOST_TEST(near_relative(patch.creepage, std::stod(row[8]), 0.01, name + "creepage"));
      }
  }
} // namespace
