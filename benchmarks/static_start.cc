// The static start of a scene alone: steps, times, and the equilibrium found.
//
//   benchmark_static_start FILE.prm ["Section/Entry = value" ...]
//
// With mpirun on several ranks, too. CPU time is the mean of the ranks; a busy machine changes it less than
// the wall time.

#include <wheelrail/model/model.h>
#include <wheelrail/run/run_start.h>

#include "scene_main.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <string>

using namespace wheelrail;

namespace
{
  /// Time of this process [s].
  double
  cpu_seconds()
  {
    return double(std::clock()) / CLOCKS_PER_SEC;
  }

  void
  run(const Scene &scene, MPI_Comm communicator)
  {
    int rank, size;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &size);
    Model              model  = make_model(scene, make_geometry(scene), communicator);
    const StaticLoads  loads  = static_loads(scene, model);
    const double       cpu    = cpu_seconds();
    const auto         begin  = std::chrono::steady_clock::now();
    const StaticResult result = static_start(
      *model.discretization, model.solid, *model.contact, model.parts, loads, [&](const std::string &line) {
        if (rank == 0)
          std::printf("%s\n", line.c_str());
      });
    double taken = cpu_seconds() - cpu;
    MPI_Allreduce(MPI_IN_PLACE, &taken, 1, MPI_DOUBLE, MPI_SUM, communicator);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    if (rank != 0)
      return;
    std::printf("hexahedra %zu, ranks %d\n", model.solid.quality.elements, size);
    std::printf("wall %.2f s, CPU %.2f s\n", wall.count(), taken / size);
    std::printf("Newton steps %d, CG steps %d, flow steps %d\n",
                result.newton_steps,
                result.cg_steps,
                result.flow_steps);
    std::printf("hub %.9g mm, creepage %.9g, residual %.3g, converged %d, border %d\n",
                1e3 * result.hub_displacement,
                result.creepage,
                result.residual,
                result.converged,
                result.at_border);
    std::printf("force %.9g %.9g %.9g N, peak %.9g MPa, %d nodes\n",
                result.contact_force[0],
                result.contact_force[1],
                result.contact_force[2],
                1e-6 * model.contact->evaluate(0).largest_pressure,
                model.contact->evaluate(0).nodes);
  }
} // namespace

int
main(int argc, char **argv)
{
  return benchmark_scene(argc, argv, run);
}
