// ranks: 1 2 3

// Numbers of nodes and cells that do not depend on the partition, and a state that one number of ranks
// writes and another reads, with the plastic history of the elements.

#include <wheelrail/base/errors.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/state/checkpoint.h>

#include "checkpoint_everywhere.h"
#include "error_of.h"
#include "parallel.h"
#include "small_scene.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  /// A model with the parts that a checkpoint holds.
  struct Parts
  {
    Model    model;
    Axle     axle;
    Rolling  rolling;
    Recorder recorder;

    explicit Parts(MPI_Comm communicator)
      : model(plastic_model(communicator))
      , axle(model.axle, -1e-4, 80, communicator)
      , rolling(model.solid, *model.contact, model.parts, axle, {model.time_step, 0.06, 0}, communicator)
      , recorder(model)
    {
    }

    static Model
    plastic_model(MPI_Comm communicator)
    {
      Model model = test::small_model(communicator, 4e-3);
      // the rail alone
      set_law(model.solid.blocks.rail, BilinearLaw(model.solid.blocks.rail.elasticity(), {300e6, 21e9, 0}));
      return model;
    }
  };

  /// A number that tells where it belongs: to component i of a node or cell at X.
  double
  mark(const Vector3 &X, const int i)
  {
    return 1 + X[0] + 10 * X[1] + 100 * X[2] + 1000 * i;
  }

  Vector3
  centre(const LocalMesh &mesh, const std::size_t cell)
  {
    Vector3 sum{};
    for (const unsigned int n : mesh.cells[cell])
      for (int d = 0; d < 3; ++d)
        sum[d] += mesh.reference[4 * n + d] / 8;
    return sum;
  }

  /// Calls work(value, wanted) for every number of the state that is marked by its place.
  template <typename Work>
  void
  for_each(Solid &solid, const Work &work)
  {
    const LocalMesh &mesh = solid.mesh;
    for (std::size_t n = 0; n < mesh.n_nodes(); ++n)
      for (int d = 0; d < 3; ++d)
        {
          const double *R = &mesh.reference[4 * n];
          const Vector3 X = {R[0], R[1], R[2]};
          work(solid.displacement[4 * n + d], mark(X, d));
          work(solid.velocity[4 * n + d], mark(X, 3 + d));
        }
    for (const Body body : both_bodies)
      {
        ElementBlocks &blocks = solid.blocks[body];
        for (std::size_t e = 0; e < blocks.n_elements; ++e)
          {
            const Vector3     X     = centre(mesh, solid.block_cells[body][e]);
            const std::size_t batch = e / blocks.width, lane = e % blocks.width;
            for (int row = 0; row < 2; ++row)
              work(blocks.viscous[(batch * 2 + row) * blocks.width + lane], mark(X, 40 + row));
            if (!blocks.plastic())
              continue;
            work(blocks.plastic_work[e], mark(X, 7));
            // half of the rail has flowed
            const double flowed = X[2] > 0 ? 1 : 0;
            for (int row = 0; row < blocks.history_rows(); ++row)
              work(blocks.history[(batch * blocks.history_rows() + row) * blocks.width + lane],
                   flowed * mark(X, 8 + row));
          }
      }
  }

  void
  check_restored(Parts &parts, const Checkpoint &whole, MPI_Comm communicator, const std::string &what)
  {
    restore_checkpoint(whole, parts.model, parts.rolling, parts.recorder, communicator);
    // positions are the same up to round-off, since another cell may come first at a node
    double largest = 0;
    for_each(parts.model.solid, [&](const double value, const double wanted) {
      largest = std::max(largest, std::abs(value - wanted));
    });
    BOOST_TEST(near(largest, 0, 1e-9, what + ": every number is at its place, largest difference"));
    BOOST_TEST((parts.axle.height() == -2e-4 && parts.axle.pitch_rate() == 81), what + ": the axle");

    const ElementBlocks &rail = parts.model.solid.blocks.rail;
    bool                 same = true;
    for (std::size_t batch = 0; batch < rail.flowed.size(); ++batch)
      {
        bool flowed = false;
        for (std::size_t e = batch * rail.width; e < std::min((batch + 1) * rail.width, rail.n_elements); ++e)
          flowed = flowed || centre(parts.model.solid.mesh, parts.model.solid.block_cells.rail[e])[2] > 0;
        same = same && flowed == (rail.flowed[batch] == 1);
      }
    BOOST_TEST(same, what + ": the batches that have flowed are known");
  }

  /// The rail alone, under a new wheel of a steel that keeps many more numbers than the rail's: they are
  /// zero, whatever lies in memory behind those of the rail.
  void
  check_rail_alone(const Checkpoint &whole)
  {
    Parts          parts(MPI_COMM_WORLD);
    Solid         &solid = parts.model.solid;
    ElementBlocks &wheel = solid.blocks.wheel;
    MaterialData   steel;
    steel.law           = SteelLaw::chaboche;
    steel.yield_stress  = 400e6;
    steel.cyclic.moduli = {40e9, 10e9, 2e9};
    steel.cyclic.rates  = {500, 100, 0};
    set_law(wheel, material_law(steel));
    BOOST_TEST(wheel.history_rows() > solid.blocks.rail.history_rows() + 10, "a wheel with longer rows");
    for_each(solid, [](double &value, double) { value = 7; });
    BOOST_TEST(restore_bodies(whole, solid, 0, MPI_COMM_WORLD, Body::rail), "the rail alone is restored");
    bool zeros = true, there = true;
    for (const AlignedVector<double> *values : {&wheel.history, &wheel.plastic_work})
      for (std::size_t e = 0; e < wheel.n_elements; ++e)
        {
          const int rows = values == &wheel.history ? wheel.history_rows() : 1;
          for (int row = 0; row < rows; ++row)
            zeros =
              zeros &&
              (*values)[rows == 1 ? e : (e / wheel.width * rows + row) * wheel.width + e % wheel.width] == 0;
        }
    BOOST_TEST(zeros, "the wheel has not flowed");
    const ElementBlocks &rail = solid.blocks.rail;
    for (std::size_t e = 0; e < rail.n_elements; ++e)
      there = there &&
              std::abs(rail.plastic_work[e] - mark(centre(solid.mesh, solid.block_cells.rail[e]), 7)) < 1e-9;
    BOOST_TEST(there, "the rail has done its work");
  }

  /// The rank's part of a sum of works.
  double
  viscous(const Parts &parts)
  {
    return parts.rolling.state().energy.works.at("viscous_dissipation");
  }
} // namespace


BOOST_AUTO_TEST_CASE(checkpoint_ranks)
{
  const Parallel  parallel;
  Parts           parts(MPI_COMM_WORLD);
  TimeLoop::State rolling                        = parts.rolling.state();
  rolling.parts.at("axle").numbers["height"]     = -2e-4;
  rolling.parts.at("axle").numbers["pitch_rate"] = 81;
  rolling.energy.works.at("viscous_dissipation") = 1 + parallel.rank;
  parts.rolling.set_state(rolling);
  for_each(parts.model.solid, [](double &value, const double wanted) { value = wanted; });

  const Checkpoint part = take_checkpoint(parts.model, parts.rolling, parts.recorder);
  BOOST_TEST(is_finite(part, MPI_COMM_WORLD), "the state is finite");
  const Checkpoint whole = everywhere(gather_checkpoint(part, MPI_COMM_WORLD), parallel.rank);
  BOOST_TEST((whole.ranks == parallel.size), "the state tells its number of ranks");
  const MeshQuality &quality = parts.model.solid.quality;
  BOOST_TEST((whole.node.size() == quality.nodes && whole.cell.size() == quality.elements),
             "all nodes and cells");

  Parts again(MPI_COMM_WORLD);
  check_restored(again, whole, MPI_COMM_WORLD, "as many ranks");
  BOOST_TEST((viscous(again) == 1 + parallel.rank), "as many ranks: each has its own sum");
  Parts alone(MPI_COMM_SELF);
  check_restored(alone, whole, MPI_COMM_SELF, "one rank");
  BOOST_TEST((viscous(alone) == 0.5 * parallel.size * (parallel.size + 1)), "one rank: all sums");

  check_rail_alone(whole);

  Checkpoint broken = part;
  if (parallel.rank == parallel.size - 1)
    broken.node_values["velocity"].values.back() = std::nan("");
  BOOST_TEST(!is_finite(broken, MPI_COMM_WORLD), "a value that is not finite is seen on all ranks");
  Checkpoint other = whole;
  other.node_values["position"].values[4] += 1e-6;
  const std::string error = test::error_of<InputError>(
    [&]() { restore_checkpoint(other, alone.model, alone.rolling, alone.recorder, MPI_COMM_SELF); });
  BOOST_TEST((error.find("the mesh is not that of the saved state") != std::string::npos),
             "another mesh is refused");
}
