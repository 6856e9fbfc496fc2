// The whole step of a block of n^3 cubes by phases: elements, exchange between ranks, boundary conditions,
// update of the nodes. Elastic; elastic-plastic with no point and with every point in plastic flow; both
// elements. Arguments: n of the blocks, 31 46 65 without. With mpirun on several ranks, too.

#include <deal.II/base/mpi.h>

#include "scenes/block_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

using namespace scenes;

namespace
{
  enum class Case
  {
    elastic,
    no_yield,
    all_yield
  };

  int rank, n_ranks;

  /// Random velocities [m/s], the same on every rank, so that cells are strained anew in every step.
  void
  shake(BlockMotion &block, const double speed)
  {
    for (unsigned int n = 0; n < block.solid.mesh.n_nodes(); ++n)
      for (int i = 0; i < 3; ++i)
        {
          const unsigned int hash         = (3 * block.solid.mesh.global_node[n] + i) * 2654435761u;
          block.solid.velocity[4 * n + i] = speed * ((hash >> 8) * 0x1p-23 - 1);
        }
  }

  /// Part of this rank's elements on which plastic work was done in the step.
  double
  flowing(BlockMotion &block)
  {
    auto &blocks = block.solid.blocks.rail;
    if (!blocks.plastic())
      return 0;
    const auto before = blocks.plastic_work;
    block.step();
    std::size_t count = 0;
    for (std::size_t k = 0; k < blocks.n_elements; ++k)
      count += blocks.plastic_work[k] != before[k];
    return double(count) / blocks.n_elements;
  }

  /// Bytes that one update moves at least, when each array comes from memory once in each of the two passes:
  /// elements (geometry, node numbers, viscous state in and out, history and work in and out, displacement
  /// in, force in and out) and nodes (force, velocity, displacement in and out, masses).
  double
  bytes(const BlockMotion &block, const Case kind)
  {
    const auto  &blocks  = block.solid.blocks.rail;
    const double nodes   = double(block.solid.mesh.n_nodes()) / blocks.n_elements;
    double       element = 8 * blocks.rows + 32 + 32 + nodes * 3 * 32;
    if (kind == Case::all_yield)
      element += 16. * (blocks.history_rows() + 1);
    return element + nodes * (6 * 32 + 16);
  }

  /// One line of the table: medians over samples, the mean of the ranks.
  void
  measure(const unsigned int n, const Case kind, const wheelrail::ElementForm form)
  {
    const char *names[] = {"elastic", "plastic, no yield", "plastic, all yield"};
    BlockScene  scene   = block_of_cubes(n, 1e-3, 0, 0.5, 0);
    if (kind != Case::elastic)
      scene.plasticity = {kind == Case::no_yield ? 1e12 : 1e3, 21e9, 1};
    BlockMotion block(scene, form, 0.06, MPI_COMM_WORLD);
    shake(block, 0.1);
    block.step();

    const int           samples = 9, repeat = std::max<int>(2, 500000 / scene.mesh.cells.size());
    std::vector<double> phases[6];
    for (int sample = 0; sample < samples; ++sample)
      {
        const auto   before = block.loop.timing();
        const double begin  = MPI_Wtime();
        for (int r = 0; r < repeat; ++r)
          block.step();
        const double wall    = MPI_Wtime() - begin;
        const auto  &t       = block.loop.timing();
        double       sums[6] = {t.elements - before.elements,
                                t.exchange - before.exchange,
                                t.parts - before.parts,
                                t.update - before.update,
                                t.sum() - before.sum(),
                                wall};
        MPI_Allreduce(MPI_IN_PLACE, sums, 6, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
        for (int k = 0; k < 6; ++k)
          phases[k].push_back(sums[k] / n_ranks / repeat);
      }
    const double flow = flowing(block);
    if (rank != 0)
      return;
    double median[6];
    for (int k = 0; k < 6; ++k)
      {
        std::sort(phases[k].begin(), phases[k].end());
        median[k] = phases[k][samples / 2] / (double(scene.mesh.cells.size()) / n_ranks) * 1e9;
      }
    std::printf("%9zu %5d %8s %18s %8.2f %8.2f %9.1f %9.1f %9.1f %9.1f %8.0f %8.0f %7.1f\n",
                scene.mesh.cells.size(),
                n_ranks,
                form == wheelrail::ElementForm::full ? "full" : "reduced",
                names[static_cast<int>(kind)],
                1e3 * n_ranks / median[5],
                1e3 * n_ranks / median[4],
                median[0],
                median[1],
                median[2],
                median[3],
                100 * flow,
                bytes(block, kind),
                bytes(block, kind) / median[4]);
    std::fflush(stdout);
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
  std::vector<unsigned int> edges;
  for (int k = 1; k < argc; ++k)
    edges.push_back(std::atoi(argv[k]));
  if (edges.empty())
    edges = {31, 46, 65};
  if (rank == 0)
    std::printf(
      "M updates/s of all ranks; phases in ns per update of one rank; bytes per update, and GB/s of one "
      "rank\n"
      "%9s %5s %8s %18s %8s %8s %9s %9s %9s %9s %8s %8s %7s\n",
      "elements",
      "ranks",
      "element",
      "material",
      "M/s wall",
      "M/s CPU",
      "elements",
      "exchange",
      "boundary",
      "update",
      "flow [%]",
      "bytes",
      "GB/s");
  try
    {
      for (const unsigned int n : edges)
        for (const auto form : {wheelrail::ElementForm::reduced, wheelrail::ElementForm::full})
          for (const Case kind : {Case::elastic, Case::no_yield, Case::all_yield})
            measure(n, kind, form);
    }
  catch (const std::exception &problem)
    {
      std::fprintf(stderr, "%s\n", problem.what());
      MPI_Abort(MPI_COMM_WORLD, 1);
    }
}
