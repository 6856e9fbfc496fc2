// A block of cubes under a step of pressure, against the exact answer: speed and error of both elements.
//
//   benchmark_block SCENE [B]    reads SCENE.msh (gmsh 2.2) and SCENE.json, see tests/scenes/block_motion.h
//   benchmark_block [N] [B]      makes N^3 cubes of 1 mm itself, elastic at 100 MPa and plastic at 1 GPa
//
// B is the bulk viscosity, 0.06 without. With mpirun on several ranks, too. One update is one element in one
// step; updates per second of all ranks by wall time and by CPU time (which a busy machine does not change).

#include <deal.II/base/mpi.h>

#include "scenes/block_motion.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>

using namespace scenes;

namespace
{
  struct Result
  {
    double wall  = 0; ///< of the steps [s]
    double cpu   = 0; ///< of the steps, mean of the ranks [s]
    double error = 0; ///< root mean square over the largest displacement
  };

  /// Runs the scene. An elastic block is compared up to its end, a plastic one until the reflected wave is
  /// back at the face.
  Result
  run(const BlockScene &scene, const wheelrail::ElementForm form, const double viscosity)
  {
    BlockMotion  block(scene, form, viscosity, MPI_COMM_WORLD);
    const double length  = scene.high[0] - scene.low[0];
    const double limit   = scene.plasticity.elastic() ? 1e300 : 2 * length / scene.material.wave_speed();
    double       squares = 0, largest = 0;
    Result       result;
    unsigned int compared = 0;
    for (unsigned long k = 1; k <= scene.steps; ++k)
      {
        const auto start = std::chrono::steady_clock::now();
        block.step();
        result.wall += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const double time = k * scene.time_step, found = block.face_displacement();
        if (time < limit)
          {
            const double exact = exact_face(scene, time);
            squares += (found - exact) * (found - exact);
            largest = std::max(largest, exact);
            ++compared;
          }
      }
    result.error = std::sqrt(squares / compared) / largest;
    result.cpu   = block.loop.timing().sum();
    MPI_Allreduce(MPI_IN_PLACE, &result.cpu, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    int size;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    result.cpu /= size;
    return result;
  }

  void
  table(const BlockScene &scene, const double viscosity)
  {
    int rank, size;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    for (const auto form : {wheelrail::ElementForm::reduced, wheelrail::ElementForm::full})
      {
        const Result result  = run(scene, form, viscosity);
        const double updates = double(scene.mesh.cells.size()) * scene.steps;
        if (rank == 0)
          std::printf("%9zu %6d %9s %8s %6lu %9.3f %9.3f %9.3f %10.1f %9.3f\n",
                      scene.mesh.cells.size(),
                      size,
                      form == wheelrail::ElementForm::full ? "full" : "reduced",
                      scene.plasticity.elastic() ? "elastic" : "plastic",
                      scene.steps,
                      result.wall,
                      1e-6 * updates / result.wall,
                      1e-6 * updates / result.cpu,
                      1e9 * result.cpu / updates,
                      100 * result.error);
        std::fflush(stdout);
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  int                                            rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const std::string what      = argc > 1 ? argv[1] : "31";
  const double      viscosity = argc > 2 ? std::atof(argv[2]) : 0.06;
  if (rank == 0)
    std::printf("%9s %6s %9s %8s %6s %9s %9s %9s %10s %9s\n",
                "elements",
                "ranks",
                "element",
                "material",
                "steps",
                "wall [s]",
                "M/s wall",
                "M/s CPU",
                "ns CPU",
                "error [%]");
  try
    {
      if (what.find_first_not_of("0123456789") != std::string::npos)
        table(read_block(what), viscosity);
      else
        for (const bool plastic : {false, true})
          {
            BlockScene scene = block_of_cubes(std::stoul(what), 1e-3, plastic ? 1e9 : 1e8, 0.9, 200);
            if (plastic)
              scene.plasticity = {280e6, 21e9, 0};
            table(scene, viscosity);
          }
    }
  catch (const std::exception &problem)
    {
      std::cerr << problem.what() << "\n";
      MPI_Abort(MPI_COMM_WORLD, 1);
    }
}
