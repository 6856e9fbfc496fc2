#include <wheelrail/contact/surface_filter.h>

#include <algorithm>

// S = I - w/2 D'D in each direction, D the differences of neighbours (doc/theory/contact.md, Surface filter).
// On the path in and out a wave loses w (k h)^2, which is what the lattice has too much. S is symmetric with
// rows that sum to 1: forces and moments are kept, and power is the same on both sides of it.

namespace wheelrail
{
  namespace
  {
    /// Adds half the weight of each component times the differences to the lines before and after.
    void
    blend(double           *values,
          const double     *before,
          const double     *after,
          const std::size_t n,
          const Vector3    &weight)
    {
      for (std::size_t k = 0; k < n; k += 3)
        for (int c = 0; c < 3; ++c)
          // u + w/2 (u_before - 2 u + u_after) = (I - w/2 D'D) u: a wave loses w (1 - cos k h), w (k h)^2/2
          // for long ones; applied twice w (k h)^2, the excess of the lattice
          values[k + c] += 0.5 * weight[c] * (before[k + c] - 2 * values[k + c] + after[k + c]);
    }

    bool
    is_zero(const Vector3 &weight)
    {
      return weight[0] == 0 && weight[1] == 0 && weight[2] == 0;
    }

    /// Weights of the neighbour before, the node, and the neighbour after, at most at one border.
    std::array<double, 3>
    line_stencil(const double weight, const bool has_before, const bool has_after)
    {
      // at a border the neighbour beyond is the node itself: rows sum to 1, and S stays symmetric
      const double before = has_before ? 0.5 * weight : 0., after = has_after ? 0.5 * weight : 0.;
      return {before, 1 - before - after, after};
    }
  } // namespace


  FilterWeights
  normal_weights(const SurfaceFilter &filter)
  {
    const double w = filter.normal;
    // positions, normal velocities and pressures: all components, both directions
    return {{w, w, w}, {w, w, w}};
  }


  FilterWeights
  shear_weights(const SurfaceFilter &filter)
  {
    const double w = filter.shear;
    // sliding and shear, each across its own direction: X, Y along the track, Z across it. A wave along its
    // own traction is right to -0.008 (k h)^2 without a filter.
    return {{w, w, 0}, {0, 0, w}};
  }


  void
  filter_surface(const Lattice        &lattice,
                 const int             first,
                 const int             last,
                 const FilterWeights  &weights,
                 std::vector<Vector3> &field)
  {
    const std::size_t   n = 3 * std::size_t(lattice.n_lateral);
    std::vector<double> old(n + 6), before(n), here(n);
    if (!is_zero(weights.across))
      for (int i = first; i < last; ++i)
        {
          // the line with its end values doubled, so that nothing flows over the border
          double *line = field[lattice.index(i, 0)].data();
          std::copy(line, line + n, old.begin() + 3);
          std::copy(line, line + 3, old.begin());
          std::copy(line + n - 3, line + n, old.end() - 3);
          // 1. across the track
          blend(line, old.data(), old.data() + 6, n, weights.across);
        }
    if (!is_zero(weights.along))
      // `before` holds the line behind as it was, since the line itself has been overwritten
      for (int i = first; i < last; ++i)
        {
          double *line = field[lattice.index(i, 0)].data();
          std::copy(line, line + n, here.begin());
          const double *after = i + 1 < last ? field[lattice.index(i + 1, 0)].data() : here.data();
          // 2. along it, on the result: S_along S_across, which commute on a lattice
          blend(line, i == first ? here.data() : before.data(), after, n, weights.along);
          before.swap(here);
        }
  }


  std::array<std::array<double, 3>, 3>
  filter_stencil(const Lattice &lattice,
                 const int      first,
                 const int      last,
                 const double   weight,
                 const int      i,
                 const int      j)
  {
    const auto along  = line_stencil(weight, i > first, i + 1 < last);
    const auto across = line_stencil(weight, j > 0, j + 1 < static_cast<int>(lattice.n_lateral));
    std::array<std::array<double, 3>, 3> stencil;
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l)
        // product of both directions, since filter_surface() does one after the other
        stencil[k][l] = along[k] * across[l];
    return stencil;
  }
} // namespace wheelrail
