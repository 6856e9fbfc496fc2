#include <wheelrail/sampling/slip_edge.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace wheelrail
{
  namespace
  {
    constexpr double no_edge = std::numeric_limits<double>::quiet_NaN();

    enum State
    {
      sticking = 1,
      slipping = 2
    };

    /// The nodes of one grid line along the track, counted from a slipping node 0 into the sticking side:
    /// 1, 2, 3 stick, -1 lies behind the slipping node.
    struct PatchLine
    {
      const PatchFields &patch;
      int                i, j, direction; ///< the slipping node; +1 or -1 along the track

      bool
      has(const int n) const
      {
        const int k = i + n * direction;
        return k >= 0 && k < int(patch.n_along);
      }
      std::size_t
      index(const int n) const
      {
        return std::size_t(i + n * direction) * patch.n_lateral + j;
      }
      bool
      is(const int n, const State state) const
      {
        return has(n) && patch.state[index(n)] == state && patch.pressure[index(n)] > 0;
      }
      double
      pressure(const int n) const
      {
        return patch.pressure[index(n)];
      }
      double
      distance(const int n) const ///< from node 0, positive towards the sticking side
      {
        return (patch.along[index(n)] - patch.along[index(0)]) * direction;
      }
    };

    /// q^2 of node n, see largest_shear().
    double
    shortfall_squared(const PatchLine &line, const int n)
    {
      const PatchFields &patch = line.patch;
      const std::size_t  slip = line.index(0), k = line.index(n);
      const double       scale = line.pressure(n) / line.pressure(0);
      const double       a     = scale * patch.traction_along[slip] - patch.traction_along[k];
      const double       b     = scale * patch.traction_lateral[slip] - patch.traction_lateral[k];
      return a * a + b * b;
    }

    /// Distance from the slipping node at which q^2 vanishes; NaN where it does not between nodes 0 and 1.
    double
    place_of_line(const PatchLine &line)
    {
      if (!line.is(2, sticking))
        return no_edge;
      const double x1 = line.distance(1), x2 = line.distance(2);
      const double q1 = shortfall_squared(line, 1), q2 = shortfall_squared(line, 2);
      const double slope12 = (q2 - q1) / (x2 - x1);
      double       slope = slope12, curvature = 0; // of q^2 at node 1
      if (line.is(3, sticking))
        {
          const double x3      = line.distance(3);
          const double slope23 = (shortfall_squared(line, 3) - q2) / (x3 - x2);
          curvature            = (slope23 - slope12) / (x3 - x1);
          slope                = slope12 - curvature * (x2 - x1);
        }
      const double root = slope * slope - 4 * curvature * q1;
      if (!(slope > 0 && root >= 0))
        return no_edge;
      const double x = x1 - 2 * q1 / (slope + std::sqrt(root));
      return x >= 0 ? x : no_edge;
    }

    /// Pressure at distance x from node 0: the polynomial through nodes -1 to 2, those that are loaded.
    double
    pressure_at(const PatchLine &line, const double x)
    {
      std::vector<int> nodes;
      for (const int n : {-1, 0, 1, 2})
        if (line.has(n) && line.pressure(n) > 0)
          nodes.push_back(n);
      double p = 0;
      for (const int n : nodes)
        {
          double weight = 1;
          for (const int m : nodes)
            if (m != n)
              weight *= (x - line.distance(m)) / (line.distance(n) - line.distance(m));
          p += weight * line.pressure(n);
        }
      return p;
    }
  } // namespace


  SlipEdge
  slip_edge(const PatchFields &patch)
  {
    SlipEdge edge;
    for (int i = 0; i < int(patch.n_along); ++i)
      for (int j = 0; j < int(patch.n_lateral); ++j)
        for (const int direction : {-1, 1})
          {
            const PatchLine line{patch, i, j, direction};
            if (!line.is(0, slipping) || !line.is(1, sticking))
              continue;
            const double x = place_of_line(line);
            if (std::isnan(x))
              continue;
            // near the rim of the patch a polynomial may leave the values of its nodes
            const double p = std::min(pressure_at(line, x), std::max(line.pressure(0), line.pressure(1)));
            const std::size_t slip = line.index(0);
            edge.along.push_back(patch.along[slip] + direction * x);
            edge.lateral.push_back(patch.lateral[slip]);
            edge.pressure.push_back(p);
            edge.traction_along.push_back(patch.traction_along[slip] / line.pressure(0) * p);
            edge.traction_lateral.push_back(patch.traction_lateral[slip] / line.pressure(0) * p);
          }
    return edge;
  }


  double
  largest_shear(const PatchFields &patch)
  {
    double     largest = 0;
    const auto look    = [&](const std::vector<double> &along, const std::vector<double> &lateral) {
      for (std::size_t k = 0; k < along.size(); ++k)
        largest = std::max(largest, std::hypot(along[k], lateral[k]));
    };
    const SlipEdge edge = slip_edge(patch);
    look(patch.traction_along, patch.traction_lateral);
    look(edge.traction_along, edge.traction_lateral);
    return largest;
  }
} // namespace wheelrail
