// label: fast

// Rollers of test rigs as half-spaces: crowned ones against Hertz, a cylinder against the line contact,
// crowns from files, and what faulty ones are answered.
#include "check.h"
#include "messages.h"

#include <wheelrail/reference/given_distance.h>
#include <wheelrail/reference/roller_distance.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

using namespace wheelrail;
using test::check;
using test::check_near;
using test::check_text;
using test::message_of;

namespace
{
  /// Two discs of 47 mm diameter under 1 kN, steel.
  Scene
  discs()
  {
    Scene scene;
    scene.halfspace_distance     = "rollers";
    scene.halfspace_normal_force = 1e3;
    scene.traction_coefficient   = 0.25;
    scene.wheel_roller           = {23.5e-3, 0};
    scene.rail_roller            = {23.5e-3, 0};
    scene.roller_width           = 10e-3;
    scene.halfspace_element_size = 0.05e-3;
    return scene;
  }

  WheelRailSolution
  solve(const Scene &scene)
  {
    return solve_given_distance(scene, nullptr);
  }

  /// (1 - nu^2)/E of both bodies together, inverted.
  double
  modulus(const Scene &scene)
  {
    const MaterialData &m = scene.rail_material;
    return m.youngs_modulus / (2 * (1 - m.poissons_ratio * m.poissons_ratio));
  }

  /// Equal relative radii along and across: a circle of radius (3 F R/(4 E*))^(1/3) (Hertz, 1882; Johnson,
  /// Contact mechanics, 1985, chapter 4).
  void
  test_crowned()
  {
    Scene scene        = discs();
    scene.wheel_roller = {23.5e-3, 11.75e-3};
    const double R = 11.75e-3, E = modulus(scene), F = scene.halfspace_normal_force;
    const double a = std::cbrt(3 * F * R / (4 * E)), p0 = 3 * F / (2 * M_PI * a * a);
    const auto   result = solve(scene);
    const auto  &s      = result.solution;
    check(s.converged() && !s.touches_grid_edge, "converged, off the edge of the grid");
    check_near(s.peak_pressure / p0, 1, 5e-3, "peak pressure over that of Hertz");
    check_near(result.measures.area / (M_PI * a * a), 1, 0.02, "area over that of Hertz");
    check_near(s.approach / (a * a / R), 1, 5e-3, "approach over that of Hertz");
    check_near(s.xi > 0, 1, 0, "driven by the traction coefficient");
  }

  /// Half a millimetre of contact along 10 mm across: in the middle a line contact, p0^2 = F' E*/(pi R), with
  /// more pressure at the ends, which bounds the middle from above (Johnson 1985, section 5.4).
  void
  test_cylinders()
  {
    Scene        scene = discs();
    const double R = 11.75e-3, E = modulus(scene), line = scene.halfspace_normal_force / scene.roller_width;
    const double p0 = std::sqrt(line * E / (M_PI * R));
    const auto   s  = solve(scene).solution;
    check(s.converged() && !s.touches_grid_edge, "converged, off the edge of the grid");
    double middle = 0, end = 0, width = 0;
    for (int j = 0; j < s.grid.my; ++j)
      {
        double most = 0;
        for (int i = 0; i < s.grid.mx; ++i)
          most = std::max(most, s.pressure[i + s.grid.mx * j]);
        width += most > 0 ? s.grid.dy : 0;
        end = std::max(end, most);
        if (std::abs(s.grid.y(j)) < 0.25 * scene.roller_width)
          middle = std::max(middle, most);
      }
    check_near(width / scene.roller_width, 1, 1e-9, "the contact is as wide as the roller");
    check_near(middle / p0, 0.99, 0.02, "pressure in the middle over that of the line contact");
    check(end > 1.1 * middle, "the pressure rises at the ends");
  }

  /// A crown of 300 mm from points is that of the entry.
  void
  test_file()
  {
    std::ofstream file("crown.txt");
    for (int k = -60; k <= 60; ++k)
      {
        char line[80];
        std::snprintf(
          line, sizeof line, "%.4f %.7f\n", 0.25 * k, 1e3 * (std::sqrt(0.09 - 6.25e-8 * k * k) - 0.3));
        file << line;
      }
    file.close();
    Scene scene                  = discs();
    scene.halfspace_normal_force = 2e3;
    scene.wheel_roller.crown     = 0.3;
    const auto arc               = solve(scene).solution;
    scene.wheel_roller.crown     = -1;
    scene.wheel_profile          = "./crown.txt";
    const auto read              = solve(scene).solution;
    check_near(read.peak_pressure / arc.peak_pressure, 1, 2e-3, "peak pressure of the crown in a file");
    scene.roller_width = 40e-3;
    check_text(
      message_of([&]() { solve(scene); }),
      "Profiles/Wheel: ./crown.txt: the crown reaches from -15 mm to 15 mm; Half-space/Roller width = 40 mm "
      "needs as much on both sides of 0: give a smaller width, or move the origin of the file",
      "a crown that is too short");
    scene.wheel_profile = "S1002";
    check_text(
      message_of([&]() { solve(scene); }),
      "Half-space/Wheel roller crown = profile: Profiles/Wheel = S1002 is no file; write the name of a file "
      "with the points of the crown there",
      "a standard profile");
    std::remove("crown.txt");
  }

  void
  test_messages()
  {
    Scene scene                  = discs();
    scene.halfspace_normal_force = 0;
    check_text(message_of([&]() { solve(scene); }),
               "Half-space/Normal force = auto: no wheel load presses rollers together; give the force, or "
               "Half-space/Approach",
               "no force");
    scene                    = discs();
    scene.wheel_roller.crown = 4e-3;
    check_text(
      message_of([&]() { solve(scene); }),
      "Half-space/Wheel roller crown = 4 mm: less than half of Half-space/Roller width = 10 mm; an arc over "
      "the width is needed",
      "a crown that is no arc");
    scene              = discs();
    scene.wheel_roller = scene.rail_roller = {};
    check_text(
      message_of([&]() { solve(scene); }),
      "Half-space/Wheel roller radius = straight: and so is Half-space/Rail roller radius; one of them must "
      "roll",
      "two straight bodies");
  }
} // namespace

int
main()
{
  test_crowned();
  test_cylinders();
  test_file();
  test_messages();
  return test::report();
}
