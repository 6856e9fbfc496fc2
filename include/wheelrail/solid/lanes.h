#pragma once

#include <wheelrail/base/simd.h>

#include <cstdint>

// Moving nodal values between the node arrays (4 numbers a node, the last one unused) and the lanes
// of the kernels.

namespace wheelrail
{
  typedef double Four __attribute__((vector_size(32), aligned(32)));

  /// Three vectors of W lanes.
  template <int W>
  using V3 = Simd<W>[3];

  /// Loads the node vectors of four elements and turns them into one vector a component.
  inline void
  gather_four(const double *array, const std::uint32_t *node, V3<4> &value)
  {
    const Four r0           = *reinterpret_cast<const Four *>(array + 4 * node[0]);
    const Four r1           = *reinterpret_cast<const Four *>(array + 4 * node[1]);
    const Four r2           = *reinterpret_cast<const Four *>(array + 4 * node[2]);
    const Four r3           = *reinterpret_cast<const Four *>(array + 4 * node[3]);
    const Four t0           = __builtin_shufflevector(r0, r1, 0, 4, 2, 6);
    const Four t1           = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
    const Four t2           = __builtin_shufflevector(r2, r3, 0, 4, 2, 6);
    const Four t3           = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
    const Four component[3] = {__builtin_shufflevector(t0, t2, 0, 1, 4, 5),
                               __builtin_shufflevector(t1, t3, 0, 1, 4, 5),
                               __builtin_shufflevector(t0, t2, 2, 3, 6, 7)};
    for (int i = 0; i < 3; ++i)
      value[i].copy_from(reinterpret_cast<const double *>(&component[i]), std::experimental::vector_aligned);
  }

  /// Loads the node vectors of W elements and turns them into one vector a component. Eight lanes are joined
  /// in registers: a core cannot hand on two stores of halves to the load of the whole, and waits.
  template <int W>
  inline void
  gather(const double *array, const std::uint32_t *node, V3<W> &value)
  {
    if constexpr (W == 4)
      gather_four(array, node, value);
    else if constexpr (W == 8)
      {
        V3<4> low, high;
        gather_four(array, node, low);
        gather_four(array, node + 4, high);
        for (int i = 0; i < 3; ++i)
          value[i] = std::experimental::concat(low[i], high[i]);
      }
    else
      for (int i = 0; i < 3; ++i)
        value[i] = Simd<W>([&](const auto l) { return array[4 * node[l] + i]; });
  }

  /// Subtracts the lanes from the node vectors, one element after the other since neighbours in a
  /// batch share nodes.
  template <int W>
  inline void
  scatter_subtract(double *array, const std::uint32_t *node, const V3<W> &value)
  {
    alignas(64) double buffer[3][W];
    for (int i = 0; i < 3; ++i)
      value[i].copy_to(buffer[i], std::experimental::vector_aligned);
    if constexpr (W >= 4)
      for (int l = 0; l < W; l += 4)
        {
          const Four x    = *reinterpret_cast<const Four *>(&buffer[0][l]);
          const Four y    = *reinterpret_cast<const Four *>(&buffer[1][l]);
          const Four z    = *reinterpret_cast<const Four *>(&buffer[2][l]);
          const Four zero = {0, 0, 0, 0};
          const Four t0   = __builtin_shufflevector(x, y, 0, 4, 2, 6);
          const Four t1   = __builtin_shufflevector(x, y, 1, 5, 3, 7);
          const Four t2   = __builtin_shufflevector(z, zero, 0, 4, 2, 6);
          const Four t3   = __builtin_shufflevector(z, zero, 1, 5, 3, 7);
          *reinterpret_cast<Four *>(array + 4 * node[l]) -= __builtin_shufflevector(t0, t2, 0, 1, 4, 5);
          *reinterpret_cast<Four *>(array + 4 * node[l + 1]) -= __builtin_shufflevector(t1, t3, 0, 1, 4, 5);
          *reinterpret_cast<Four *>(array + 4 * node[l + 2]) -= __builtin_shufflevector(t0, t2, 2, 3, 6, 7);
          *reinterpret_cast<Four *>(array + 4 * node[l + 3]) -= __builtin_shufflevector(t1, t3, 2, 3, 6, 7);
        }
    else
      for (int l = 0; l < W; ++l)
        for (int i = 0; i < 3; ++i)
          array[4 * node[l] + i] -= buffer[i][l];
  }

} // namespace wheelrail
