// What a scene costs each of the ranks that run it: cells, neighbours, messages and bytes of the busiest one;
// memory, that of the coarse blocks, which every rank has, and nodes of the running surfaces; processor time.
// Counts, so that more ranks than cores tell as much as a cluster. mpirun -n N benchmark_ranks FILE.prm: one
// line of the table, with its head for N = 1.

#include <wheelrail/base/errors.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/model/model.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/solid/exchange.h>
#include <wheelrail/solid/motion.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/base/utilities.h>
#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using namespace wheelrail;

namespace
{
  struct Counts
  {
    double cells      = 0; ///< of this rank
    double nodes      = 0; ///< held by this rank
    double neighbours = 0;
    double shared     = 0;       ///< bytes sent to neighbours in a step
    double window     = 0;       ///< bytes of the contact window sent in a step
    double received   = 0;       ///< bytes of the contact window received in a step
    bool   holds      = false;   ///< nodes of the contact window
    double surfaces   = 0;       ///< nodes of the running surfaces
    double memory     = 0;       ///< resident, beyond what the program has before it makes the model [bytes]
    double coarse     = 0;       ///< of that, for a coarse block [bytes]
    double set_up = 0, step = 0; ///< processor time of the model, of a step without parts [s]
  };

  double
  resident()
  {
    dealii::Utilities::System::MemoryStats memory;
    dealii::Utilities::System::get_memory_stats(memory);
    return 1024. * memory.VmRSS;
  }

  double
  processor_time()
  {
    return double(std::clock()) / CLOCKS_PER_SEC;
  }

  /// Processor time of a step of bodies and contact [s].
  double
  time_of_step(Model &model)
  {
    constexpr int steps   = 10;
    Solid        &solid   = model.solid;
    const auto    inertia = node_inertia(solid);
    const auto    update  = make_velocity_update(model.time_step, 0);
    ElementEnergy ignored;
    const double  begin = processor_time();
    for (int k = 0; k < steps; ++k)
      {
        subtract_internal_force(
          solid.blocks, solid.displacement.data(), solid.force.data(), BulkViscosity(), false, ignored);
        model.contact->gather(solid.displacement.data(), solid.velocity.data());
        model.contact->evaluate(model.time_step);
        model.contact->add_forces(solid.force.data());
        condense(solid.mesh, solid.force.data());
        sum_over_ranks(solid.mesh, solid.force.data());
        move_nodes(solid, inertia, update, model.time_step, false);
        distribute(solid.mesh, solid.displacement.data());
      }
    return (processor_time() - begin) / steps;
  }

  Counts
  counts_of(Model &model)
  {
    const LocalMesh &mesh = model.solid.mesh;
    Counts           counts;
    counts.cells = mesh.cells.size();
    counts.nodes = mesh.n_nodes();
    // to owners of ghosts, then back from them
    const auto &exchange = *mesh.partitioner;
    counts.neighbours    = std::max(exchange.ghost_targets().size(), exchange.import_targets().size());
    counts.shared = sizeof(double) * (double(exchange.n_ghost_indices()) + exchange.n_import_indices());
    int rank;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    Contact &contact = *model.contact;
    contact.move_window(0, 0);
    for (const Body body : both_bodies)
      {
        const Surface      &surface  = contact.surface(body);
        const StationRange &stations = contact.window()[body];
        for (std::size_t k = surface.lattice.index(stations.first, 0);
             k < surface.lattice.index(stations.last, 0);
             ++k)
          {
            (surface.owner[k] == rank ? counts.window : counts.received) += 6. * sizeof(double);
            counts.holds = counts.holds || surface.local[k] >= 0;
          }
      }
    counts.surfaces = contact.rail().reference.size() + contact.wheel().reference.size();
    return counts;
  }

  double
  largest(const double value)
  {
    return dealii::Utilities::MPI::max(value, MPI_COMM_WORLD);
  }

  void
  print(const Counts &counts)
  {
    const double n       = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    const double cells   = dealii::Utilities::MPI::sum(counts.cells, MPI_COMM_WORLD),
                 most    = largest(counts.cells),
                 holders = dealii::Utilities::MPI::sum(counts.holds ? 1. : 0., MPI_COMM_WORLD);
    const std::vector<std::pair<const char *, double>> columns = {
      {"ranks", n},
      {"cells", cells},
      {"of the busiest", most},
      {"over the mean", most * n / cells},
      {"nodes", largest(counts.nodes)},
      {"neighbours", largest(counts.neighbours)},
      {"sent to them kB", 1e-3 * largest(counts.shared)},
      {"window sent kB", 1e-3 * largest(counts.window)},
      {"window received kB", 1e-3 * largest(counts.received)},
      {"ranks that hold it", holders},
      {"nodes of surfaces", largest(counts.surfaces)},
      {"bytes a coarse block", largest(counts.coarse)},
      {"memory MB", 1e-6 * largest(counts.memory)},
      {"set-up s", largest(counts.set_up)},
      {"step ms", 1e3 * largest(counts.step)}};
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
      return;
    for (const auto &[name, value] : columns)
      if (n == 1)
        std::printf("%s  ", name);
    for (const auto &[name, value] : columns)
      std::printf(
        "%s%*.6g  ", n == 1 && name == columns.front().first ? "\n" : "", int(std::strlen(name)), value);
    std::printf("\n");
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      const SceneInput    input    = read_scene(argc > 1 ? argv[1] : "prm/rolling.prm", {});
      const SceneGeometry geometry = require_computable(input);
      const double        before = resident(), begin = processor_time();
      double              coarse;
      {
        const Discretization blocks(MPI_COMM_WORLD, sweep_plan(input.scene, geometry));
        coarse = (resident() - before) / blocks.triangulation().n_cells(0);
      }
      Model  model  = make_model(input.scene, geometry, MPI_COMM_WORLD);
      Counts counts = counts_of(model);
      counts.set_up = processor_time() - begin;
      counts.step   = time_of_step(model);
      counts.memory = resident() - before;
      counts.coarse = coarse;
      print(counts);
    }
  catch (const InputError &error)
    {
      std::cerr << "error: " << error.what() << std::endl;
      return 1;
    }
  return 0;
}
