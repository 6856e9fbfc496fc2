#include <wheelrail/sampling/probes.h>

#include <algorithm>
#include <limits>

namespace wheelrail
{
  namespace
  {
    using Corners = std::array<Vector3, 8>;
    using Stress  = std::array<double, 6>;

    std::array<double, 8>
    shape(const Vector3 &xi)
    {
      std::array<double, 8> N;
      for (int v = 0; v < 8; ++v)
        {
          N[v] = 1;
          for (int d = 0; d < 3; ++d)
            N[v] *= (v >> d & 1) ? xi[d] : 1 - xi[d];
        }
      return N;
    }

    /// Stress at a place of a cell: sum of N_v (s_v + 1/2 G_v (X - X_v)), which takes quadratic stresses
    /// exactly, where plain interpolation would flatten them by another h^2/8 times the Laplacian.
    Stress
    stress_in_cell(const LocalMesh                   &mesh,
                   const std::array<unsigned int, 8> &nodes,
                   const NodalStress                 &nodal,
                   const Vector3                     &xi)
    {
      const auto N = shape(xi);
      Vector3    X{};
      for (int v = 0; v < 8; ++v)
        add(X, N[v], mesh.place(nodes[v]));
      Stress s{};
      for (int v = 0; v < 8; ++v)
        {
          const Vector3 away = X - mesh.place(nodes[v]);
          for (int k = 0; k < 6; ++k)
            {
              double change = 0;
              for (int i = 0; i < 3; ++i)
                change += nodal.gradient[18 * nodes[v] + 6 * i + k] * away[i];
              s[k] += N[v] * (nodal.stress[6 * nodes[v] + k] + 0.5 * change);
            }
        }
      return s;
    }

    /// Place of x in the unit cube that the trilinear map takes to the corners (Newton's method); false when
    /// x is outside by more than a hundredth of the cell.
    bool
    place_in_cell(const Corners &corner, const Vector3 &x, Vector3 &xi)
    {
      xi = {0.5, 0.5, 0.5};
      // bricks take one step; elsewhere the digits double with each, so that this is ample
      for (int iteration = 0; iteration < 8; ++iteration)
        {
          const auto N    = shape(xi);
          Vector3    rest = x, J[3] = {{}, {}, {}}; // J[d]: derivative along xi[d]
          for (int v = 0; v < 8; ++v)
            {
              add(rest, -N[v], corner[v]);
              for (int d = 0; d < 3; ++d)
                {
                  double weight = (v >> d & 1) ? 1 : -1;
                  for (int e = 0; e < 3; ++e)
                    if (e != d)
                      weight *= (v >> e & 1) ? xi[e] : 1 - xi[e];
                  add(J[d], weight, corner[v]);
                }
            }
          const double  det  = dot(J[0], cross(J[1], J[2]));
          const Vector3 move = {dot(rest, cross(J[1], J[2])) / det,
                                dot(rest, cross(J[2], J[0])) / det,
                                dot(rest, cross(J[0], J[1])) / det};
          add(xi, 1, move);
          if (norm(move) < 1e-10)
            break;
        }
      return std::all_of(xi.begin(), xi.end(), [](const double v) { return v > -0.01 && v < 1.01; });
    }

    /// Range of a body's probes [m].
    struct Box
    {
      Vector3 low  = {1e300, 1e300, 1e300};
      Vector3 high = {-1e300, -1e300, -1e300};

      void
      take(const Vector3 &x)
      {
        for (int d = 0; d < 3; ++d)
          {
            low[d]  = std::min(low[d], x[d]);
            high[d] = std::max(high[d], x[d]);
          }
      }
      bool
      meets(const Box &other) const
      {
        for (int d = 0; d < 3; ++d)
          if (low[d] > other.high[d] || high[d] < other.low[d])
            return false;
        return true;
      }
    };

    /// Means over the cells that hold a point, of N numbers that `add(hit, sums)` adds for each.
    template <std::size_t N, typename Add>
    std::vector<std::array<double, N>>
    means(const Probes &probes, const Add &add)
    {
      std::vector<double> sums((N + 1) * probes.n_points, 0.); // number of cells, then the sums over them
      for (const Probes::Hit &hit : probes.hits)
        {
          double *const at = &sums[(N + 1) * hit.point];
          at[0] += 1;
          add(hit, at + 1);
        }
      MPI_Allreduce(
        MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_DOUBLE, MPI_SUM, probes.communicator);
      std::vector<std::array<double, N>> values(probes.n_points);
      for (std::size_t p = 0; p < probes.n_points; ++p)
        {
          const double *const s     = &sums[(N + 1) * p];
          const double        found = s[0] > 0 ? s[0] : std::numeric_limits<double>::quiet_NaN();
          for (std::size_t k = 0; k < N; ++k)
            values[p][k] = s[k + 1] / found;
        }
      return values;
    }

    /// means() of one number.
    template <typename Value>
    std::vector<double>
    means_of(const Probes &probes, const Value &value)
    {
      std::vector<double> numbers;
      for (const auto &v : means<1>(probes, [&](const Probes::Hit &hit, double *sum) { *sum += value(hit); }))
        numbers.push_back(v[0]);
      return numbers;
    }
  } // namespace


  Probes
  find_probes(const Solid &solid, const Body body, const std::vector<Vector3> &points, MPI_Comm communicator)
  {
    Probes probes{points.size(), {}, communicator};
    Box    all;
    for (const Vector3 &point : points)
      all.take(point);
    for (unsigned int c = 0; c < solid.mesh.cells.size(); ++c)
      {
        if (solid.mesh.cell_body[c] != body)
          continue;
        Corners corner;
        Box     box;
        for (int v = 0; v < 8; ++v)
          box.take(corner[v] = solid.position(solid.mesh.cells[c][v]));
        // more than place_in_cell() lets a point lie outside
        const Vector3 margin = 0.02 * (box.high - box.low);
        box.take(box.low - margin);
        box.take(box.high + margin);
        if (!box.meets(all))
          continue;
        for (std::size_t p = 0; p < points.size(); ++p)
          {
            Box point;
            point.take(points[p]);
            Vector3 xi;
            if (box.meets(point) && place_in_cell(corner, points[p], xi))
              probes.hits.push_back({p, c, xi});
          }
      }
    return probes;
  }


  std::vector<std::array<double, 6>>
  probe_stress(const Probes &probes, const LocalMesh &mesh, const NodalStress &nodal)
  {
    return means<6>(probes, [&](const Probes::Hit &hit, double *sum) {
      const Stress s = stress_in_cell(mesh, mesh.cells[hit.cell], nodal, hit.xi);
      for (int k = 0; k < 6; ++k)
        sum[k] += s[k];
    });
  }


  std::vector<double>
  probe_nodes(const Probes &probes, const LocalMesh &mesh, const std::vector<double> &field)
  {
    return means_of(probes, [&](const Probes::Hit &hit) {
      const auto N     = shape(hit.xi);
      double     value = 0;
      for (int v = 0; v < 8; ++v)
        value += N[v] * field[mesh.cells[hit.cell][v]];
      return value;
    });
  }


  std::vector<double>
  probe_cells(const Probes &probes, const std::vector<double> &field)
  {
    return means_of(probes, [&](const Probes::Hit &hit) { return field[hit.cell]; });
  }
} // namespace wheelrail
