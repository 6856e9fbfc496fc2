#include <wheelrail/solid/histories.h>

#include <algorithm>

namespace wheelrail
{
  namespace
  {
    /// Place of element e's first number in an array of visit_histories().
    std::size_t
    packed_place(const std::size_t e, const unsigned int width, const unsigned int components)
    {
      return e / width * width * components + e % width;
    }
  } // namespace


  std::map<std::string, NumberedValues>
  cell_histories(const Solid &solid)
  {
    std::map<std::string, NumberedValues> all;
    for (const Body body : both_bodies)
      visit_histories(solid.blocks[body], [&](const char *name, const unsigned int n, const auto &) {
        all[name].components = std::max(all[name].components, n);
      });
    for (auto &entry : all)
      entry.second.values.resize(entry.second.components * solid.mesh.cells.size());
    for (const Body body : both_bodies)
      {
        const ElementBlocks &blocks = solid.blocks[body];
        visit_histories(blocks,
                        [&](const char *name, const unsigned int n, const AlignedVector<double> &packed) {
                          NumberedValues &v = all[name];
                          for (std::size_t e = 0; e < blocks.n_elements; ++e)
                            for (unsigned int i = 0; i < n; ++i)
                              v.values[v.components * solid.block_cells[body][e] + i] =
                                packed[packed_place(e, blocks.width, n) + i * blocks.width];
                        });
      }
    return all;
  }


  void
  set_cell_histories(Solid                                                                          &solid,
                     const std::function<const double *(const std::string &name, std::size_t cell)> &rows)
  {
    for (const Body body : both_bodies)
      {
        ElementBlocks &blocks = solid.blocks[body];
        visit_histories(blocks, [&](const char *name, const unsigned int n, AlignedVector<double> &packed) {
          for (std::size_t e = 0; e < blocks.n_elements; ++e)
            {
              const double *values = rows(name, solid.block_cells[body][e]);
              for (unsigned int i = 0; i < n; ++i)
                packed[packed_place(e, blocks.width, n) + i * blocks.width] = values[i];
            }
        });
        mark_flowed(blocks);
      }
  }
} // namespace wheelrail
