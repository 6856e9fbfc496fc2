#include <wheelrail/solid/histories.h>

#include <algorithm>

// What elements remember from step to step (plastic strains, back stresses, plastic amplitudes, dilatation of
// the bulk viscosity; doc/theory/element.md, doc/manual/material.md), for saved states and changes of the
// mesh.

namespace wheelrail
{
  namespace
  {
    /// Place of element e's first number in an array of visit_histories().
    std::size_t
    packed_place(const std::size_t e, const unsigned int width, const unsigned int components)
    {
      // Lanes of a batch are fastest: number i of element e stands at (e / W) W n + i W + e % W, so that a
      // kernel loads one number of W elements at once. Outside the n numbers of an element follow one
      // another.
      return e / width * width * components + e % width;
    }
  } // namespace


  std::map<std::string, NumberedValues>
  cell_histories(const Solid &solid)
  {
    std::map<std::string, NumberedValues> all;
    for (const Body body : both_bodies)
      visit_histories(solid.blocks[body], [&](const char *name, const unsigned int n, const auto &) {
        // 1. The longest row of both bodies, which may have different forms or laws
        all[name].components = std::max(all[name].components, n);
      });
    for (auto &entry : all)
      entry.second.values.resize(entry.second.components * solid.mesh.cells.size());
    for (const Body body : both_bodies)
      {
        // 2. Numbers of each element, in the order of the rank's cells
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
        // which batches have flowed follows from the histories: any number that is not zero
        mark_flowed(blocks);
      }
  }
} // namespace wheelrail
