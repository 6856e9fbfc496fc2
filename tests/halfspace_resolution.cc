// label: fast

// Small contacts: where the elements of the scene are too coarse the half-space solution takes smaller ones
// and says so.

#include "near.h"

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/wheel/given_distance.h>
#include <wheelrail/wheel/halfspace_parts.h>

#include <cmath>
#include <string>

using namespace wheelrail;
using test::near;
using test::same_text;

namespace
{
  /// A sphere of 300 mm on a plane, elements of 0.4 mm.
  Scene
  sphere(const double force)
  {
    Scene scene;
    scene.halfspace_distance      = "hertz";
    scene.halfspace_radius_along  = 0.3;
    scene.halfspace_radius_across = 0.3;
    scene.halfspace_normal_force  = force;
    scene.traction_coefficient    = 0.25;
    return scene;
  }

  HalfspaceSolution
  solved(const Scene &scene)
  {
    const SceneGeometry geometry = make_geometry(scene);
    return solve_given_distance(scene, &geometry).solution;
  }

  /// Peak pressure of a sphere on a plane (Hertz, 1882) [Pa].
  double
  hertz_peak(const Scene &scene, const double force)
  {
    const double pi = M_PI, nu = scene.rail_material.poissons_ratio,
                 E = scene.rail_material.youngs_modulus / (2 * (1 - nu * nu)),
                 R = scene.halfspace_radius_along;
    return std::cbrt(6 * force * E * E / (pi * pi * pi * R * R));
  }
} // namespace


BOOST_AUTO_TEST_CASE(halfspace_resolution)
{
  for (const double force : {1., 100., 1e4, 1e5})
    {
      const Scene             scene  = sphere(force);
      const HalfspaceSolution result = solved(scene);
      const std::string       what   = std::to_string(static_cast<int>(force)) + " N: ";
      BOOST_TEST(elements_across(result) >= 8,
                 what + std::to_string(elements_across(result)) + " elements across the contact");
      BOOST_TEST(near(
        result.peak_pressure / hertz_peak(scene, force), 1, 0.03, what + "peak pressure over that of Hertz"));
      BOOST_TEST(result.grid.size() < 5000, what + "the grid stays near the contact");
    }
  BOOST_TEST(
    near(solved(sphere(1e5)).grid.dx, 0.4e-3, 1e-9, "a large contact keeps the scene's elements [m]"));
  BOOST_TEST(same_text(resolution_note(sphere(1e5), solved(sphere(1e5))), "", "and nothing is told"));

  const HalfspaceSolution small = solved(sphere(1));
  const std::string       note  = resolution_note(sphere(1), small);
  BOOST_TEST((note.find("Half-space/Element size = 0.4 mm: too coarse for this contact, elements of ") == 0 &&
              note.find(" elements lie across the contact") != std::string::npos),
             "smaller elements are told: " + note);

  HalfspaceSolution one;
  one.grid     = {3, 3, 0.4e-3, 0.4e-3, 0, 0};
  one.pressure = {0, 0, 0, 0, 5e6, 0, 0, 0, 0};
  BOOST_TEST(same_text(
    resolution_note(sphere(1), one),
    "Half-space/Element size = 0.4 mm: 1 element lies across the contact, too few for results: the peak "
    "pressure may be off by 5 % and more",
    "a contact on one element"));
}
