#include <wheelrail/halfspace/subsurface_layers.h>
#include <wheelrail/solid/point_state.h>
#include <wheelrail/wheel/halfspace_stresses.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// xx, yy, zz, yz, xz, xy in the axes of the track. The contact frame of the half-spaces with the rail as
    /// body 1: x along Z, y along s, which is inclined by `angle` against X, n into the rail.
    std::array<double, 6>
    in_track_axes(const HalfspaceStress &s, const double angle)
    {
      const double local[3][3] = {{s.xx, s.xy, s.xn}, {s.xy, s.yy, s.yn}, {s.xn, s.yn, s.nn}};
      const double c = std::cos(angle), d = std::sin(angle);
      const double axis[3][3] = {{0, 0, 1}, {c, d, 0}, {d, -c, 0}};
      const auto   component  = [&](const int i, const int j) {
        double sum = 0;
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b)
            sum += local[a][b] * axis[a][i] * axis[b][j];
        return sum;
      };
      return {
        component(0, 0), component(1, 1), component(2, 2), component(1, 2), component(0, 2), component(0, 1)};
    }

    /// Below a patch with the shorter extent `extent` [m]. The largest stress lies 0.24 (of a circle) to 0.39
    /// (of a strip) of it deep (Johnson 1985, 3.4 and 4.2).
    std::vector<double>
    layer_depths(const HalfspaceGrid &grid, const double extent)
    {
      // finer layers would cost time and show nothing: below the surface the stresses are smooth, and the
      // deeper the smoother. What falls with the square of the depth is off by 0.2 % midway between layers
      constexpr double    growth = 0.05;
      const double        least  = std::max(std::min(0.2e-3, extent / 16), 0.5 * std::min(grid.dx, grid.dy));
      const double        last   = std::max(depth_of_slices, 0.75 * extent);
      std::vector<double> depths{0};
      while (depths.back() < last * (1 - 1e-9))
        depths.push_back(std::min(last, depths.back() + std::max(least, growth * depths.back())));
      return depths;
    }

    /// A row of elements, along x at column `fixed` of y or the reverse.
    struct CutRow
    {
      std::string name;
      bool        along;
      int         fixed;
    };

    std::vector<CutRow>
    rows_of(const HalfspaceSolution &solution)
    {
      const HalfspaceGrid &g    = solution.grid;
      const auto           peak = std::max_element(solution.pressure.begin(), solution.pressure.end());
      const int            e    = int(peak - solution.pressure.begin());
      const int            i0   = std::clamp(int(std::lround(-g.x0 / g.dx)), 0, g.mx - 1),
                j0              = std::clamp(int(std::lround(-g.y0 / g.dy)), 0, g.my - 1);
      return {{"AA", true, j0}, {"BB", false, i0}, {"AA_peak", true, e / g.mx}, {"BB_peak", false, e % g.mx}};
    }

    Slice
    empty_slice(const CutRow              &row,
                const HalfspaceGrid       &grid,
                const std::vector<double> &depths,
                const Body                 body)
    {
      Slice slice;
      slice.name   = row.name + (body == Body::rail ? "_rail" : "_wheel");
      slice.offset = row.along ? grid.y(row.fixed) : grid.x(row.fixed);
      slice.depth  = depths;
      for (int k = 0; k < (row.along ? grid.mx : grid.my); ++k)
        slice.position.push_back(row.along ? grid.x(k) : grid.y(k));
      slice.values.assign(7, std::vector<double>(slice.position.size() * depths.size()));
      return slice;
    }

    /// Writes one layer into a slice.
    void
    fill_slice(Slice                              &slice,
               const CutRow                       &row,
               const HalfspaceGrid                &grid,
               const std::vector<HalfspaceStress> &layer,
               const std::size_t                   layer_number,
               const double                        angle)
    {
      for (std::size_t k = 0; k < slice.position.size(); ++k)
        {
          const std::size_t element =
            row.along ? k + std::size_t(grid.mx) * row.fixed : row.fixed + grid.mx * k;
          const std::array<double, 6> stress   = in_track_axes(layer[element], angle);
          const std::size_t           place    = k * slice.depth.size() + layer_number;
          slice.values[slice_von_mises][place] = von_mises(stress.data());
          for (std::size_t c = 0; c < stress.size(); ++c)
            slice.values[slice_stress_xx + c][place] = stress[c];
        }
    }

    std::vector<double>
    von_mises_of(const std::vector<HalfspaceStress> &layer)
    {
      std::vector<double> values;
      for (const HalfspaceStress &s : layer)
        values.push_back(s.von_mises());
      return values;
    }

    /// Takes the maxima over depth that lie in the middle one of three layers, the last one of which is
    /// `last`, of the parabola through their values.
    void
    take_maxima(HalfspaceStresses                        &stresses,
                const std::array<std::vector<double>, 3> &values,
                const std::vector<double>                &depths,
                const std::size_t                         last,
                const Body                                body)
    {
      const double depth = depths[last - 1], up = depth - depths[last - 2], down = depths[last] - depth;
      for (std::size_t e = 0; e < values[1].size(); ++e)
        {
          const double above = values[0][e], here = values[1][e], below = values[2][e];
          if (!(here > above && here >= below))
            continue;
          const double before = (here - above) / up, behind = (below - here) / down;
          const double slope = (before * down + behind * up) / (up + down),
                       bend  = 2 * (behind - before) / (up + down);
          const double top   = here - 0.5 * slope * slope / bend;
          if (top > stresses.subsurface_von_mises)
            {
              stresses.subsurface_von_mises = top;
              stresses.subsurface_depth     = depth - slope / bend;
              stresses.subsurface_body      = body;
            }
        }
    }
  } // namespace


  HalfspaceStresses
  halfspace_stresses(const WheelRailSolution &result)
  {
    const HalfspaceSolution  &solution = result.solution;
    const std::vector<double> depths =
      layer_depths(solution.grid, std::min(result.measures.width, result.measures.length));
    const std::vector<CutRow> rows = rows_of(solution);
    HalfspaceStresses         stresses;
    SubsurfaceLayers          layers(solution, result.problem.body1, result.problem.body2);
    constexpr Body            bodies[] = {Body::rail, Body::wheel};
    for (const Body body : bodies)
      for (const CutRow &row : rows)
        stresses.slices.push_back(empty_slice(row, solution.grid, depths, body));
    std::array<std::array<std::vector<double>, 3>, 2> values; // von Mises stresses of the last three layers
    for (std::size_t k = 0; k < depths.size(); ++k)
      {
        const LayerStresses layer = layers.at(depths[k]);
        for (const Body body : bodies)
          {
            const auto &here  = body == Body::rail ? layer.body1 : layer.body2;
            const auto  first = body == Body::rail ? 0 : rows.size();
            auto       &of    = values[body == Body::rail ? 0 : 1];
            for (std::size_t r = 0; r < rows.size(); ++r)
              fill_slice(stresses.slices[first + r], rows[r], solution.grid, here, k, result.angle);
            of = {std::move(of[1]), std::move(of[2]), von_mises_of(here)};
            if (k == 0)
              stresses.surface_von_mises =
                std::max(stresses.surface_von_mises, *std::max_element(of[2].begin(), of[2].end()));
            if (k > 1)
              take_maxima(stresses, of, depths, k, body);
          }
      }
    for (const WheelRailSolution &other : result.others)
      {
        const HalfspaceStresses there = halfspace_stresses(other);
        stresses.surface_von_mises    = std::max(stresses.surface_von_mises, there.surface_von_mises);
        if (there.subsurface_von_mises > stresses.subsurface_von_mises)
          {
            stresses.subsurface_von_mises = there.subsurface_von_mises;
            stresses.subsurface_depth     = there.subsurface_depth;
            stresses.subsurface_body      = there.subsurface_body;
          }
      }
    return stresses;
  }
} // namespace wheelrail
