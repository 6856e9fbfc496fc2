// ranks: 1 2
// Nodal stresses from those of elements: linear ones exactly, on the swept meshes of wheel and rail, on
// distorted cells with hanging nodes and on their surfaces; others with the fourth order inside of even
// cells, with the third at surfaces.

#include <wheelrail/solid/stress_recovery.h>

#include "parallel.h"
#include "scenes/dynamics.h"
#include "small_scene.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

using namespace scenes;
using namespace test;
using namespace wheelrail;

namespace
{
  using Stress = std::array<double, 6>;
  using Law    = std::function<double(const Vector3 &)>;

  /// Largest difference of recovered nodal values from the law, over the nodes chosen.
  double
  largest_error(const Solid &solid, const Law &law, const Predicate &which, MPI_Comm communicator)
  {
    PerBody<std::vector<Stress>> stress;
    for (const Body body : both_bodies)
      for (const unsigned int cell : solid.block_cells[body])
        {
          Vector3 centre{};
          for (const unsigned int node : solid.mesh.cells[cell])
            add(centre, 0.125, place_of(solid.mesh, node));
          const double value = law(centre);
          stress[body].push_back({value, -value, 2 * value, 0, value, 3 * value});
        }
    const auto nodal = recovered_stress(solid, stress).stress;
    double     error = 0;
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      if (const Vector3 X = place_of(solid.mesh, n); which(X))
        for (int k = 0; k < 6; ++k)
          error = std::max(error, std::abs(nodal[6 * n + k] - Stress{1, -1, 2, 0, 1, 3}[k] * law(X)));
    MPI_Allreduce(MPI_IN_PLACE, &error, 1, MPI_DOUBLE, MPI_MAX, communicator);
    return error;
  }

  const Predicate everywhere = [](const Vector3 &) { return true; };

  double
  linear(const Vector3 &X)
  {
    return 1 + 2 * X[0] - 3 * X[1] + X[2];
  }

  double
  wavy(const Vector3 &X)
  {
    return std::sin(2 * X[0] + 1) * std::cos(X[1]) * std::exp(X[2]);
  }

  double
  curved(const Vector3 &X)
  {
    return 1 + X[0] - X[2] + 2 * X[0] * X[0] - X[1] * X[1] + 3 * X[0] * X[1] - X[1] * X[2] + X[2] * X[2];
  }

  /// Errors inside and on the surface of a unit cube of n cells a side.
  std::array<double, 2>
  errors_of_cube(const unsigned int n)
  {
    const Dynamics  scene(box({0, 0, 0}, {1, 1, 1}, {n, n, n}), Setup());
    const Predicate inside = [](const Vector3 &X) {
      return *std::min_element(X.begin(), X.end()) > 0.2 && *std::max_element(X.begin(), X.end()) < 0.8;
    };
    return {largest_error(scene.solid, wavy, inside, MPI_COMM_SELF),
            largest_error(scene.solid, wavy, everywhere, MPI_COMM_SELF)};
  }

  void
  on_one_rank()
  {
    const auto     low = [](const Vector3 &X) { return X[0] < 1; };
    const Dynamics scene(two_level_box({0, 0, 0}, {2, 1, 1}, {4, 3, 2}, low, 0.15), Setup());
    BOOST_TEST(near(largest_error(scene.solid, linear, everywhere, MPI_COMM_SELF),
                    0,
                    1e-7,
                    "distorted cells of two levels: linear stress"));

    const auto coarse = errors_of_cube(10), fine = errors_of_cube(20);
    std::cout << "        inside " << coarse[0] << ", " << fine[0] << "; with the surface " << coarse[1]
              << ", " << fine[1] << "; 10 and 20 cells" << std::endl;
    // on the coarser cube surfaces still reach a little into what counts as inside, so the order is higher
    BOOST_TEST(std::log2(coarse[0] / fine[0]) > 3.7, "even cells: the fourth order at least inside");
    BOOST_TEST(
      near(std::log2(coarse[1] / fine[1]), 3, 0.3, "even cells: order of convergence on the surface"));

    const Dynamics cube(box({0, 0, 0}, {1, 1, 1}, {5, 5, 5}), Setup());
    BOOST_TEST(near(largest_error(cube.solid, curved, everywhere, MPI_COMM_SELF),
                    0,
                    1e-4,
                    "even cells: quadratic stress, at surfaces, edges and corners too"));

    const Dynamics single(box({0, 0, 0}, {1, 1, 1}, {1, 1, 1}), Setup());
    BOOST_TEST(near(largest_error(
                      single.solid, [](const Vector3 &) { return 1; }, everywhere, MPI_COMM_SELF),
                    0,
                    1e-14,
                    "a single cell: its own stress"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(stress_recovery)
{
  const Parallel parallel;
  const Model    model = test::small_model(MPI_COMM_WORLD, 4e-3);
  // the web of the wheel and the toes of the foot are one layer of cells
  const Predicate around_contact = [](const Vector3 &X) { return norm(X) < 0.08; };
  BOOST_TEST(near(largest_error(model.solid, linear, around_contact, MPI_COMM_WORLD),
                  0,
                  1e-7,
                  "head and tread: linear stress"));
  if (parallel.size == 1)
    on_one_rank();
}
