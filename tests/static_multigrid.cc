// ranks: 1 2

// The equations of the static start: the levels of the octree, the product without a matrix, and how many
// steps conjugate gradients take, whatever the cells and the springs of contact.

#include <wheelrail/mesh/coarse_levels.h>
#include <wheelrail/mesh/discretization.h>
#include <wheelrail/statics/direct_coarse_solver.h>
#include <wheelrail/statics/iterative_coarse_solver.h>
#include <wheelrail/statics/static_multigrid.h>
#include <wheelrail/statics/static_system.h>

#include "parallel.h"
#include "small_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  double
  sum_of_ranks(double value)
  {
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return value;
  }

  Vector3
  place(const LocalMesh &mesh, const unsigned int n)
  {
    return {mesh.reference[4 * n], mesh.reference[4 * n + 1], mesh.reference[4 * n + 2]};
  }

  std::array<Vector3, 8>
  corners(const LocalMesh &mesh, const std::size_t cell)
  {
    std::array<Vector3, 8> X;
    for (int a = 0; a < 8; ++a)
      X[a] = place(mesh, mesh.cells[cell][a]);
    return X;
  }

  double
  volume(const LocalMesh &mesh)
  {
    double sum = 0;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      sum += element_geometry(corners(mesh, c)).volume;
    return sum_of_ranks(sum);
  }

  /// Largest distance between a node of the finer mesh and the place interpolated from the coarse one [m].
  double
  worst_interpolation(const CoarseLevel &coarse, const LocalMesh &finer)
  {
    double worst = 0;
    for (unsigned int n = 0; n < finer.n_nodes(); ++n)
      if (coarse.begin[n + 1] > coarse.begin[n])
        {
          Vector3 X{};
          for (unsigned int p = coarse.begin[n]; p < coarse.begin[n + 1]; ++p)
            add(X, coarse.weights[p], place(coarse.mesh, coarse.nodes[p]));
          worst = std::max(worst, norm(X - place(finer, n)));
        }
    return worst;
  }

  void
  levels(const Model &model)
  {
    const auto       coarse = coarse_levels(*model.discretization, model.solid.mesh);
    const LocalMesh *finer  = &model.solid.mesh;
    const double     whole  = volume(*finer);
    BOOST_TEST(coarse.size() == 2,
               std::to_string(coarse.size()) + " levels below cells of a quarter of a block");
    for (const CoarseLevel &level : coarse)
      {
        const std::string name = std::to_string(level.mesh.cells.size()) + " cells here: ";
        BOOST_TEST(sum_of_ranks(level.mesh.cells.size()) < sum_of_ranks(finer->cells.size()),
                   name + "fewer than in the finer mesh");
        // curved surfaces lose a little
        BOOST_TEST(near(volume(level.mesh) / whole, 1, 0.01, name + "volume over that of the finest mesh"));
        // curved faces of blocks bulge by 2.3 mm; a wrong corner would be off by half a block of 16 mm
        BOOST_TEST(near(worst_interpolation(level, *finer), 0, 3e-3, name + "interpolated places"));
        finer = &level.mesh;
      }
  }

  /// Numbers without order between -1 and 1, the same on any number of ranks.
  void
  fill_with_noise(const LocalMesh &mesh, const std::vector<unsigned char> &held, NodeVector &x)
  {
    for (unsigned int n = 0; n < mesh.n_owned; ++n)
      for (unsigned int i = 0; i < 3; ++i)
        x.begin()[4 * n + i] = held[n] ? 0 : mesh.noise(n, i);
    for (const unsigned int n : mesh.hanging)
      if (mesh.owns(n))
        std::fill_n(x.begin() + 4 * n, 3, 0.);
  }

  /// The product of the assembled element matrices with x.
  NodeVector
  assembled_product(const LocalMesh                  &mesh,
                    const PerBody<ElementBlocks>     &of_body,
                    const std::vector<unsigned char> &held,
                    const NodeVector                 &x)
  {
    NodeVector u = x, force = node_vector(mesh);
    u.update_ghost_values();
    distribute(mesh, u.begin());
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      {
        const ElementBlocks &blocks = of_body[mesh.cell_body[c]];
        const auto           K =
          element_stiffness(element_geometry(corners(mesh, c)), blocks.elasticity(), blocks.form);
        for (int a = 0; a < 24; ++a)
          for (int b = 0; b < 24; ++b)
            force.begin()[4 * mesh.cells[c][a / 3] + a % 3] +=
              K[24 * a + b] * u.begin()[4 * mesh.cells[c][b / 3] + b % 3];
      }
    condense(mesh, force.begin());
    force.compress(dealii::VectorOperation::add);
    for (unsigned int n = 0; n < mesh.n_owned; ++n)
      if (held[n])
        std::fill_n(force.begin() + 4 * n, 3, 0.);
    return force;
  }

  /// The springs when the wheel is pressed rigidly into the rail, times `factor`.
  std::vector<Contact::Spring>
  springs_of(Model &model, const double factor)
  {
    Solid &solid = model.solid;
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == Body::wheel)
        solid.displacement[4 * n + 1] = -60e-6;
    model.contact->gather(solid.displacement.data(), solid.velocity.data());
    model.contact->evaluate(0);
    auto springs = model.contact->springs();
    for (auto &spring : springs)
      spring.stiffness *= factor;
    return springs;
  }

  void
  operators(Model &model)
  {
    Solid                     &solid = model.solid;
    std::vector<unsigned char> held(solid.mesh.n_nodes(), 0);
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      {
        const double *X = &solid.mesh.reference[4 * n];
        held[n]         = solid.mesh.node_body[n] == Body::rail
                            ? X[1] < -0.15
                            : norm(Vector3{0, X[1], X[2]} - Vector3{0, model.axle.centre[1], 0}) < 0.2;
      }
    StaticMultigrid multigrid(*model.discretization, solid, held);
    StaticLevel    &level = multigrid.finest();
    NodeVector      x = level.zero(), y = level.zero(), Kx = level.zero(), Ky = level.zero();
    fill_with_noise(solid.mesh, held, x);
    for (unsigned int n = 0; n < solid.mesh.n_owned; ++n)
      for (int i = 0; i < 3; ++i)
        y.begin()[4 * n + i] = held[n] ? 0 : x.begin()[4 * n + (i + 1) % 3];
    level.product(x, Kx);
    NodeVector difference = assembled_product(solid.mesh, solid.blocks, held, x);
    difference -= Kx;
    BOOST_TEST(near(difference.l2_norm() / Kx.l2_norm(), 0, 1e-6, "product against the element matrices"));
    multigrid.set_springs(springs_of(model, 1));
    level.product(x, Kx);
    level.product(y, Ky);
    BOOST_TEST(near((y * Kx) / (x * Ky), 1, 1e-6, "with springs the product is symmetric"));
    NodeVector residual = Kx;
    level.subtract_product(x, residual);
    BOOST_TEST(near(residual.l2_norm() / Kx.l2_norm(), 0, 1e-12, "a product taken off itself"));
  }

  /// Forces of noise, solved for by a swept solver: the stiffness of the blocks gives them back.
  void
  swept_blocks(const Model &model)
  {
    for (const Body body : both_bodies)
      {
        const SweptGrid           &grid      = model.discretization->grid(body);
        const ElementBlocks       &blocks    = model.solid.blocks[body];
        const unsigned int         n_corners = grid.n_corners();
        std::vector<unsigned char> held(std::size_t(n_corners) * grid.n_sections(), 0);
        for (std::size_t n = 0; n < held.size(); ++n)
          held[n] = n % n_corners % 9 == 3; // lines along the body
        std::vector<double> forces(3 * held.size());
        for (std::size_t k = 0; k < forces.size(); ++k)
          forces[k] = held[k / 3] ? 0 : (k * 2654435761u % 1000003u) / 500001.5 - 1;
        std::vector<double> x = forces, back(forces.size(), 0.);
        make_swept_solver(grid, blocks.elasticity(), blocks.form, held)->solve(x);
        for (int column = 0; column < grid.n_columns(); ++column)
          for (int b = 0; b < grid.n_blocks(); ++b)
            {
              const auto K = element_stiffness(
                element_geometry(grid.coarse_vertices(b, column)), blocks.elasticity(), blocks.form);
              const auto row = [&](const int v) {
                return 3 * (std::size_t(n_corners) * ((column + v / 4) % grid.n_sections()) +
                            grid.corners(b)[v % 4]);
              };
              for (int p = 0; p < 24; ++p)
                for (int q = 0; q < 24; ++q)
                  back[row(p / 3) + p % 3] += K[24 * p + q] * x[row(q / 3) + q % 3];
            }
        double worst = 0, moved = 0;
        for (std::size_t k = 0; k < forces.size(); ++k)
          if (held[k / 3])
            moved = std::max(moved, std::abs(x[k]));
          else
            worst = std::max(worst, std::abs(back[k] - forces[k]));
        BOOST_TEST(near(worst,
                        0,
                        1e-10,
                        std::to_string(held.size()) +
                          " nodes of coarse blocks: forces of the solution off those "
                          "asked for"));
        BOOST_TEST(moved == 0, "held nodes stay");
      }
  }

  /// Two terms that join nodes of the rail far from each other, the second of which takes off stiffness.
  std::vector<JoinedNodes>
  terms_between(const LocalMesh &mesh)
  {
    std::vector<JoinedNodes> terms{{5e9, {}}, {-2e8, {}}};
    for (unsigned int n = 0; n < mesh.n_owned; ++n)
      if (const auto key = mesh.node_key[n]; mesh.node_body[n] == Body::rail && key % 97 == 0)
        terms[key % 2].nodes.emplace_back(n, Vector3{0.1 * (key % 7), 0.1 * (key % 5), 0.1 * (key % 3)});
    return terms;
  }

  /// Springs as the coarsest level has them.
  StaticSprings
  on_coarsest(StaticSprings                     springs,
              const std::vector<CoarseLevel>   &levels,
              const std::vector<unsigned char> &held)
  {
    for (const CoarseLevel &level : levels)
      springs = springs.coarsened(
        level, &level == &levels.back() ? held : std::vector<unsigned char>(level.mesh.n_nodes(), 0));
    return springs;
  }

  /// The coarsest level solved for directly: its stiffness, what joins nodes and springs give the forces
  /// back. And about by conjugate gradients, which know no joined nodes.
  void
  coarsest_level(Model &model)
  {
    const LocalMesh           &finest = model.solid.mesh;
    const auto                 levels = coarse_levels(*model.discretization, finest);
    const LocalMesh           &mesh   = levels.back().mesh;
    std::vector<unsigned char> held(mesh.n_nodes(), 0), held_finest(finest.n_nodes(), 0);
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      held[n] = model.discretization->grid(mesh.node_body[n]).corner_of_key(mesh.node_key[n]) % 9 == 3;
    const StaticSprings springs =
      on_coarsest({springs_of(model, 1), finest, held_finest, MPI_COMM_WORLD}, levels, held);
    const StaticSprings joined =
      on_coarsest({terms_between(finest), finest, held_finest, MPI_COMM_WORLD}, levels, held);
    NodeVector forces = node_vector(mesh), x = forces, z = forces;
    for (unsigned int n = 0; n < mesh.n_owned; ++n)
      if (!held[n] && std::abs(mesh.reference[4 * n + 2]) < 0.05)
        forces.begin()[4 * n + 1] = mesh.node_body[n] == Body::rail ? -1 : 1;
    const PerBody<ElementBlocks> &blocks = model.solid.blocks;
    DirectCoarseSolver            with_joined(*model.discretization, mesh, blocks, held, {{}, joined});
    with_joined.set_springs(springs);
    with_joined.solve(forces, x);
    NodeVector back = assembled_product(mesh, blocks, held, x);
    springs.add_product(1, x.begin(), back.begin());
    BOOST_TEST(std::abs(back.l2_norm() / forces.l2_norm() - 1) > 1e-3,
               "joined nodes bear some of the forces");
    joined.add_product(1, x.begin(), back.begin());
    back -= forces;
    BOOST_TEST(
      near(back.l2_norm() / forces.l2_norm(), 0, 1e-8, "forces of the direct solution off those asked for"));

    DirectCoarseSolver    direct(*model.discretization, mesh, blocks, held);
    IterativeCoarseSolver iterative(mesh, blocks, held, {}, MPI_COMM_WORLD);
    direct.set_springs(springs);
    iterative.set_springs(springs);
    direct.solve(forces, x);
    iterative.solve(forces, z);
    // the energy of the exact solution is the largest; a fifth of the forces is left by the other one
    BOOST_TEST(springs.size() > 0, std::to_string(springs.size()) + " springs reach the coarse blocks");
    BOOST_TEST(near((forces * z) / (forces * x), 1, 0.05, "work of the forces, iterative over direct"));
    z.add(-1, x);
    BOOST_TEST(near(z.l2_norm() / x.l2_norm(), 0, 0.2, "displacements, iterative off direct"));
  }

  unsigned int
  steps(Model &model, const double factor, const std::string &name)
  {
    const LocalMesh &mesh = model.solid.mesh;
    StaticSystem     system(*model.discretization, model.solid, model.parts);
    const auto       springs = springs_of(model, factor);
    system.set_springs(springs);
    // all springs pull alike: forces as rough as those of a start
    std::map<std::uint32_t, Vector3> pull;
    for (const auto &spring : springs)
      for (const auto &[node, weight] : spring.nodes)
        add(pull[node], weight, spring.normal);
    AlignedVector<double> force(4 * mesh.n_nodes(), 0.);
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      if (const auto at = pull.find(mesh.global_node[n]); at != pull.end())
        std::copy(at->second.begin(), at->second.end(), &force[4 * n]);
    StaticStep         step;
    const unsigned int taken = system.solve(system.right_hand_side(force), 100, 1e-6, step);
    BOOST_TEST(taken <= 20, name + ": " + std::to_string(taken) + " steps of conjugate gradients for 1e-6");
    BOOST_TEST(step.hub_displacement > 0, name + ": a force upwards lifts the wheel");
    return taken;
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(static_multigrid, test::Parallel)
{
  Model model = small_model(MPI_COMM_WORLD, 4e-3);
  levels(model);
  operators(model);
  const unsigned int taken = steps(model, 1, "4 mm");
  steps(model, 100, "4 mm, springs a hundred times as stiff");
  Model coarse = small_model(MPI_COMM_WORLD, 8e-3);
  BOOST_TEST(taken <= steps(coarse, 1, "8 mm") + 2, "finer cells take about as many steps");
  swept_blocks(model);
  coarsest_level(model);
}
