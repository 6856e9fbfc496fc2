#include <wheelrail/mesh/forest.h>
#include <wheelrail/statics/direct_bottom.h>
#include <wheelrail/statics/iterative_bottom.h>

#include <memory>
#include <vector>

namespace wheelrail
{
  std::unique_ptr<StaticBottom>
  make_static_bottom(const Forest                     &forest,
                     const LocalMesh                  &mesh,
                     const PerBody<ElementBlocks>     &blocks,
                     const std::vector<unsigned char> &held,
                     const AlignedVector<double>      &ground)
  {
    constexpr double most_memory = 1e9; // blocks of 8 mm take 0.7 of it, of 16 mm 0.05
    const double     memory =
      swept_solver_memory(forest.grid(Body::rail)) + swept_solver_memory(forest.grid(Body::wheel));
    if (memory < most_memory)
      return std::make_unique<DirectBottom>(forest, mesh, blocks, held, ground);
    return std::make_unique<IterativeBottom>(mesh, blocks, held, ground, forest.communicator());
  }


  SpringBlocks
  spring_blocks(const StaticSprings &springs)
  {
    SpringBlocks blocks;
    const auto  &parts = springs.parts();
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
                block[3 * i + j] += springs.stiffness()[spring] * parts[a].weight[i] * parts[b].weight[j];
          }
      }
    return blocks;
  }
} // namespace wheelrail
