#include <wheelrail/base/errors.h>
#include <wheelrail/bodies/wave_element.h>
#include <wheelrail/bodies/wave_stiffness.h>

#include <cholmod.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

extern "C"
{
  void
  dtrsm_(const char *,
         const char *,
         const char *,
         const char *,
         const int *,
         const int *,
         const double *,
         const double *,
         const int *,
         double *,
         const int *);
  void
  dsyrk_(const char *,
         const char *,
         const int *,
         const int *,
         const double *,
         const double *,
         const int *,
         const double *,
         double *,
         const int *);
}

namespace wheelrail
{
  namespace
  {
    /// Integrals of the three shape functions over an edge, each times ds.
    std::array<double, 3>
    edge_weights(const SectionMesh &mesh, const SectionMesh::Edge &edge)
    {
      std::array<double, 3> weights{};
      for (int g = 0; g < 3; ++g)
        {
          const double t    = wave_gauss_place[g];
          const double N[3] = {(1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)};
          const double d[3] = {4 * t - 3, 4 - 8 * t, 4 * t - 1};
          Point2       speed;
          for (int n = 0; n < 3; ++n)
            speed = speed + d[n] * mesh.nodes[edge.node[n]];
          for (int n = 0; n < 3; ++n)
            weights[n] += wave_gauss_weight[g] * norm(speed) * N[n];
        }
      return weights;
    }
  } // namespace


  std::vector<SurfaceRow>
  surface_rows(const SectionMesh &mesh, const unsigned int cells, const bool wheel)
  {
    std::vector<SurfaceRow> rows;
    for (unsigned int first = 0; first + cells <= mesh.running.size(); first += cells)
      {
        SurfaceRow row;
        for (unsigned int e = first; e < first + cells; ++e)
          {
            row.edges.push_back(e);
            for (const double weight : edge_weights(mesh, mesh.running[e]))
              row.width += weight;
          }
        const auto  &middle = mesh.running[first + cells / 2].node;
        const Point2 start  = mesh.nodes[mesh.running[first].node[0]],
                     end    = mesh.nodes[mesh.running[first + cells - 1].node[2]];
        row.place           = mesh.nodes[cells % 2 ? middle[1] : middle[0]];
        row.angle           = std::atan2(end.y - start.y, end.x - start.x);
        row.radius          = wheel ? row.place.y : 0;
        rows.push_back(row);
      }
    return rows;
  }


  struct WaveStiffness::Data
  {
    Data(const SectionMesh &mesh, const Elasticity &elasticity, bool wheel);
    ~Data();

    void
    number(const SectionMesh &mesh);
    void
    assemble(const SectionMesh &mesh, const Elasticity &elasticity);
    void
    order();
    /// K(k) in `matrix`, factored.
    cholmod_factor *
    factor(double k);
    /// The integrals over a row of the shape functions that move it along a, as (unknown, value).
    std::vector<std::pair<int, double>>
    row_load(const SurfaceRow &row, int a) const;

    bool                                             wheel;
    SectionMesh                                      mesh;
    std::vector<std::vector<std::pair<int, double>>> unknowns; ///< of each node: (free node, weight)
    int                                              n_free = 0, n_surface = 0; ///< free nodes; the last ones
    std::array<std::vector<double>, 3>               values; ///< of K0, K1, K2, in the pattern of `matrix`
    cholmod_common                                   common{};
    cholmod_sparse                                  *matrix   = nullptr; ///< lower half
    cholmod_factor                                  *symbolic = nullptr;
    std::vector<int>                                 place; ///< of an unknown in the order of the factors
  };


  WaveStiffness::Data::Data(const SectionMesh &mesh, const Elasticity &elasticity, const bool wheel)
    : wheel(wheel)
    , mesh(mesh)
  {
    cholmod_start(&common);
    common.print = 0;
    number(mesh);
    assemble(mesh, elasticity);
    order();
  }


  WaveStiffness::Data::~Data()
  {
    cholmod_free_factor(&symbolic, &common);
    cholmod_free_sparse(&matrix, &common);
    cholmod_finish(&common);
  }


  void
  WaveStiffness::Data::number(const SectionMesh &mesh)
  {
    enum : char
    {
      inside,
      surface,
      fixed,
      hanging
    };
    std::vector<char> kind(mesh.nodes.size(), inside);
    for (const auto &edge : mesh.running)
      for (const unsigned int node : edge.node)
        kind[node] = surface;
    for (const auto &node : mesh.hanging)
      kind[node.node] = hanging;
    for (const unsigned int node : mesh.held)
      kind[node] = fixed;
    unknowns.resize(mesh.nodes.size());
    for (const char wanted : {inside, surface})
      for (unsigned int node = 0; node < kind.size(); ++node)
        if (kind[node] == wanted)
          {
            unknowns[node] = {{n_free++, 1.}};
            n_surface += wanted == surface;
          }
    for (const auto &node : mesh.hanging)
      for (unsigned int m = 0; m < node.masters.size(); ++m)
        if (kind[node.masters[m]] != fixed)
          unknowns[node.node].emplace_back(unknowns[node.masters[m]].front().first, node.weights[m]);
  }


  void
  WaveStiffness::Data::assemble(const SectionMesh &mesh, const Elasticity &elasticity)
  {
    std::vector<int>                   rows, columns;
    std::array<std::vector<double>, 3> entries;
    for (const auto &cell : mesh.cells)
      {
        const auto K = wave_matrices(mesh, cell, elasticity, wheel);
        for (unsigned int i = 0; i < n_wave_local; ++i)
          for (unsigned int j = 0; j < n_wave_local; ++j)
            for (const auto &[a, wa] : unknowns[cell[i / 3]])
              for (const auto &[b, wb] : unknowns[cell[j / 3]])
                {
                  const int row = 3 * a + i % 3, column = 3 * b + j % 3;
                  if (row < column)
                    continue;
                  rows.push_back(row);
                  columns.push_back(column);
                  for (int p = 0; p < 3; ++p)
                    entries[p].push_back(wa * wb * K[p][i][j]);
                }
      }
    // duplicates are added up by CHOLMOD; the pattern is the same for all three
    const std::size_t n = 3 * n_free;
    for (int p = 0; p < 3; ++p)
      {
        cholmod_triplet triplet{};
        triplet.nrow = triplet.ncol = n;
        triplet.nzmax = triplet.nnz = rows.size();
        triplet.i                   = rows.data();
        triplet.j                   = columns.data();
        triplet.x                   = entries[p].data();
        triplet.stype               = -1;
        triplet.itype               = CHOLMOD_INT;
        triplet.xtype               = CHOLMOD_REAL;
        triplet.dtype               = CHOLMOD_DOUBLE;
        cholmod_sparse *sparse      = cholmod_triplet_to_sparse(&triplet, 0, &common);
        const auto     *x           = static_cast<const double *>(sparse->x);
        values[p].assign(x, x + cholmod_nnz(sparse, &common));
        if (p == 0)
          matrix = sparse;
        else
          cholmod_free_sparse(&sparse, &common);
      }
  }


  void
  WaveStiffness::Data::order()
  {
    // the running surface last: the end of the factor is then all that its compliance asks for
    std::vector<int> member(3 * n_free, 0), permutation(3 * n_free);
    std::fill(member.end() - 3 * n_surface, member.end(), 1);
    cholmod_camd(matrix, nullptr, 0, member.data(), permutation.data(), &common);
    common.nmethods           = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
    common.postorder          = 0;
    symbolic                  = cholmod_analyze_p(matrix, permutation.data(), nullptr, 0, &common);
    const auto *order         = static_cast<const int *>(symbolic->Perm);
    place.resize(3 * n_free);
    for (int k = 0; k < 3 * n_free; ++k)
      place[order[k]] = k;
  }


  cholmod_factor *
  WaveStiffness::Data::factor(const double k)
  {
    auto *x = static_cast<double *>(matrix->x);
    for (std::size_t e = 0; e < values[0].size(); ++e)
      x[e] = values[0][e] + k * (values[1][e] + k * values[2][e]);
    cholmod_factor *L = cholmod_copy_factor(symbolic, &common);
    cholmod_factorize(matrix, L, &common);
    constexpr double singular = 1e-13; // what rounding leaves of a pivot that is 0
    if (common.status != CHOLMOD_OK || L->minor < L->n || cholmod_rcond(L, &common) < singular)
      {
        cholmod_free_factor(&L, &common);
        throw RunError("The section of the " + std::string(wheel ? "wheel" : "rail") +
                       " moves without strain at the "
                       "wavenumber " +
                       std::to_string(k) + ": nothing holds it. Its elasticity cannot be computed.");
      }
    return L;
  }


  std::vector<std::pair<int, double>>
  WaveStiffness::Data::row_load(const SurfaceRow &row, const int a) const
  {
    std::map<int, double> load;
    for (const unsigned int e : row.edges)
      {
        const auto &edge    = mesh.running[e];
        const auto  weights = edge_weights(mesh, edge);
        for (int n = 0; n < 3; ++n)
          for (const auto &[unknown, weight] : unknowns[edge.node[n]])
            load[3 * unknown + a] += weight * weights[n];
      }
    return {load.begin(), load.end()};
  }


  WaveStiffness::WaveStiffness(const SectionMesh &mesh, const Elasticity &elasticity, const bool wheel)
    : data_(std::make_unique<Data>(mesh, elasticity, wheel))
  {
  }


  WaveStiffness::~WaveStiffness() = default;


  std::size_t
  WaveStiffness::size() const
  {
    return 3 * data_->n_free;
  }


  std::vector<double>
  WaveStiffness::compliance(const double k, const std::vector<SurfaceRow> &rows)
  {
    Data           &d = *data_;
    cholmod_factor *L = d.factor(k);
    cholmod_change_factor(CHOLMOD_REAL, 1, 0, 1, 1, L, &d.common);
    const int           n = 3 * d.n_free, ns = 3 * d.n_surface, first = n - ns, nr = 3 * rows.size();
    std::vector<double> dense(std::size_t(ns) * ns, 0.), loads(std::size_t(ns) * nr, 0.);
    const auto         *start = static_cast<const int *>(L->p), *row = static_cast<const int *>(L->i);
    const auto         *value = static_cast<const double *>(L->x);
    for (int column = first; column < n; ++column)
      for (int e = start[column]; e < start[column + 1]; ++e)
        dense[std::size_t(column - first) * ns + row[e] - first] = value[e];
    cholmod_free_factor(&L, &d.common);
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (int a = 0; a < 3; ++a)
        for (const auto &[unknown, weight] : d.row_load(rows[r], a))
          loads[(3 * r + a) * ns + d.place[unknown] - first] =
            weight / rows[r].width * (d.wheel ? std::sqrt(rows[r].radius) : 1);
    // C = F' K^-1 F = (L^-1 F)' L^-1 F, and only the end of L meets the loads of the surface
    const double        one = 1, zero = 0;
    std::vector<double> compliance(std::size_t(nr) * nr);
    dtrsm_("L", "L", "N", "N", &ns, &nr, &one, dense.data(), &ns, loads.data(), &ns);
    dsyrk_("U", "T", &nr, &ns, &one, loads.data(), &ns, &zero, compliance.data(), &nr);
    for (int i = 0; i < nr; ++i)
      for (int j = 0; j < i; ++j)
        compliance[i + std::size_t(nr) * j] = compliance[j + std::size_t(nr) * i];
    return compliance;
  }


  std::vector<Point2>
  WaveStiffness::growth(const double rate, const double density, const std::vector<SurfaceRow> &rows)
  {
    Data           &d   = *data_;
    cholmod_factor *L   = d.factor(0);
    cholmod_dense  *f   = cholmod_zeros(3 * d.n_free, 1, CHOLMOD_REAL, &d.common);
    auto           *rhs = static_cast<double *>(f->x);
    for (const auto &cell : d.mesh.cells)
      for (int g = 0; g < 9; ++g)
        {
          const WavePoint point = wave_point(d.mesh, cell, g);
          const double    r     = point.place.y;
          for (unsigned int n = 0; n < n_wave_nodes; ++n)
            for (const auto &[unknown, weight] : d.unknowns[cell[n]])
              rhs[3 * unknown + 1] += weight * point.value[n] * density * rate * rate * r * r * point.weight;
        }
    cholmod_dense      *u      = cholmod_solve(CHOLMOD_A, L, f, &d.common);
    const auto         *values = static_cast<const double *>(u->x);
    std::vector<Point2> growth;
    for (const SurfaceRow &row : rows)
      {
        Point2 mean;
        for (const auto &[unknown, weight] : d.row_load(row, 0))
          mean = mean + weight / row.width * Point2{values[unknown], values[unknown + 1]};
        growth.push_back(mean);
      }
    cholmod_free_dense(&u, &d.common);
    cholmod_free_dense(&f, &d.common);
    cholmod_free_factor(&L, &d.common);
    return growth;
  }
} // namespace wheelrail
