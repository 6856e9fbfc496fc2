#include <wheelrail/base/errors.h>
#include <wheelrail/sampling/patch_edge.h>
#include <wheelrail/sampling/patch_measures.h>
#include <wheelrail/sampling/slip_edge.h>

#include <boost/math/interpolators/makima.hpp>
#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    void
    check_lengths(const PatchFields &patch)
    {
      const std::size_t n = std::size_t(patch.n_along) * patch.n_lateral;
      for (const auto *field : {&patch.along,
                                &patch.lateral,
                                &patch.gap,
                                &patch.pressure,
                                &patch.traction_along,
                                &patch.traction_lateral,
                                &patch.state,
                                &patch.area})
        if (field->size() != n)
          throw RunError("A field of the contact patch has " + std::to_string(field->size()) +
                         " values where " + std::to_string(patch.n_along) + " x " +
                         std::to_string(patch.n_lateral) + " belong.");
    }

    /// Maximum of c0 + c1 u + c2 v + c3 u^2 + c4 u v + c5 v^2, the least-squares fit to the 3 x 3 nodes
    /// around (i, j), when that lies within the nodes; otherwise the value of the node.
    double
    fitted_peak(const PatchFields &patch, const unsigned int i, const unsigned int j)
    {
      const auto   p    = [&](int u, int v) { return patch.pressure[(i + u) * patch.n_lateral + j + v]; };
      const double peak = p(0, 0);
      if (i == 0 || j == 0 || i + 1 == patch.n_along || j + 1 == patch.n_lateral)
        return peak;

      double sum = 0, su = 0, sv = 0, suu = 0, suv = 0, svv = 0;
      for (int u = -1; u <= 1; ++u)
        for (int v = -1; v <= 1; ++v)
          {
            const double value = p(u, v);
            if (value <= 0) // beyond the edge the pressure is no longer smooth
              return peak;
            sum += value;
            su += u * value;
            sv += v * value;
            suu += u * u * value;
            suv += u * v * value;
            svv += v * v * value;
          }
      const double c0 = (5 * sum - 3 * (suu + svv)) / 9, c1 = su / 6, c2 = sv / 6;
      const double c3 = suu / 2 - sum / 3, c4 = suv / 4, c5 = svv / 2 - sum / 3;
      const double det = 4 * c3 * c5 - c4 * c4;
      if (!(c3 < 0 && det > 0))
        return peak;
      const double u = (c4 * c2 - 2 * c5 * c1) / det, v = (c4 * c1 - 2 * c3 * c2) / det;
      if (std::abs(u) > 1 || std::abs(v) > 1)
        return peak;
      return c0 + c1 * u + c2 * v + c3 * u * u + c4 * u * v + c5 * v * v;
    }

    /// Nodes from k on in steps of `step`, `most` at most, until the pressure falls to half its peak, with
    /// the part of the last one.
    double
    nodes_to_half(const std::vector<double> &pressure,
                  const std::size_t          k,
                  const int                  step,
                  const unsigned int         most)
    {
      const double half = 0.5 * pressure[k];
      double       last = pressure[k];
      for (unsigned int n = 1; n <= most; ++n)
        {
          const double now = pressure[k + static_cast<std::ptrdiff_t>(n) * step];
          if (now < half)
            return n - 1 + (last - half) / (last - now);
          last = now;
        }
      return most;
    }

    /// See PatchMeasures::cells_across.
    double
    cells_across_peak(const PatchFields &patch, const std::size_t k)
    {
      const unsigned int across = patch.n_lateral, i = k / across, j = k % across;
      const auto        &p     = patch.pressure;
      const int          along = static_cast<int>(across);
      const double       length =
                     nodes_to_half(p, k, along, patch.n_along - 1 - i) + nodes_to_half(p, k, -along, i),
                   lateral = nodes_to_half(p, k, 1, across - 1 - j) + nodes_to_half(p, k, -1, j);
      return std::min(length, lateral) / std::sqrt(0.75);
    }

    /// The rise of the pressure between nodes on a line over the value of node `k`, over this.
    double
    rise_beside(std::vector<double> pressure, const int k)
    {
      const int last = static_cast<int>(pressure.size()) - 1;
      if (k == 0 || k == last || last < 3)
        return 0;
      const double        node = pressure[k];
      std::vector<double> place(pressure.size());
      std::iota(place.begin(), place.end(), 0.);
      const boost::math::interpolators::makima<std::vector<double>> curve(std::move(place),
                                                                          std::move(pressure));
      double                                                        top = node;
      for (const int from : {k - 1, k}) // one maximum in each
        top = std::max(top,
                       -boost::math::tools::brent_find_minima(
                          [&](const double x) { return -curve(x); }, double(from), from + 1., 20)
                          .second);
      return top / node - 1;
    }

    /// See PatchMeasures::between_nodes.
    double
    rise_between_nodes(const PatchFields &patch, const std::size_t k)
    {
      const unsigned int  across = patch.n_lateral, i = k / across, j = k % across;
      const auto          begin = patch.pressure.begin() + std::ptrdiff_t(i) * across;
      std::vector<double> along(patch.n_along);
      for (unsigned int n = 0; n < patch.n_along; ++n)
        along[n] = patch.pressure[n * std::size_t(across) + j];
      return rise_beside(std::move(along), static_cast<int>(i)) +
             rise_beside({begin, begin + across}, static_cast<int>(j));
    }

    void
    add_sums(const PatchFields &patch, PatchMeasures &measures)
    {
      const bool slips   = patch.slip_along.size() == patch.pressure.size();
      measures.t_gamma   = slips ? 0 : std::nan("");
      double loaded_area = 0, stick_area = 0, moment_along = 0, moment_lateral = 0;
      for (std::size_t k = 0; k < patch.pressure.size(); ++k)
        {
          const double force = patch.pressure[k] * patch.area[k];
          measures.normal_force += force;
          moment_along += force * patch.along[k];
          moment_lateral += force * patch.lateral[k];
          measures.traction_force_along += patch.traction_along[k] * patch.area[k];
          if (slips)
            measures.t_gamma += patch.area[k] * (patch.traction_along[k] * patch.slip_along[k] +
                                                 patch.traction_lateral[k] * patch.slip_lateral[k]);
          if (patch.pressure[k] > 0)
            {
              loaded_area += patch.area[k];
              if (patch.state[k] == 1)
                stick_area += patch.area[k];
            }
        }
      if (loaded_area > 0)
        measures.stick_fraction = stick_area / loaded_area;
      if (measures.normal_force > 0)
        {
          measures.centre_of_pressure_along   = moment_along / measures.normal_force;
          measures.centre_of_pressure_lateral = moment_lateral / measures.normal_force;
        }
    }
  } // namespace

  PatchMeasures
  measure_patch(const PatchFields &patch)
  {
    check_lengths(patch);
    PatchMeasures measures;
    add_sums(patch, measures);
    measures.max_traction = largest_shear(patch);

    const auto top = std::max_element(patch.pressure.begin(), patch.pressure.end());
    if (top == patch.pressure.end() || !(*top > 0))
      return measures;
    const auto k                  = static_cast<unsigned int>(top - patch.pressure.begin());
    measures.peak_pressure        = *top;
    measures.peak_pressure_fitted = fitted_peak(patch, k / patch.n_lateral, k % patch.n_lateral);
    measures.cells_across         = cells_across_peak(patch, k);
    measures.between_nodes        = rise_between_nodes(patch, k);

    const PatchEdge edge    = find_patch_edge(patch);
    measures.area           = edge.area;
    measures.n_loaded       = edge.n_loaded;
    measures.n_patches      = edge.n_patches;
    measures.touches_border = edge.touches_border;
    measures.length         = edge.along_max - edge.along_min;
    measures.width          = edge.lateral_max - edge.lateral_min;
    measures.centre_along   = 0.5 * (edge.along_max + edge.along_min);
    measures.centre_lateral = 0.5 * (edge.lateral_max + edge.lateral_min);
    return measures;
  }
} // namespace wheelrail
