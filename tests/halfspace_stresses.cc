// Stresses below the contact of two half-spaces, as the command halfspace gives them: Hertz's sphere, the
// tractions at the surface, the largest value.

#include "near.h"

#include <wheelrail/base/vector3.h>
#include <wheelrail/wheel/given_distance.h>
#include <wheelrail/wheel/halfspace_stresses.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace wheelrail;
using test::near;

namespace
{
  /// Spheres of steel on each other: 100 kN on a relative radius of 0.46 m, or all lengths `size` times as
  /// large under the same pressure.
  WheelRailSolution
  sphere(const double traction, const double size = 1)
  {
    Scene scene;
    scene.halfspace_distance      = "hertz";
    scene.halfspace_radius_along  = 0.46 * size;
    scene.halfspace_radius_across = 0.46 * size;
    scene.halfspace_normal_force  = 100e3 * size * size;
    scene.halfspace_element_size *= size;
    scene.traction_coefficient   = traction;
    const SceneGeometry geometry = make_geometry(scene);
    return solve_given_distance(scene, &geometry);
  }

  const Slice &
  named(const HalfspaceStresses &stresses, const std::string &name)
  {
    for (const Slice &slice : stresses.slices)
      if (slice.name == name)
        return slice;
    BOOST_TEST(false, name + " is there");
    return stresses.slices.front();
  }

  /// Johnson (1985), section 3.4: largest shear 0.310 p0, so von Mises 0.620 p0, at the depth 0.48 a, nu 0.3.
  BOOST_AUTO_TEST_CASE(test_sphere)
  {
    const WheelRailSolution result   = sphere(0);
    const HalfspaceStresses stresses = halfspace_stresses(result);
    const double            a = 6.6869e-3, p0 = 1067.81e6;
    BOOST_TEST(near(stresses.subsurface_von_mises / p0, 0.620, 0.003, "largest von Mises stress over p0"));
    BOOST_TEST(near(stresses.subsurface_depth / a, 0.481, 0.006, "its depth over a"));
    BOOST_TEST(near(stresses.slices.size(), 8, 0, "slices"));
    const Slice &rail = named(stresses, "AA_rail");
    BOOST_TEST(near(rail.offset, 0, 1e-12, "AA goes through the first contact point [m]"));
    BOOST_TEST(near(rail.depth.back(), 15e-3, 0.2e-3, "deepest point [m]"));
  }

  /// The same over p0 in a contact of any size: of a ball of 5 mm, of a dome of 46 m.
  BOOST_AUTO_TEST_CASE(test_sizes)
  {
    for (const double size : {0.011, 100.})
      {
        const HalfspaceStresses stresses = halfspace_stresses(sphere(0, size));
        const std::string       name     = "sphere " + std::to_string(size) + " times as large: ";
        BOOST_TEST(
          near(stresses.subsurface_von_mises / 1067.81e6, 0.620, 0.003, name + "largest von Mises over p0"));
        BOOST_TEST(
          near(stresses.subsurface_depth / (6.6869e-3 * size), 0.481, 0.01, name + "its depth over a"));
      }
  }

  /// Where the surface is loaded, sigma N is the traction that acts on it: on the rail the one of the patch,
  /// on the wheel its opposite. N points out of the body. Both for a contact plane that is inclined.
  BOOST_AUTO_TEST_CASE(test_surface)
  {
    WheelRailSolution result = sphere(0.25);
    result.angle             = -0.3;
    const Vector3 up = {std::sin(0.3), std::cos(0.3), 0}, lateral = {std::cos(0.3), -std::sin(0.3), 0};
    const HalfspaceStresses  stresses = halfspace_stresses(result);
    const HalfspaceSolution &s        = result.solution;
    for (const std::string body : {"rail", "wheel"})
      {
        const Slice &slice = named(stresses, "BB_peak_" + body);
        const double side  = body == "rail" ? 1 : -1;
        const int    i     = int(std::lround((slice.offset - s.grid.x0) / s.grid.dx));
        double       worst = 0;
        for (int j = 0; j < s.grid.my; ++j)
          {
            const std::size_t place = j * slice.depth.size(), e = i + std::size_t(s.grid.mx) * j;
            const auto        at     = [&](const int c) { return slice.values[c][place]; };
            const double sigma[3][3] = {{at(1), at(6), at(5)}, {at(6), at(2), at(4)}, {at(5), at(4), at(3)}};
            Vector3      force{};
            for (int k = 0; k < 3; ++k)
              for (int l = 0; l < 3; ++l)
                force[k] += sigma[k][l] * side * up[l];
            Vector3 expected{};
            add(expected, -side * s.pressure[e], up);
            add(expected, side * s.traction_y[e], lateral);
            expected[2] += side * s.traction_x[e];
            worst = std::max(worst, norm(force - expected));
          }
        BOOST_TEST(
          near(worst / s.peak_pressure, 0, 1e-9, body + ": stress times normal is the traction, over p0"));
      }
  }

  /// Where it slides, the traction is 0.5 p: stretched and sheared, the surface then carries more than the
  /// steel below. Traction also raises what the pressure makes below, and in none of the planes through the
  /// peak is a maximum over depth larger.
  BOOST_AUTO_TEST_CASE(test_traction)
  {
    const HalfspaceStresses rolling = halfspace_stresses(sphere(0.25)),
                            resting = halfspace_stresses(sphere(0));
    BOOST_TEST(rolling.surface_von_mises > rolling.subsurface_von_mises, "traction raises the surface most");
    BOOST_TEST(resting.surface_von_mises < resting.subsurface_von_mises,
               "without traction the largest is below");
    BOOST_TEST(rolling.subsurface_von_mises > 1.01 * resting.subsurface_von_mises,
               "traction raises the stress below");
    double largest = 0;
    for (const Slice &slice : rolling.slices)
      for (std::size_t k = 0; k < slice.position.size(); ++k)
        for (std::size_t d = 1; d + 1 < slice.depth.size(); ++d)
          {
            const double *v = &slice.values[0][k * slice.depth.size() + d];
            if (v[0] > v[-1] && v[0] >= v[1])
              largest = std::max(largest, v[0]);
          }
    BOOST_TEST((largest > 0.9 * rolling.subsurface_von_mises && largest <= rolling.subsurface_von_mises),
               "the planes hold nearly the largest maximum over depth");
  }
} // namespace
