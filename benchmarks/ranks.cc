// What a scene sends in each step on the ranks that run it: cells, neighbours, messages and bytes of the
// busiest rank. Counts, so that more ranks than cores tell as much as a cluster. mpirun -n N benchmark_ranks
// FILE.prm: one line of the table, with its head for N = 1.

#include <wheelrail/base/errors.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/model/model.h>
#include <wheelrail/model/scene_checks.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <string>

using namespace wheelrail;

namespace
{
  struct Counts
  {
    double cells      = 0; ///< of this rank
    double nodes      = 0; ///< held by this rank
    double neighbours = 0;
    double shared     = 0;     ///< bytes sent to neighbours in a step
    double window     = 0;     ///< bytes of the contact window sent in a step
    double received   = 0;     ///< bytes of the contact window received in a step
    bool   holds      = false; ///< nodes of the contact window
    double memory     = 0;     ///< resident [bytes]
  };

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
    dealii::Utilities::System::MemoryStats memory;
    dealii::Utilities::System::get_memory_stats(memory);
    counts.memory = 1024. * memory.VmRSS;
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
    const double n     = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    const double cells = dealii::Utilities::MPI::sum(counts.cells, MPI_COMM_WORLD),
                 most = largest(counts.cells), nodes = largest(counts.nodes),
                 neighbours = largest(counts.neighbours), shared = largest(counts.shared),
                 window = largest(counts.window), received = largest(counts.received),
                 memory  = largest(counts.memory),
                 holders = dealii::Utilities::MPI::sum(counts.holds ? 1. : 0., MPI_COMM_WORLD);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
      return;
    if (n == 1)
      std::printf(
        "ranks  cells of the busiest  over the mean  nodes   neighbours  sent to them kB  window sent kB"
        "  window received kB  ranks that hold it  memory MB\n");
    std::printf("%5.0f  %20.0f  %13.3f  %6.0f  %10.0f  %15.1f  %14.1f  %18.1f  %18.0f  %9.0f\n",
                n,
                most,
                most * n / cells,
                nodes,
                neighbours,
                1e-3 * shared,
                1e-3 * window,
                1e-3 * received,
                holders,
                1e-6 * memory);
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      const SceneInput input = read_scene(argc > 1 ? argv[1] : "prm/rolling.prm", {});
      Model            model = make_model(input.scene, require_computable(input), MPI_COMM_WORLD);
      print(counts_of(model));
    }
  catch (const InputError &error)
    {
      std::cerr << "error: " << error.what() << std::endl;
      return 1;
    }
  return 0;
}
