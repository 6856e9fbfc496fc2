#pragma once

#include <experimental/simd>

#include <boost/align/aligned_allocator.hpp>

#include <vector>

namespace wheelrail
{
  /// W numbers worked on at once. The packaged deal.II is built without SIMD, so the kernels use the
  /// compiler's own vector types.
  template <int W>
  using Simd = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, W>>;

  /// Widest width of the machine that the program was built on.
  constexpr int native_width = static_cast<int>(std::experimental::native_simd<double>::size());

  // GCC 12 takes the undefined operand inside its own AVX-512 square root for a mistake (bug 105593).
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
  template <typename T>
  inline T
  square_root(const T &x)
  {
    return std::experimental::sqrt(x);
  }
#pragma GCC diagnostic pop

  /// On cache-line borders, so that packed data can be loaded with aligned instructions.
  template <typename T>
  using AlignedVector = std::vector<T, boost::alignment::aligned_allocator<T, 64>>;
} // namespace wheelrail
