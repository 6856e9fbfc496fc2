// label: fast

// Half-space contact with a given undeformed distance: Hertzian against Hertz and CONTACT, from a file, and
// what faulty files are answered.
#include "messages.h"
#include "near.h"

#include <wheelrail/wheel/given_distance.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

using namespace wheelrail;
using test::message_of;
using test::near;
using test::same_text;

namespace
{
  Scene
  hertz_scene()
  {
    Scene scene;
    scene.halfspace_distance     = "hertz";
    scene.halfspace_normal_force = 100e3;
    scene.traction_coefficient   = 0.25;
    scene.halfspace_element_size = 0.25e-3;
    return scene;
  }

  WheelRailSolution
  solve(const Scene &scene)
  {
    const SceneGeometry geometry = make_geometry(scene);
    return solve_given_distance(scene, &geometry);
  }

  /// CONTACT (open-source version, revision 2707 of 2025-07-23): Rx 460, Ry 300, steel, mu 0.5, 100 kN,
  /// elements of 0.25 mm, Fx = 0.5 mu N, no lateral force or spin asked: 1237.65 MPa, creepage 2.084e-3, 1951
  /// elements, 85.375 mm2 of adhesion.
  void
  hertz()
  {
    const WheelRailSolution result = solve(hertz_scene());
    const auto             &s      = result.solution;
    BOOST_TEST((s.converged() && !s.touches_grid_edge), "converged, off the edge of the grid");
    BOOST_TEST(near(s.peak_pressure / 1237.65e6, 1, 1e-4, "peak pressure over that of CONTACT"));
    BOOST_TEST(near(s.xi / 2.084e-3, 1, 1e-3, "creepage over that of CONTACT"));
    BOOST_TEST(near(s.contact_elements, 1951, 0, "elements in contact"));
    BOOST_TEST(near(s.adhesion_area / 85.375e-6, 1, 0.002, "adhesion area over that of CONTACT"));
    BOOST_TEST(near(result.vertical, 100e3, 1, "normal force [N]"));

    Scene back                  = hertz_scene();
    back.halfspace_normal_force = 0;
    back.halfspace_approach     = s.approach;
    BOOST_TEST(
      near(solve(back).solution.fn / 100e3, 1, 1e-5, "normal force of the same approach over the given one"));
    Scene yawed = hertz_scene();
    yawed.yaw   = 1e-3;
    BOOST_TEST(same_text(
      test::message_of([&]() { solve(yawed); }),
      "Wheelset/Yaw: without effect where Half-space/Undeformed distance is not that of the profiles; give "
      "Wheelset/Lateral creepage (about minus the yaw in rad), or set Undeformed distance = profiles",
      "yaw without profiles"));
    Scene curved        = hertz_scene();
    curved.track_radius = 300;
    BOOST_TEST(same_text(
      test::message_of([&]() { solve(curved); }),
      "Track/Radius: without effect where Half-space/Undeformed distance is not that of the profiles; give "
      "Half-space/Given spin, or set Undeformed distance = profiles",
      "a curve without profiles"));
    back.halfspace_normal_force = 100e3;
    BOOST_TEST(same_text(
      message_of([&]() { solve(back); }),
      "Half-space/Normal force and Half-space/Approach are both given; one follows from the other: set "
      "one of them to auto",
      "both given"));
    Scene held                   = hertz_scene();
    held.drive                   = Drive::rate;
    held.creepage                = s.xi;
    held.halfspace_contact_angle = 0.05;
    const auto spinning          = solve(held);
    BOOST_TEST(near(spinning.solution.xi, s.xi, 1e-12, "the creepage is the given one"));
    BOOST_TEST(near(
      spinning.solution.phi * 0.46, std::sin(0.05), 1e-12, "spin x radius is the sine of the contact angle"));
    BOOST_TEST(std::abs(spinning.solution.fy) > 1e3, "spin makes a lateral force");
  }

  /// Of an interval that holds what is true, over it.
  double
  width(const Summary &summary, const std::string &before, const std::string &unit, const double truth)
  {
    const double low  = get_figure(summary, before + "_low" + unit),
                 high = get_figure(summary, before + "_high" + unit);
    BOOST_TEST((low <= truth && truth <= high), before + " of CONTACT lies within");
    return (high - low) / truth;
  }

  /// Intervals of few elements hold what CONTACT finds on 0.25 mm, and close with the elements.
  void
  intervals()
  {
    double peak_width = 0.1, creep_width = 0.2; // at most
    for (const double size : {1e-3, 0.5e-3})
      {
        Scene scene                  = hertz_scene();
        scene.halfspace_element_size = size;
        Contributions contributions;
        const Summary summary = halfspace_summary(scene, solve(scene), &contributions);
        const double  peak    = width(summary, "max_pressure", "_Pa", 1237.65e6),
                     creep    = width(summary, "creepage", "", 2.084e-3);
        BOOST_TEST(peak < peak_width, "width for the peak " + std::to_string(peak));
        BOOST_TEST(creep < creep_width, "width for the creepage " + std::to_string(creep));
        peak_width  = 0.7 * peak;
        creep_width = 0.7 * creep;
        BOOST_TEST((contributions_as_csv(contributions).find("creepage,1,elements,") != std::string::npos),
                   "and what it is made of");
      }
  }

  std::string
  file_of(const std::string &text)
  {
    std::string path = "distance.txt"; // in the folder of this test
    std::ofstream(path) << text;
    return path;
  }

  std::string
  grid_text(const int n, const std::function<double(double, double)> &distance)
  {
    std::string text = "# x, y, distance [mm]\n";
    for (int j = n; j >= -n; --j)
      for (int i = -n; i <= n; ++i)
        text += std::to_string(0.4 * i) + ", " + std::to_string(0.4 * j) + ", " +
                std::to_string(distance(0.4 * i, 0.4 * j)) + "\n";
    return text;
  }

  void
  file()
  {
    // six decimals of a millimetre, steps of 0.4 mm
    Scene scene = hertz_scene();
    scene.halfspace_distance =
      file_of(grid_text(30, [](const double x, const double y) { return 0.7 + x * x / 920 + y * y / 600; }));
    const auto exact = solve(hertz_scene()).solution, read = solve(scene).solution;
    BOOST_TEST(!read.touches_grid_edge, "off the edge of the grid");
    BOOST_TEST(near(
      read.peak_pressure / exact.peak_pressure, 1, 1e-4, "peak pressure of the file over the Hertzian one"));
    BOOST_TEST(near(read.xi / exact.xi, 1, 1e-4, "creepage of the file over the Hertzian one"));
    BOOST_TEST(near(solve(scene).noise_effect.peak, 0, 0, "whose digits move nothing"));

    // micrometres: their last digit makes the peak some 10 % higher
    scene.halfspace_distance = file_of(grid_text(30, [](const double x, const double y) {
      return std::round(1e3 * (x * x / 920 + y * y / 600)) / 1e3;
    }));
    const auto   rounded     = solve(scene);
    const double off         = rounded.solution.peak_pressure / exact.peak_pressure - 1;
    BOOST_TEST((off > 0.05 && off < rounded.noise_effect.peak && rounded.noise_effect.peak < 0.6),
               "rounding: the peak is " + std::to_string(off) + " higher, said are " +
                 std::to_string(rounded.noise_effect.peak));

    scene.halfspace_distance =
      file_of(grid_text(6, [](const double x, const double y) { return x * x / 920 + y * y / 600; }));
    BOOST_TEST(solve(scene).solution.touches_grid_edge, "a file smaller than the patch is told");
  }

  void
  check_file(const std::string &text, const std::string &expected)
  {
    const std::string path = file_of(text);
    BOOST_TEST(
      same_text(message_of([&]() { read_distance_file(path); }), path + expected, text.substr(0, 20)));
  }

  void
  faulty_files()
  {
    const std::string nothing = "nothing.txt";
    BOOST_TEST(same_text(message_of([&]() { read_distance_file(nothing); }),
                         nothing + ": no such file; rows x, y, distance in mm are needed",
                         "no file"));
    check_file("0 0 1\n1 0\n", ":2: a row of 2 values, the first line names 3 columns");
    check_file("0 0 one\n", ":1: \"one\" of distance is not a number; units belong in the first line");
    check_file("0 0 1\n1 0 1\n0 1 1\n1 1 1\n", ": 2 values of x; a grid of at least 4 x 4 points is needed");
    std::string whole;
    for (int k = 0; k < 16; ++k)
      whole += std::to_string(k % 4) + " " + std::to_string(k / 4) + " 1\n";
    check_file(whole + "3 3 2\n", ":17: the same place as in line 16; one row for each point is needed");
    check_file(whole.substr(0, whole.size() - 6) + "3.5 3 1\n",
               ": the values of x have no even steps near 1.000000 mm; a regular grid is needed");
    check_file(whole.substr(0, whole.find("2 2 ")) + whole.substr(whole.find("3 2 ")),
               ": no row for x = 2.000000 mm, y = 2.000000 mm; one row for each point of the grid is needed");
  }
} // namespace


BOOST_AUTO_TEST_CASE(given_distance)
{
  hertz();
  intervals();
  file();
  faulty_files();
  std::filesystem::remove("distance.txt");
}
