#include <wheelrail/solid/point_state.h>
#include <wheelrail/solid/solid.h>

#include <algorithm>
#include <array>
#include <vector>

// Nodal means with volumes as weights: H of the rolling velocities v = V e_z + (1 + H)(omega x r)
// (doc/theory/rolling.md, Rolling velocities), and plastic strains.

namespace wheelrail
{
  namespace
  {
    /// Volume-weighted nodal means of element values, `n` numbers an element.
    template <std::size_t n>
    std::vector<double>
    nodal_means(const Solid &solid, const PerBody<std::vector<std::array<double, n>>> &values)
    {
      const std::size_t     n_nodes = solid.mesh.n_nodes();
      std::vector<double>   result(n * n_nodes);
      AlignedVector<double> volume(4 * n_nodes, 0.), part(4 * n_nodes);
      const auto            for_each = [&](const auto &work) {
        for (const Body body : both_bodies)
          {
            const ElementBlocks &blocks = solid.blocks[body];
            for (std::size_t e = 0; e < blocks.n_elements; ++e)
              {
                for (const unsigned int node : solid.mesh.cells[solid.block_cells[body][e]])
                  work(body, e, node, blocks.volume[e]);
              }
          }
      };
      for_each([&](Body, std::size_t, unsigned int node, double V) { volume[4 * node] += V; });
      sum_over_ranks(solid.mesh, volume.data());
      for (std::size_t first = 0; first < n; first += 3)
        {
          std::fill(part.begin(), part.end(), 0.);
          for_each([&](Body body, std::size_t e, unsigned int node, double V) {
            for (std::size_t k = 0; k < std::min<std::size_t>(3, n - first); ++k)
              part[4 * node + k] += V * values[body][e][first + k];
          });
          sum_over_ranks(solid.mesh, part.data());
          for (std::size_t node = 0; node < n_nodes; ++node)
            for (std::size_t k = 0; k < std::min<std::size_t>(3, n - first); ++k)
              // mean of V x value over the elements around a node
              result[n * node + first + k] = volume[4 * node] > 0 ? part[4 * node + k] / volume[4 * node] : 0;
        }
      return result;
    }
  } // namespace


  std::vector<double>
  nodal_gradient(const Solid &solid, const double *field)
  {
    PerBody<std::vector<std::array<double, 9>>> gradient;
    for (const Body body : both_bodies)
      {
        const ElementBlocks &blocks = solid.blocks[body];
        for (std::size_t e = 0; e < blocks.n_elements; ++e)
          // H_ij = du_i/dX_j, uniform over the element
          gradient[body].push_back(element_gradient(blocks, e, field));
      }
    return nodal_means<9>(solid, gradient);
  }


  std::vector<double>
  nodal_plastic_strain(const Solid &solid)
  {
    PerBody<std::vector<std::array<double, 1>>> strain;
    for (const Body body : both_bodies)
      for (const double value : element_plastic_strain(solid.blocks[body]))
        strain[body].push_back({value});
    return nodal_means<1>(solid, strain);
  }
} // namespace wheelrail
