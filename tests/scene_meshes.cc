// label: fast

// The meshes of the idealised scenes: volumes, masses, surfaces and hanging nodes.

#include "scenes/dynamics.h"
#include "scenes/shapes.h"

#include "parallel.h"

#include <array>
#include <cmath>
#include <string>

using namespace scenes;
using namespace wheelrail;

namespace
{
  struct Measures
  {
    double  volume = 0;
    Vector3 area{}; ///< integral of the outward normal over the faces chosen
  };

  Measures
  measures(const LocalMesh &mesh, const Predicate &faces)
  {
    Measures   result;
    const auto X = [&](const unsigned int n) { return place_of(mesh, n); };
    for (const auto &cell : mesh.cells)
      {
        std::array<Vector3, 8> corners;
        for (int a = 0; a < 8; ++a)
          corners[a] = X(cell[a]);
        result.volume += element_geometry(corners).volume;
      }
    for (const auto &face : select_faces(mesh, faces))
      add(result.area, 0.5, cross(X(face.nodes[3]) - X(face.nodes[0]), X(face.nodes[2]) - X(face.nodes[1])));
    return result;
  }

  const Predicate everywhere = [](const Vector3 &) { return true; };

  void
  check_mesh(const LocalMesh &mesh, const double volume, const double tolerance, const std::string &name)
  {
    const Measures all = measures(mesh, everywhere);
    BOOST_TEST(test::near(
      all.volume / volume, 1, tolerance, name + ", " + std::to_string(mesh.cells.size()) + " cells: volume"));
    BOOST_TEST(
      test::near(norm(all.area) / std::pow(volume, 2. / 3), 0, 1e-12, name + ": the surface is closed"));
    const Dynamics scene(mesh, Setup());
    double         mass = 0;
    for (const double m : scene.solid.mass)
      mass += m;
    BOOST_TEST(test::near(mass / (7900 * all.volume), 1, 1e-12, name + ": lumped mass"));
    BOOST_TEST(scene.solid.quality.worst_jacobian > 0.15,
               name + ": worst corner Jacobian " + std::to_string(scene.solid.quality.worst_jacobian));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(scene_meshes, test::Parallel)
{
  const auto low = [](const Vector3 &X) { return X[0] < 1; };
  check_mesh(box({0, 0, 0}, {2, 1, 1}, {4, 3, 2}), 2, 1e-12, "box");
  // area: the faces between both levels cancel
  check_mesh(two_level_box({0, 0, 0}, {2, 1, 1}, {4, 3, 2}, low, 0.15), 2, 1e-12, "box of two levels");
  check_mesh(quarter_cylinder(0.1, 0.2, 0.01, {8, 12, 1}, 2), M_PI / 4 * 3e-4, 4e-3, "quarter of a cylinder");
  check_mesh(sphere_octant(0.1, 0.2, 8, 8, 2), M_PI / 6 * 7e-3, 8e-3, "octant of a sphere");
  BallCells cells{0.4e-3, 1.2e-3, 1.3, 2e-3, 5, false};
  check_mesh(quarter_ball(0.01, cells), M_PI / 3 * 1e-6, 1e-2, "quarter of a ball");
  cells.half = true;
  check_mesh(quarter_ball(0.01, cells), M_PI / 6 * 1e-6, 1e-2, "quarter of half a ball");
  const LocalMesh first = two_level_box({0, 0, 0}, {2, 1, 1}, {2, 2, 2}, low);
  check_mesh(join(first, box({0, 0, 1}, {2, 1, 2}, {2, 2, 2}, Body::rail)), 4, 1e-12, "two bodies");
  const Measures inner = measures(sphere_octant(0.1, 0.2, 4, 8),
                                  [](const Vector3 &X) { return norm(X) < 0.101 && X[0] * X[1] * X[2] > 0; });
  BOOST_TEST(test::near(norm(inner.area) / (std::sqrt(3.) * M_PI / 4 * 0.01),
                        1,
                        1e-2,
                        "inner faces of the sphere: projected area of an eighth"));
}
