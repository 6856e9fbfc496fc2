#include <wheelrail/solid/point_state.h>

#include <algorithm>

// Stress and plastic strain at a point of an element, outside of the kernels, by the same laws
// (doc/manual/material.md, Theory).

namespace wheelrail
{
  namespace
  {
    /// What one point remembers, out of the lanes of its batch.
    template <typename Law>
    typename Law::template History<Simd<1>>
    point_history(const Law &law, const ElementBlocks &blocks, const std::size_t element, const int point)
    {
      typename Law::template History<Simd<1>> history(law);
      if constexpr (has_history<Law>)
        {
          const std::size_t   W = blocks.width, batch = element / W, lane = element % W;
          const std::size_t   first = batch * blocks.history_rows() + law.history_rows() * point;
          std::vector<double> rows(law.history_rows());
          for (int row = 0; row < law.history_rows(); ++row)
            rows[row] = blocks.history[(first + row) * W + lane];
          history.load(rows.data());
        }
      return history;
    }
  } // namespace


  void
  point_stress(const ElementBlocks &blocks,
               const std::size_t    element,
               const int            point,
               const Simd<1> (&E)[6],
               Simd<1> (&S)[6])
  {
    const auto of_law = [&](const auto &law) {
      // S = K tr(E) 1 + 2 mu (dev E - E_p) (doc/manual/material.md, Theory)
      law.stress(E, point_history(law, blocks, element, point), S);
    };
    std::visit(of_law, blocks.law);
  }


  std::vector<double>
  element_plastic_strain(const ElementBlocks &blocks)
  {
    std::vector<double> strain(blocks.n_elements, 0.);
    const auto          of_law = [&](const auto &law) {
      using Law = std::decay_t<decltype(law)>;
      if constexpr (has_history<Law>)
        for (std::size_t e = 0; e < blocks.n_elements; ++e)
          for (int point = 0; point < blocks.n_points(); ++point)
            {
              const auto history = point_history(law, blocks, e, point);
              strain[e]          = std::max<double>(strain[e], history.accumulated[0]);
            }
    };
    std::visit(of_law, blocks.law);
    return strain;
  }
} // namespace wheelrail
