#include <wheelrail/halfspace/corner_sweep.h>
#include <wheelrail/halfspace/element_stress.h>
#include <wheelrail/halfspace/subsurface_layers.h>


// At one depth the stress under each element is a convolution of the tractions with the stress of one
// element: one FFT for each component and load in place of a sum over all pairs.

namespace wheelrail
{
  namespace
  {
    constexpr std::array<double HalfspaceStress::*, 6> components = {&HalfspaceStress::xx,
                                                                     &HalfspaceStress::yy,
                                                                     &HalfspaceStress::nn,
                                                                     &HalfspaceStress::xy,
                                                                     &HalfspaceStress::xn,
                                                                     &HalfspaceStress::yn};

    /// Under a unit of one load, by the distance from loaded to observed element, as
    /// InfluenceProducts::kernel() takes it.
    struct UnitStresses
    {
      std::array<std::vector<double>, components.size()> of;
    };

    /// Whether a component under a load (along x, along y, n) changes its sign with that of x, of y.
    bool
    is_odd(const std::size_t component, const int load, const int axis)
    {
      constexpr int indices[2][components.size()] = {{0, 0, 0, 1, 1, 0}, {0, 0, 0, 1, 0, 1}}; // odd ones
      // mirrored at x = 0, a vector along x and each index x of a stress change their sign
      return (indices[axis][component] + (load == axis ? 1 : 0)) % 2 == 1;
    }

    /// For tractions along x and y and pressure. Those of a quarter of the distances give those of all.
    std::array<UnitStresses, 3>
    unit_stresses(const HalfspaceGrid     &grid,
                  const InfluenceProducts &products,
                  const double             poisson_ratio,
                  const double             depth)
    {
      const int                   nx = products.columns(), ny = products.rows();
      std::array<UnitStresses, 3> unit;
      for (UnitStresses &stresses : unit)
        for (auto &field : stresses.of)
          field.resize(std::size_t(nx) * ny);
      sweep_corners(
        grid,
        // a quarter of the distances; mirror images give the others
        {0, nx / 2 + 1, 0, ny / 2 + 1},
        0,
        // a corner belongs to four elements: its derivatives are computed once
        [&](const double x, const double y) { return corner_derivatives(x, y, depth); },
        [&](const int i, const int j, const auto &ff, const auto &fn, const auto &nf, const auto &nn) {
          const PotentialDerivatives d = rectangle_derivatives(ff, fn, nf, nn);
          for (int load = 0; load < 3; ++load)
            {
              HalfspaceStress stress;
              // stress under a traction of 1 Pa along x, along y, a pressure of 1 Pa
              add_stress(d, poisson_ratio, depth, load == 0, load == 1, load == 2, stress);
              for (std::size_t c = 0; c < components.size(); ++c)
                {
                  const double value  = stress.*components[c];
                  const int    sign_x = is_odd(c, load, 0) ? -1 : 1, sign_y = is_odd(c, load, 1) ? -1 : 1;
                  const auto   set = [&](const int column, const int row, const double to) {
                    // distances nx/2 lie beyond the table, which ends at nx/2 - 1
                    if (column < nx && row < ny)
                      // the distance 0 stands in the middle, at (nx/2, ny/2)
                      unit[load].of[c][column + std::size_t(nx) * row] = to;
                  };
                  set(nx / 2 + i, ny / 2 + j, value);
                  if (i > 0)
                    set(nx / 2 - i, ny / 2 + j, sign_x * value);
                  if (j > 0)
                    set(nx / 2 + i, ny / 2 - j, sign_y * value);
                  if (i > 0 && j > 0)
                    set(nx / 2 - i, ny / 2 - j, sign_x * sign_y * value);
                }
            }
        });
      return unit;
    }

    /// `sign`: of the tractions against those on body 1; depth runs against n in body 2.
    std::vector<HalfspaceStress>
    in_body(const std::array<std::vector<HalfspaceStress>, 2> &shares, const double sign)
    {
      std::vector<HalfspaceStress> stresses(shares[0].size());
      // body 2 has -t and depth against n: in its own frame (x, y, -n) a pressure is a pressure
      for (std::size_t e = 0; e < stresses.size(); ++e)
        {
          for (const auto component : components)
            // sigma = -+ share of tractions + share of pressure; then xn, yn change their sign with n in body
            // 2
            stresses[e].*component = sign * shares[0][e].*component + shares[1][e].*component;
          stresses[e].xn *= sign;
          stresses[e].yn *= sign;
        }
      return stresses;
    }
  } // namespace


  SubsurfaceLayers::SubsurfaceLayers(const HalfspaceSolution &solution,
                                     const HalfspaceBody     &body1,
                                     const HalfspaceBody     &body2)
    : grid_(solution.grid)
    , poisson_ratio1_(body1.poisson_ratio)
    , poisson_ratio2_(body2.poisson_ratio)
    , products_(solution.grid)
  {
    // loads are transformed once for all layers
    products_.forward(solution.traction_x, loads_[0]);
    products_.forward(solution.traction_y, loads_[1]);
    products_.forward(solution.pressure, loads_[2]);
  }


  std::array<std::vector<HalfspaceStress>, 2>
  SubsurfaceLayers::shares(const double poisson_ratio, const double depth)
  {
    // unit stresses depend on depth and Poisson's ratio: a table for each layer, then FFTs of 18 pairs
    const auto                                  unit = unit_stresses(grid_, products_, poisson_ratio, depth);
    std::array<std::vector<HalfspaceStress>, 2> shares;
    for (auto &share : shares)
      share.resize(grid_.size());
    // two products a component: tractions, pressure
    std::vector<double>         field;
    InfluenceProducts::Spectrum sum(products_.spectrum_size());
    for (std::size_t c = 0; c < components.size(); ++c)
      {
        const auto x = products_.kernel(unit[0].of[c]), y = products_.kernel(unit[1].of[c]),
                   n = products_.kernel(unit[2].of[c]);
        for (std::size_t m = 0; m < sum.size(); ++m)
          // sigma_c(I) = sum over J of S_cx(I - J) t_x(J) + S_cy t_y + S_cn p; tractions and pressure apart,
          // since body 2 has the former with the other sign
          sum[m] = times(x[m], loads_[0][m]) + times(y[m], loads_[1][m]);
        products_.backward(sum, field);
        for (std::size_t e = 0; e < field.size(); ++e)
          shares[0][e].*components[c] = field[e];
        for (std::size_t m = 0; m < sum.size(); ++m)
          sum[m] = times(n[m], loads_[2][m]);
        products_.backward(sum, field);
        for (std::size_t e = 0; e < field.size(); ++e)
          shares[1][e].*components[c] = field[e];
      }
    return shares;
  }


  LayerStresses
  SubsurfaceLayers::at(const double depth)
  {
    check_depth(depth);
    // like bodies have the same shares, body 2 with the other sign of tractions
    const auto first = shares(poisson_ratio1_, depth);
    return {in_body(first, 1),
            in_body(poisson_ratio2_ == poisson_ratio1_ ? first : shares(poisson_ratio2_, depth), -1)};
  }
} // namespace wheelrail
