// ranks: 1 2 3

// Meshes of a moving window: alike at all places, and the state that goes from
// one to the next.

#include <wheelrail/mesh/fine_window.h>
#include <wheelrail/model/model.h>
#include <wheelrail/solid/transfer.h>

#include "parallel.h"
#include "small_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  Scene
  moving_scene()
  {
    Scene scene            = small_scene(2e-3);
    scene.window           = MeshWindow::moving;
    scene.rolling_distance = 40e-3;
    scene.rail_length      = 0.5;
    return scene;
  }

  double
  largest(double value)
  {
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    return value;
  }

  double
  sum(double value)
  {
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return value;
  }

  Vector3
  reference(const LocalMesh &mesh, const std::size_t node)
  {
    const double *X = &mesh.reference[4 * node];
    return {X[0], X[1], X[2]};
  }

  using Field = std::function<Vector3(const Vector3 &, Body)>;

  /// A rotation of the wheel by more than half a turn and a linear field, and of the rail a linear field.
  Vector3
  linear_displacement(const Vector3 &X, const Body body)
  {
    const Vector3 axis = {1, 0, 0}, centre = {0.02, 0.45, 0};
    const Vector3 strained = {
      X[0] * 1.001 + 2e-4 * X[1], X[1] * 0.999 + 3e-4 * X[2], X[2] * 1.002 - 1e-4 * X[0]};
    if (body == Body::rail)
      return strained - X;
    return centre + Vector3{0, -1e-4, 1.7} + Rotation(axis, 3.7)(strained - centre) - X;
  }

  Vector3
  linear_velocity(const Vector3 &X, const Body body)
  {
    const Vector3 spin = {84, 0, 0}, x = X + linear_displacement(X, body);
    if (body == Body::rail)
      return {0.1 * X[1], 0.2 - 0.3 * X[2], 0.4 * X[0] + 0.1};
    return Vector3{0, 0.1, 38.9} + cross(spin, x);
  }

  void
  set(Solid &solid, const Field &displacement, const Field &velocity)
  {
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      {
        const Vector3 X = reference(solid.mesh, n), u = displacement(X, solid.mesh.node_body[n]),
                      v = velocity(X, solid.mesh.node_body[n]);
        std::copy(u.begin(), u.end(), &solid.displacement[4 * n]);
        std::copy(v.begin(), v.end(), &solid.velocity[4 * n]);
      }
    distribute(solid.mesh, solid.displacement.data());
    distribute(solid.mesh, solid.velocity.data());
  }

  double
  off(const Solid &solid, const AlignedVector<double> &values, const Field &field)
  {
    double error = 0;
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      {
        const double *v = &values[4 * n];
        error           = std::max(
          error, norm(Vector3{v[0], v[1], v[2]} - field(reference(solid.mesh, n), solid.mesh.node_body[n])));
      }
    return largest(error);
  }

  /// Linear and angular momentum of a body.
  std::array<double, 6>
  momentum(const Solid &solid, const Body body)
  {
    std::array<double, 6> p{};
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.owns(n) && solid.mesh.node_body[n] == body)
        {
          const double  m = solid.mass[n] + solid.added_mass[n];
          const double *v = &solid.velocity[4 * n];
          const Vector3 l =
            m * cross(solid.position(static_cast<unsigned int>(n)), Vector3{v[0], v[1], v[2]});
          for (int i = 0; i < 3; ++i)
            {
              p[i] += m * v[i];
              p[3 + i] += l[i];
            }
        }
    MPI_Allreduce(MPI_IN_PLACE, p.data(), 6, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return p;
  }

  /// All nodes move freely.
  std::vector<NodeInertia>
  free_nodes(const Solid &solid)
  {
    return node_inertia(solid);
  }

  void
  change(Model &model, const FineWindow &window, const double time_step = 0)
  {
    const SolidChoice choice = model.solid.choice;
    const double      middle = 16e-3 * window.column.rail;
    SolidTransfer     transfer(std::move(model.solid), middle, MPI_COMM_WORLD);
    model.solid.choice = choice;
    model.window       = window;
    prepare_mesh(model, MPI_COMM_WORLD);
    transfer.fill(model.solid, free_nodes(model.solid), time_step);
  }

  void
  linear_fields(Model &model)
  {
    const StableStep step = model.solid.stable;
    for (const int column : {1, 2, 5, 0})
      {
        const std::string at = "column " + std::to_string(column) + ": ";
        set(model.solid, linear_displacement, linear_velocity);
        FineWindow window;
        window.column.rail  = column;
        window.column.wheel = column == 5 ? 176 : column; // some turn later the same place, and another one
        change(model, window);
        BOOST_TEST(near(
          off(model.solid, model.solid.displacement, linear_displacement), 0, 1e-13, at + "displacements"));
        // the correction of the momentum takes up what chords of coarse cells lack in mass
        BOOST_TEST(
          near(off(model.solid, model.solid.velocity, linear_velocity), 0, 0.02, at + "velocities nearly"));
        BOOST_TEST(near(model.solid.stable.step / step.step, 1, 1e-9, at + "the same stable step"));
        BOOST_TEST(model.contact->rail().lattice.first_station != 0, at + "the contact has its lattice");
      }
  }

  /// At the start, cells reach no further than those of a fixed mesh.
  void
  ends_of_path(Model &model)
  {
    const SweepPlan &plan = model.discretization->plan();
    const double     path = 10e-3, block = plan.block_length(), step = model.solid.stable.step;
    FineWindow       window;
    window.path_end   = {path, path};
    const Scene scene = moving_scene();
    const auto  patch =
      overlap_along(make_geometry(scene), kik_piotrowski * model.expected_approach, scene.fine_margin);
    const double bound = std::max(-patch.s0, patch.s1);
    BOOST_TEST(near(plan.reach - bound,
                    3 * scene.cell_size,
                    1e-12,
                    "three cells beyond the patch, where a margin of two is given [m]"));
    BOOST_TEST(near(window_range(plan, window, Body::rail).s0, -plan.reach, 1e-12, "begin of the path [m]"));
    BOOST_TEST(
      near(window_range(plan, window, Body::wheel).s1, path + plan.reach, 1e-12, "end of the path [m]"));
    change(model, window);
    BOOST_TEST(near(model.solid.stable.step / step, 1, 1e-9, "the same stable step with cells cut off"));
    BOOST_TEST(!follow(window, plan, {path, path + 1e-3}), "a wheel that creeps stays");
    BOOST_TEST(follow(window, plan, {path, path + 5e-3}),
               "a wheel that spins beyond the path takes cells with it");
    BOOST_TEST(near(
      window_range(plan, window, Body::wheel).s1, plan.around_block.s1, 1e-12, "as far as anywhere [m]"));
    BOOST_TEST(near(
      window_range(plan, window, Body::rail).s1, path + plan.reach, 1e-12, "those of the rail stay [m]"));
    BOOST_TEST(!follow(window, plan, {path, path + 5e-3}), "once");
    // a resumed run with a longer way
    model.window = window;
    BOOST_TEST(!lengthen_path(model, path), "the same path");
    BOOST_TEST(lengthen_path(model, 4 * path), "a longer path");
    BOOST_TEST(near(window_range(plan, model.window, Body::rail).s1,
                    plan.around_block.s1,
                    1e-12,
                    "the rail's cells, too, reach on [m]"));
    model.window  = FineWindow();
    window.column = {2, 2};
    BOOST_TEST(near(window_range(plan, window, Body::rail).s0,
                    2 * block + plan.around_block.s0,
                    1e-12,
                    "behind the wheel later on [m]"));
    BOOST_TEST(near(
      window_range(plan, window, Body::rail).s1, 2 * block + plan.around_block.s1, 1e-12, "ahead of it [m]"));
  }

  /// Blocks of a rail of 10 m: even where the wheel can roll, long at the ends.
  void
  long_rail()
  {
    Scene scene                      = moving_scene();
    scene.rail_length                = 10;
    const SweepPlan            plan  = sweep_plan(scene, make_geometry(scene));
    const std::vector<double> &z     = plan.rail_stations;
    double                     worst = 0;
    const double               block = plan.block_length();
    unsigned int               even  = 0;
    for (std::size_t k = 0; k + 1 < z.size(); ++k)
      {
        const double length = z[k + 1] - z[k];
        even += std::abs(length / block - 1) < 1e-9;
        BOOST_TEST((length > 0.99 * block && length < 4.01 * block), "length of a block");
        if (k > 0)
          worst = std::max(worst, std::max(length / (z[k] - z[k - 1]), (z[k] - z[k - 1]) / length));
      }
    BOOST_TEST(near(z.front(), 0.02 - 5, 1e-12, "begin of the rail [m]"));
    BOOST_TEST(near(z.back(), 0.02 + 5, 1e-12, "its end [m]"));
    BOOST_TEST(worst < 1.26, "blocks grow slowly");
    BOOST_TEST((even * block > 2 && z.size() < 310), "even over two metres, fewer than half as many in all");
    BOOST_TEST((plan.longest_path > 0.9 && plan.longest_path < 1.1), "about a metre more can be rolled");
  }

  void
  momentum_is_kept(Model &model)
  {
    const auto wave = [](const Vector3 &X, Body) {
      return Vector3{
        std::sin(300 * X[2]), std::cos(200 * X[2] + 100 * X[1]), std::sin(400 * X[0] + 250 * X[2])};
    };
    const auto small = [&](const Vector3 &X, const Body body) { return 1e-6 * wave(X, body); };
    FineWindow window;
    change(model, window);
    set(model.solid, small, wave);
    const PerBody<std::array<double, 6>> before = {momentum(model.solid, Body::rail),
                                                   momentum(model.solid, Body::wheel)};
    for (const int column : {1, 2, 3, 1})
      {
        window.column = {column, column};
        change(model, window, 1e-7);
        for (const Body body : both_bodies)
          {
            const auto after = momentum(model.solid, body);
            double     lost  = 0;
            for (int i = 0; i < 3; ++i)
              lost = std::max(lost, std::abs(after[i] - before[body][i]));
            BOOST_TEST(near(lost,
                            0,
                            1e-10,
                            std::string(body_name(body)) + ": momentum at column " + std::to_string(column)));
          }
      }
  }

  /// Finest cells of the rail's block between 0 and the block's length.
  double
  finest_of_first_block(const Model &model)
  {
    const SweepPlan &plan  = model.discretization->plan();
    double           count = 0;
    for (std::size_t c = 0; c < model.solid.mesh.cells.size(); ++c)
      {
        const double z = 0.5 * (reference(model.solid.mesh, model.solid.mesh.cells[c][0])[2] +
                                reference(model.solid.mesh, model.solid.mesh.cells[c][7])[2]);
        if (model.solid.mesh.cell_body[c] == Body::rail && z > 0 && z < plan.block_length() &&
            CellPlace::of_key(model.solid.mesh.cell_key[c]).level == plan.levels)
          ++count;
      }
    return sum(count);
  }

  /// Where the rail has flowed its cells stay fine behind the wheel.
  void
  flowed_cells_stay()
  {
    Scene scene                      = moving_scene();
    scene.rail_material.yield_stress = 480e6;
    Model        model               = make_model(scene, make_geometry(scene), MPI_COMM_WORLD);
    const double block               = model.discretization->plan().block_length();
    prepare_mesh(model, MPI_COMM_WORLD);
    const double   fine = finest_of_first_block(model);
    ElementBlocks &rail = model.solid.blocks.rail;
    for (std::size_t e = 0; e < rail.n_elements; ++e)
      {
        const auto  &cell = model.solid.mesh.cells[model.solid.block_cells.rail[e]];
        const double z =
          0.5 * (reference(model.solid.mesh, cell[0])[2] + reference(model.solid.mesh, cell[7])[2]);
        if (z > 0 && z < block)
          {
            const std::size_t batch = e / rail.width, row = batch * rail.history_rows() + 5;
            rail.history[row * rail.width + e % rail.width] = 1e-3; // accumulated plastic strain
            rail.flowed[batch]                              = 1;
          }
      }
    BOOST_TEST(fine > 0, "fine cells at the start");
    BOOST_TEST(move_window(scene, model, {3.5 * block, 3.5 * block}, MPI_COMM_WORLD),
               "the wheel comes to another block");
    BOOST_TEST((model.window.kept.rail == std::vector<int>{0}), "the block that has flowed is kept");
    BOOST_TEST(model.window.kept.wheel.empty(), "none of the wheel");
    prepare_mesh(model, MPI_COMM_WORLD);
    BOOST_TEST(near(finest_of_first_block(model), fine, 0, "its fine cells"));
    model.window.kept.rail.clear();
    prepare_mesh(model, MPI_COMM_WORLD);
    BOOST_TEST(finest_of_first_block(model) < 0.1 * fine, "which else would be gone");
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(moving_window, test::Parallel)
{
  const Scene scene = moving_scene();
  Model       model = make_model(scene, make_geometry(scene), MPI_COMM_WORLD);
  linear_fields(model);
  ends_of_path(model);
  long_rail();
  momentum_is_kept(model);
  flowed_cells_stay();
}
