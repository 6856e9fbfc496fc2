#include <wheelrail/mesh/discretization.h>
#include <wheelrail/statics/direct_coarse_solver.h>
#include <wheelrail/statics/iterative_coarse_solver.h>

#include <algorithm>
#include <memory>
#include <vector>

// Choice of the coarse solver by the memory of exact factors (doc/theory/rolling.md, Static start, 4).

namespace wheelrail
{
  namespace
  {
    /// Springs of single nodes that hold as much as the ground when all nodes move alike.
    AlignedVector<double>
    even_springs(const StaticGround &ground, const LocalMesh &mesh)
    {
      // The matrix of the iterative solver has springs of single nodes alone. Unknowns condensed into the
      // ground take k k'/K off them: the row sums of these terms, taken off the diagonal (lumped), leave the
      // force of a translation as it is.
      AlignedVector<double> even = ground.springs;
      if (ground.joined.size() == 0)
        return even;
      for (int i = 0; i < 3; ++i)
        {
          AlignedVector<double> moved(4 * mesh.n_nodes(), 0.), force(moved);
          for (std::size_t n = 0; n < mesh.n_owned; ++n)
            // row sums of the joined terms: what holds a translation along i
            moved[4 * n + i] = 1;
          ground.joined.add_product(1, moved.data(), force.data());
          for (std::size_t n = 0; n < mesh.n_owned; ++n)
            // a row below zero would make the matrix indefinite, and conjugate gradients fail
            even[4 * n + i] = std::max(0., even[4 * n + i] + force[4 * n + i]);
        }
      return even;
    }
  } // namespace


  std::unique_ptr<CoarseSolver>
  make_coarse_solver(const Discretization             &discretization,
                     const LocalMesh                  &mesh,
                     const PerBody<ElementBlocks>     &blocks,
                     const std::vector<unsigned char> &held,
                     const StaticGround               &ground)
  {
    constexpr double most_memory = 1e9; // blocks of 8 mm take 0.7 of it, of 16 mm 0.05
    // exact factors of both bodies [bytes]: unknowns times band width
    const double memory = swept_solver_memory(discretization.grid(Body::rail)) +
                          swept_solver_memory(discretization.grid(Body::wheel));
    // the exact one is linear, so that the whole cycle of multigrid is
    if (memory < most_memory)
      return std::make_unique<DirectCoarseSolver>(discretization, mesh, blocks, held, ground);
    return std::make_unique<IterativeCoarseSolver>(
      mesh, blocks, held, even_springs(ground, mesh), discretization.communicator());
  }


  SpringBlocks
  spring_blocks(const StaticSprings &springs)
  {
    SpringBlocks blocks;
    // B' C B of all springs, gathered by pairs of nodes: parts of one spring follow one another, and each
    // pair of them gives a block in both orders, so that the sum is symmetric
    const auto &parts = springs.parts();
    for (std::size_t a = 0; a < parts.size(); ++a)
      {
        const unsigned int spring = parts[a].spring;
        std::size_t        b      = a; // parts are in the order of the springs
        while (b > 0 && parts[b - 1].spring == spring)
          --b;
        for (; b < parts.size() && parts[b].spring == spring; ++b)
          {
            auto &block = blocks[{parts[a].node, parts[b].node}];
            for (int i = 0; i < 3; ++i)
              for (int j = 0; j < 3; ++j)
                // k w_a (x) w_b: the block of two nodes in B' C B
                block[3 * i + j] += springs.stiffness()[spring] * parts[a].weight[i] * parts[b].weight[j];
          }
      }
    return blocks;
  }
} // namespace wheelrail
