// Impact on a rigid plane: an elastic rod and a ball.

#include "scenes/ball_impact.h"

#include "parallel.h"

#include <cmath>
#include <iostream>
#include <string>

using namespace scenes;
using namespace wheelrail;

namespace
{
  /// Of a rod on a wall over the exact values: mean stress of the plateau, duration of the contact, and
  /// speed of the centre after it.
  struct Rebound
  {
    double plateau, duration, speed, residual;
  };

  /// Saint-Venant's rod: stress rho c v for the time 2 L / c, then it leaves with its speed (Timoshenko and
  /// Goodier, Theory of Elasticity, 3rd edition 1970, chapter 14).
  Rebound
  rod(const Setup &setup, const unsigned int cells)
  {
    const double length = 0.1, h = length / cells, velocity = 1;
    Dynamics     scene(box({0, 0, 0}, {length, h, h}, {cells, 1, 1}), setup);
    const auto  &mesh = scene.solid.mesh;
    const auto   wall = scene.wall(select(mesh, plane(0, 0)), 0, 1, [](double) { return 0.; });
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      scene.solid.velocity[4 * n] = -velocity;
    const double c     = std::sqrt(setup.material.youngs_modulus / setup.material.density);
    const double exact = setup.material.density * c * velocity, period = 2 * length / c;
    Rebound      result{0, 0, 0, 0};
    unsigned int count = 0;
    while (scene.time() < 1.3 * period)
      {
        scene.step(scene.steps() % 50 == 0);
        const double pressure = scene.reaction(wall) / (h * h);
        if (pressure > 0.5 * exact)
          result.duration = scene.time() / period;
        if (scene.time() > 0.1 * period && scene.time() < 0.9 * period)
          result.plateau += pressure / exact, ++count;
      }
    double mass = 0;
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      result.speed += scene.solid.mass[n] * scene.solid.velocity[4 * n] / velocity,
        mass += scene.solid.mass[n];
    result.speed /= mass;
    result.plateau /= count;
    result.residual = scene.energy().residual() / scene.energy().start();
    return result;
  }

  void
  rods(Setup setup)
  {
    setup.material.poissons_ratio = 0;
    setup.bulk_viscosity          = 0.06;
    setup.step_factor             = 0.7; // every node lies on a free edge
    const Rebound     coarse = rod(setup, 200), fine = rod(setup, 400);
    const std::string name = form_name(setup) + ", rod on a wall: ";
    std::cout << "        speed after it with 200 and 400 cells: " << coarse.speed << ", " << fine.speed
              << "\n";
    BOOST_TEST(test::near(fine.plateau, 1, 5e-3, name + "mean plateau over rho c v"));
    BOOST_TEST(test::near(fine.duration, 1, 1e-2, name + "duration of the contact over 2 L / c"));
    BOOST_TEST(test::near(fine.speed, 1, 2e-2, name + "speed after it over that before"));
    // the bulk viscosity spreads the front like heat, over a width that grows with sqrt(h L)
    const double root = std::sqrt(2.);
    BOOST_TEST(test::near((root * fine.speed - coarse.speed) / (root - 1),
                          1,
                          5e-3,
                          name + "the same, extrapolated with the root of the cell size"));
    BOOST_TEST(test::near(fine.residual, 0, 1e-2, name + "energy balance"));
  }

  void
  ball(const Setup &setup)
  {
    // the full element is slower: fewer cells away from the contact
    const BallCells fine{0.12e-3, 0.9e-3, 1.3, 1.2e-3, 4, false},
      coarse{0.14e-3, 0.9e-3, 1.5, 2e-3, 3, false};
    const bool        reduced = setup.form == ElementForm::reduced;
    const BallImpact  result  = ball_impact(setup, 4, reduced ? fine : coarse);
    const std::string name    = form_name(setup) + ", ball on a plane: ";
    std::cout << "        " << result.cells << " cells, " << result.steps << " steps, force "
              << result.hertz_force << " N, duration " << result.hertz_duration * 1e6 << " us\n";
    BOOST_TEST(test::near(result.force, 1, 0.02, name + "largest force over Hertz's"));
    BOOST_TEST(test::near(result.duration, 1, 0.02, name + "duration over Hertz's"));
    BOOST_TEST(test::near(result.impulse, 1, 0.02, name + "impulse over 2 m v"));
    if (reduced)
      BOOST_TEST(result.stabilisation < 0.01,
                 name + "stabilisation over strain energy " + std::to_string(result.stabilisation));
    BOOST_TEST(test::near(result.residual, 0, 0.01, name + "energy balance"));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(solid_impact, test::Parallel)
{
  for (const Setup &setup : each_form(Setup()))
    {
      rods(setup);
      ball(setup);
    }
}
