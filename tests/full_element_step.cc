// label: fast

// The stable step of the full hexahedron: highest frequencies of meshes by power iteration, and random motion
// of flat, nearly incompressible cells.

#include "parallel.h"
#include "scenes/dynamics.h"

#include <algorithm>
#include <random>
#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  /// Highest frequencies over the estimate that gives the stable step. The cells' own patterns must stay
  /// below; free edges of nearly incompressible cubes go beyond the default factor 0.95
  /// (doc/theory/element.md).
  void
  frequencies()
  {
    scenes::Setup setup;
    setup.form        = ElementForm::full;
    const auto corner = [](const Vector3 &X) { return X[0] + X[1] + X[2] < 4e-3; };
    const auto show   = [&](const std::string &name, const LocalMesh &mesh, const double most) {
      scenes::Dynamics scene(mesh, setup);
      const double     ratio = scene.highest_frequency(600) * scene.solid.stable.step / 2;
      BOOST_TEST(ratio < most,
                 name + ", nu = " + std::to_string(setup.material.poissons_ratio) +
                   ": highest frequency over the estimate " + std::to_string(ratio));
    };
    for (const double nu : {0., 0.3, 0.49})
      {
        setup.material.poissons_ratio = nu;
        const double flat = 1 / 0.95, edges = nu > 0.4 ? 1.2 : flat;
        show("free cubes", scenes::box({0, 0, 0}, {8e-3, 8e-3, 8e-3}, {8, 8, 8}), edges);
        show("free rods 1 : 1 : 20", scenes::box({0, 0, 0}, {8e-3, 8e-3, 1.6e-1}, {8, 8, 8}), edges);
        show(
          "refined corner", scenes::two_level_box({0, 0, 0}, {6e-3, 6e-3, 6e-3}, {6, 6, 6}, corner), edges);
        show("free flat bricks 1 : 5 : 20", scenes::box({0, 0, 0}, {8e-3, 4e-2, 1.6e-1}, {8, 8, 8}), flat);
        show("distorted, refined corner",
             scenes::two_level_box({0, 0, 0}, {6e-3, 6e-3, 6e-3}, {6, 6, 6}, corner, 0.2),
             flat);
      }
  }

  /// Random motion of flat, nearly incompressible cells at the step that the program would take.
  void
  flat_cells_at_their_step()
  {
    scenes::Setup setup;
    setup.form                    = ElementForm::full;
    setup.bulk_viscosity          = 0.06;
    setup.material.poissons_ratio = 0.49;
    scenes::Dynamics scene(scenes::box({0, 0, 0}, {6e-3, 3e-2, 1.2e-1}, {6, 6, 6}), setup);
    std::mt19937     random(1);
    std::uniform_real_distribution<double> value(-1e-6, 1e-6);
    for (std::size_t k = 0; k < scene.solid.velocity.size(); ++k)
      scene.solid.velocity[k] = k % 4 < 3 ? value(random) : 0;
    const double start = scene.kinetic_energy();
    double       most  = 0;
    while (scene.steps() < 3000 && most < 1e6)
      {
        scene.step();
        most = std::max(most, scene.kinetic_energy() / start);
      }
    BOOST_TEST(most < 1.5,
               "cells 1 : 5 : 20, nu = 0.49, 3000 steps: kinetic energy grows at most " +
                 std::to_string(most));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(full_element_step, test::Parallel)
{
  frequencies();
  flat_cells_at_their_step();
}
