#include <wheelrail/solid/point_state.h>
#include <wheelrail/solid/solid.h>

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
      constexpr std::size_t width = n + 1; // sums of V x value over the elements around a node, and of V
      std::vector<double>   sums(width * solid.mesh.n_nodes()), means;
      for (const Body body : both_bodies)
        for (std::size_t e = 0; e < values[body].size(); ++e)
          // value(node) = sum of V x value/sum of V
          for (const unsigned int node : solid.mesh.cells[solid.block_cells[body][e]])
            {
              // reference volumes [m3]; at hanging nodes only the small cells around count
              const double V = solid.blocks[body].volume[e];
              for (std::size_t k = 0; k < n; ++k)
                sums[width * node + k] += V * values[body][e][k];
              sums[width * node + n] += V;
            }
      // elements of all ranks around a node
      sum_over_ranks(solid.mesh, sums.data(), width);
      for (std::size_t node = 0; node < solid.mesh.n_nodes(); ++node)
        for (std::size_t k = 0; k < n; ++k)
          {
            const double V = sums[width * node + n];
            // single-valued: what is evaluated with it on both sides of a face agrees
            means.push_back(V > 0 ? sums[width * node + k] / V : 0);
          }
      return means;
    }
  } // namespace


  std::vector<double>
  nodal_gradient(const Solid &solid, const double *field)
  {
    // `field` is any nodal field of four numbers a node: displacements give H, velocities dF/dt
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
    // accumulated plastic strain a, of an element's points the largest
    PerBody<std::vector<std::array<double, 1>>> strain;
    for (const Body body : both_bodies)
      for (const double value : element_plastic_strain(solid.blocks[body]))
        strain[body].push_back({value});
    return nodal_means<1>(solid, strain);
  }
} // namespace wheelrail
