// label: fast

// Patch test of the explicit solid on distorted meshes and meshes with hanging nodes, and an imposed
// rotation.

#include "scenes/dynamics.h"

#include "parallel.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

using namespace scenes;
using namespace wheelrail;

namespace
{
  const double gradient[3][3] = {{1e-3, 2e-3, 0}, {-5e-4, -1e-3, 5e-4}, {3e-4, 0, 1e-3}};

  /// Sides of the unit box.
  bool
  on_side(const Vector3 &X)
  {
    for (int i = 0; i < 3; ++i)
      if (X[i] < 1e-9 || X[i] > 1 - 1e-9)
        return true;
    return false;
  }

  LocalMesh
  distorted_box()
  {
    LocalMesh mesh = box({0, 0, 0}, {1, 1, 1}, {4, 4, 4});
    distort(mesh, 0.06, [](const Vector3 &X) { return !on_side(X); });
    return mesh;
  }

  /// The sides move linearly, inside the nodes find their places by themselves: the stress of every
  /// element, the energy and the place of every node are those of the linear field.
  void
  patch(Setup setup, const LocalMesh &mesh, const std::string &text)
  {
    const std::string name = form_name(setup) + ", " + text;
    setup.mass_damping     = 4e3;
    Dynamics     scene(mesh, setup);
    const double ramp = 100 * scene.time_step;
    const Nodes  side = select(mesh, on_side);
    for (const unsigned int n : side)
      for (int i = 0; i < 3; ++i)
        {
          const Vector3 X = place_of(mesh, n);
          const double  u = gradient[i][0] * X[0] + gradient[i][1] * X[1] + gradient[i][2] * X[2];
          scene.prescribe({n}, i, [=](const double t) { return u * std::min(1., t / ramp); });
        }
    while (scene.steps() < 4000)
      scene.step();
    scene.step(true);
    const auto stress = element_stress(scene.solid.blocks.wheel, scene.solid.displacement.data());
    double     spread = 0, place = 0;
    for (const auto &s : stress)
      for (int k = 0; k < 6; ++k)
        spread = std::max(spread, std::abs(s[k] - stress[0][k]));
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      for (int i = 0; i < 3; ++i)
        {
          const Vector3 X = place_of(mesh, n);
          const double  u = gradient[i][0] * X[0] + gradient[i][1] * X[1] + gradient[i][2] * X[2];
          place           = std::max(place, std::abs(scene.solid.displacement[4 * n + i] - u));
        }
    std::cout << "        " << mesh.cells.size() << " cells, " << mesh.hanging.size() << " hanging nodes\n";
    BOOST_TEST(test::near(spread / std::abs(stress[0][0]), 0, 1e-10, name + ": spread of the stress"));
    BOOST_TEST(test::near(
      place / 2e-3, 0, 1e-10, name + ": error of the nodes' places over the largest displacement"));
    const auto &energy = scene.energy();
    BOOST_TEST(test::near(energy["stabilisation_energy"] / energy["strain_energy"],
                          0,
                          1e-20,
                          name + ": stabilisation over strain energy"));
    BOOST_TEST(test::near(
      energy.residual() / energy["strain_energy"], 0, 1e-6, name + ": energy balance of the loading"));
  }

  /// Ten turns of a distorted mesh with hanging nodes leave neither stress nor force.
  void
  rotation(const Setup &setup, const LocalMesh &mesh)
  {
    Dynamics     scene(mesh, setup);
    Solid       &solid = scene.solid;
    const double angle = 10 * 2 * M_PI + 1;
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      {
        const Vector3 X = place_of(mesh, n), u = Rotation(normalised({1, 2, 3}), angle)(X) - X;
        for (int i = 0; i < 3; ++i)
          solid.displacement[4 * n + i] = u[i];
      }
    scene.step();
    double stress = 0, force = 0;
    for (const auto &s : element_stress(solid.blocks.wheel, solid.displacement.data()))
      for (const double x : s)
        stress = std::max(stress, std::abs(x));
    for (const double f : solid.force)
      force = std::max(force, std::abs(f));
    const double E = Elasticity().youngs_modulus;
    BOOST_TEST(test::near(stress / E,
                          0,
                          1e-13,
                          form_name(setup) + ", ten turns with hanging nodes: stress over Young's modulus"));
    BOOST_TEST(test::near(force / E, 0, 1e-13, form_name(setup) + ", ten turns with hanging nodes: force"));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(solid_patch, test::Parallel)
{
  const LocalMesh hanging = two_level_box(
    {0, 0, 0},
    {1, 1, 1},
    {3, 3, 3},
    [](const Vector3 &X) { return X[0] < 0.6 && X[1] > 0.4 && X[2] < 0.6; },
    0.1);
  for (const Setup &setup : each_form(Setup()))
    {
      patch(setup, distorted_box(), "distorted");
      patch(setup, hanging, "hanging nodes");
      rotation(setup, hanging);
    }
}
