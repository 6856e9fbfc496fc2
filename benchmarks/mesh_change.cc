// What a change of the mesh costs, by parts: the triangulation with its unknowns, the plain arrays, solid and
// contact.
//
//   benchmark_mesh_change FILE.prm ["Section/Entry = value" ...]
//
// With mpirun on several ranks, too.

#include <wheelrail/mesh/coarse_levels.h>
#include <wheelrail/model/model.h>

#include "scene_main.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

using namespace wheelrail;

namespace
{
  /// The median time of five calls [ms], the slowest rank.
  double
  milliseconds(const std::function<void()> &call, MPI_Comm communicator)
  {
    std::vector<double> times;
    for (int n = 0; n < 5; ++n)
      {
        MPI_Barrier(communicator);
        const auto begin = std::chrono::steady_clock::now();
        call();
        double taken = 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        MPI_Allreduce(MPI_IN_PLACE, &taken, 1, MPI_DOUBLE, MPI_MAX, communicator);
        times.push_back(taken);
      }
    std::sort(times.begin(), times.end());
    return times[2];
  }

  void
  run(const Scene &scene, MPI_Comm communicator)
  {
    int rank;
    MPI_Comm_rank(communicator, &rank);
    const auto tell = [&](const std::string &what, const std::function<void()> &call) {
      const double ms = milliseconds(call, communicator);
      if (rank == 0)
        std::printf("%-60s %8.1f ms\n", what.c_str(), ms);
    };
    const SceneGeometry geometry = make_geometry(scene);
    const SweepPlan     plan     = sweep_plan(scene, geometry);
    Discretization      discretization(communicator, plan);
    int                 moved = 0; // by a block, to and fro
    const auto          zones = [&]() {
      const double by   = moved++ % 2 * plan.block_length();
      const Range  fine = {plan.fine.s0 + by, plan.fine.s1 + by};
      return PerBody<FineZone>{{fine}, {fine}};
    };
    tell("blocks, once", [&]() { Discretization(communicator, plan); });
    tell("triangulation and unknowns", [&]() { discretization.lay(zones()); });
    tell("plain arrays", [&]() { discretization.local_mesh(); });
    Model model = make_model(scene, geometry, communicator);
    tell("all of these, solid, contact", [&]() { prepare_mesh(model, communicator); });
    tell("coarse levels of static solutions",
         [&]() { coarse_levels(*model.discretization, model.solid.mesh); });
  }
} // namespace

int
main(int argc, char **argv)
{
  return benchmark_scene(argc, argv, run);
}
