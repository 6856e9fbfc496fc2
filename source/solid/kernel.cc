#include <wheelrail/solid/kernel.h>
#include <wheelrail/solid/reduced_kernel.h>

namespace wheelrail
{
  namespace
  {
    /// Cauchy's stress F S F^T / det F of a displacement gradient H (row-major); stresses as xx, yy, zz,
    /// yz, xz, xy.
    std::array<double, 6>
    cauchy_stress(const std::array<double, 9> &H, const Simd<1> (&S)[6])
    {
      const double s[3][3] = {
        {S[0][0], S[5][0], S[4][0]}, {S[5][0], S[1][0], S[3][0]}, {S[4][0], S[3][0], S[2][0]}};
      const double f[3][3] = {{H[0] + 1, H[1], H[2]}, {H[3], H[4] + 1, H[5]}, {H[6], H[7], H[8] + 1}};
      const double J       = f[0][0] * (f[1][1] * f[2][2] - f[1][2] * f[2][1]) -
                       f[0][1] * (f[1][0] * f[2][2] - f[1][2] * f[2][0]) +
                       f[0][2] * (f[1][0] * f[2][1] - f[1][1] * f[2][0]);
      constexpr int         row[6] = {0, 1, 2, 1, 0, 0}, column[6] = {0, 1, 2, 2, 2, 1};
      std::array<double, 6> result{};
      for (int k = 0; k < 6; ++k)
        {
          for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
              result[k] += f[row[k]][i] * s[i][j] * f[column[k]][j];
          result[k] /= J;
        }
      return result;
    }
  } // namespace


  void
  subtract_internal_force(ElementBlocks       &blocks,
                          const double        *displacement,
                          double              *force,
                          const BulkViscosity &viscosity,
                          const bool           with_energy,
                          ElementEnergy       &energy)
  {
    subtract_reduced_force(blocks, displacement, force, viscosity, with_energy, energy);
  }


  std::array<double, 9>
  element_gradient(const ElementBlocks &blocks, const std::size_t element, const double *displacement)
  {
    const std::size_t     W = blocks.width, batch = element / W, lane = element % W;
    const double         *B = blocks.data.data() + batch * blocks.rows * W + lane;
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
    std::vector<std::array<double, 6>> result(blocks.n_elements);
    const BilinearLaw                  law(blocks.material, blocks.plasticity);
    constexpr int                      row[6] = {0, 1, 2, 1, 0, 0}, column[6] = {0, 1, 2, 2, 2, 1};
    for (std::size_t e = 0; e < blocks.n_elements; ++e)
      {
        const auto Hij = element_gradient(blocks, e, displacement);
        Simd<1>    E[6], S[6];
        for (int k = 0; k < 6; ++k)
          {
            const int i = row[k], j = column[k];
            double    value = Hij[3 * i + j] + Hij[3 * j + i];
            for (int l = 0; l < 3; ++l)
              value += Hij[3 * l + i] * Hij[3 * l + j];
            E[k] = 0.5 * value;
          }
        PlasticHistory<1> history;
        const std::size_t W = blocks.width, batch = e / W, lane = e % W;
        if (blocks.plastic())
          for (int k = 0; k < 5; ++k)
            history.strain[k] = blocks.history[(batch * blocks.history_rows() + k) * W + lane];
        plastic_stress<1>(law, E, history, S);
        result[e] = cauchy_stress(Hij, S);
      }
    return result;
  }
} // namespace wheelrail
