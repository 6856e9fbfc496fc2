#include <wheelrail/solid/full_element.h>
#include <wheelrail/solid/point_state.h>
#include <wheelrail/solid/reduced_kernel.h>

#include <array>
#include <vector>

// Forces, gradients and Cauchy stresses of both elements: F = 1 + H, E = (H + H' + H'H)/2, sigma = F S F'/det
// F (doc/theory/element.md).

namespace wheelrail
{
  void
  subtract_internal_force(ElementBlocks       &blocks,
                          const double        *displacement,
                          double              *force,
                          const BulkViscosity &viscosity,
                          const bool           with_energy,
                          ElementEnergy       &energy)
  {
    if (blocks.form == ElementForm::full)
      // f_a -= dW/du_a [N]
      subtract_full_force(blocks, displacement, force, viscosity, with_energy, energy);
    else
      subtract_reduced_force(blocks, displacement, force, viscosity, with_energy, energy);
  }


  void
  subtract_internal_force(PerBody<ElementBlocks> &blocks,
                          const double           *displacement,
                          double                 *force,
                          const BulkViscosity    &viscosity,
                          const bool              with_energy,
                          ElementEnergy          &energy)
  {
    // each body has its own law and element form; both add to the same nodal forces
    for (const Body body : both_bodies)
      subtract_internal_force(blocks[body], displacement, force, viscosity, with_energy, energy);
  }


  std::array<double, 9>
  element_gradient(const ElementBlocks &blocks, const std::size_t element, const double *displacement)
  {
    if (blocks.form == ElementForm::full)
      return full_mean_gradient(blocks, element, displacement);
    // the 24 first rows are B_a
    const std::size_t W = blocks.width, batch = element / W, lane = element % W;
    const double     *B = blocks.data.data() + batch * blocks.rows * W + lane;
    // H_ij = sum of u_ai B_aj, uniform over the element (Flanagan and Belytschko 1981; doc/theory/element.md)
    std::array<double, 9> H{};
    for (int a = 0; a < 8; ++a)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          H[3 * i + j] += displacement[4 * blocks.nodes[(batch * 8 + a) * W + lane] + i] * B[(3 * a + j) * W];
    return H;
  }


  std::vector<std::array<double, 6>>
  element_stress(const ElementBlocks &blocks, const double *displacement)
  {
    // Cauchy stresses of the elements at the centres [Pa], tension positive
    std::vector<std::array<double, 6>> result(blocks.n_elements);
    // order xx, yy, zz, yz, xz, xy; E_xy is the component of the tensor, half the change of the angle
    constexpr int row[6] = {0, 1, 2, 1, 0, 0}, column[6] = {0, 1, 2, 2, 2, 1};
    for (std::size_t e = 0; e < blocks.n_elements; ++e)
      {
        if (blocks.form == ElementForm::full)
          {
            result[e] = full_mean_stress(blocks, e, displacement);
            continue;
          }
        // F = 1 + H is uniform over the element: one stress
        const auto Hij = element_gradient(blocks, e, displacement);
        // Green and Lagrange's strain, E = (H + H' + H' H)/2
        Simd<1> E[6], S[6];
        for (int k = 0; k < 6; ++k)
          {
            const int i = row[k], j = column[k];
            double    value = Hij[3 * i + j] + Hij[3 * j + i];
            // H' H: without it a rotation would strain
            for (int l = 0; l < 3; ++l)
              value += Hij[3 * l + i] * Hij[3 * l + j];
            E[k] = 0.5 * value;
          }
        // S of the law with the history of the point; then sigma = F S F'/det F
        point_stress(blocks, e, 0, E, S);
        // of the one-point field: the stabilisation's stresses are not shown (doc/theory/element.md, Stresses
        // at nodes)
        result[e] = cauchy_stress(Hij, S);
      }
    return result;
  }
} // namespace wheelrail
