#include <deal.II/lac/lapack_templates.h>

#include <wheelrail/base/errors.h>
#include <wheelrail/bodies/wave_element.h>
#include <wheelrail/bodies/wave_matrices.h>
#include <wheelrail/bodies/wave_stiffness.h>

#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

// C(k) = F' K(k)^-1 F, compliance between rows of the running surface at one wavenumber
// (doc/theory/bodies.md, 2.5-D elements). K(k) is real, symmetric and, with foot or bore held, positive:
// Cholesky. With the surface ordered last F has entries in the end of L alone, and C = (L^-1 F)'(L^-1 F) asks
// for a dense block of it.

namespace wheelrail
{
  namespace
  {
    /// CHOLMOD asks for four threads in its innermost loops, whatever OMP_NUM_THREADS says: waking them for
    /// blocks as small as those of a section takes as long as the factors themselves.
    class OnOneThread
    {
    public:
      OnOneThread()
        : levels_(omp_get_max_active_levels())
      {
        omp_set_max_active_levels(0);
      }
      ~OnOneThread()
      {
        omp_set_max_active_levels(levels_);
      }
      OnOneThread(const OnOneThread &) = delete;
      OnOneThread &
      operator=(const OnOneThread &) = delete;

    private:
      int levels_;
    };

    /// Integrals of the three shape functions over an edge, each times ds.
    std::array<double, 3>
    edge_integrals(const SectionMesh &mesh, const SectionMesh::Edge &edge)
    {
      return edge_weights(mesh, edge.node, [](const Point2 &) { return 1.; });
    }
  } // namespace


  std::vector<SurfaceRow>
  surface_rows(const SectionMesh &mesh, const unsigned int cells, const bool wheel)
  {
    std::vector<SurfaceRow> rows;
    for (unsigned int first = 0; first + cells <= mesh.running.size(); first += cells)
      {
        // one traction on all cells of a row: what error single cells have is averaged
        SurfaceRow row;
        for (unsigned int e = first; e < first + cells; ++e)
          {
            // width: the arc of its cells, by the same integrals as its loads
            row.edges.push_back(e);
            for (const double weight : edge_integrals(mesh, mesh.running[e]))
              row.width += weight;
          }
        const auto  &middle = mesh.running[first + cells / 2].node;
        const Point2 start  = mesh.nodes[mesh.running[first].node[0]],
                     end    = mesh.nodes[mesh.running[first + cells - 1].node[2]];
        // middle node of the row
        row.place = mesh.nodes[cells % 2 ? middle[1] : middle[0]];
        // of the chord from end to end
        row.angle  = std::atan2(end.y - start.y, end.x - start.x);
        row.radius = wheel ? row.place.y : 0;
        rows.push_back(row);
      }
    return rows;
  }


  struct WaveStiffness::Data
  {
    Data(const SectionMesh &mesh, const Elasticity &elasticity, bool wheel);
    ~Data();

    void
    order();
    /// K(k) in `matrix`, factored.
    cholmod_factor *
    factor(double k);
    /// The integrals over a row of the shape functions that move it along a, as (unknown, value).
    std::vector<std::pair<int, double>>
    row_load(const SurfaceRow &row, int a) const;
    /// Displacements of all nodes under forces on the unknowns.
    std::vector<Vector3>
    solve(double k, const std::vector<double> &load);

    bool             wheel;
    SectionMesh      mesh;
    WaveMatrices     parts;
    cholmod_common   common{};
    cholmod_sparse  *matrix   = nullptr; ///< lower half
    cholmod_factor  *symbolic = nullptr;
    std::vector<int> place; ///< of an unknown in the order of the factors
  };


  WaveStiffness::Data::Data(const SectionMesh &mesh, const Elasticity &elasticity, const bool wheel)
    : wheel(wheel)
    , mesh(mesh)
    , parts(assemble_waves(mesh, elasticity, wheel))
  {
    cholmod_start(&common);
    common.print = 0;
    matrix =
      cholmod_allocate_sparse(parts.size(), parts.size(), parts.row.size(), 1, 1, -1, CHOLMOD_REAL, &common);
    std::copy(parts.start.begin(), parts.start.end(), static_cast<int *>(matrix->p));
    std::copy(parts.row.begin(), parts.row.end(), static_cast<int *>(matrix->i));
    order();
  }


  WaveStiffness::Data::~Data()
  {
    cholmod_free_factor(&symbolic, &common);
    cholmod_free_sparse(&matrix, &common);
    cholmod_finish(&common);
  }


  void
  WaveStiffness::Data::order()
  {
    // the running surface last: the end of the factor is then all that its compliance asks for
    std::vector<int> member(parts.size(), 0), permutation(parts.size());
    // constrained minimum degree (CAMD): members of set 1 come after all of set 0
    // unknowns of the surface were numbered last by assemble_waves()
    std::fill(member.end() - 3 * parts.n_surface, member.end(), 1);
    cholmod_camd(matrix, nullptr, 0, member.data(), permutation.data(), &common);
    // this order and no other; without postordering, which could mix both sets
    common.nmethods           = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
    common.postorder          = 0;
    symbolic                  = cholmod_analyze_p(matrix, permutation.data(), nullptr, 0, &common);
    const auto *order         = static_cast<const int *>(symbolic->Perm);
    place.resize(parts.size());
    for (int k = 0; k < parts.size(); ++k)
      // inverse permutation: where an unknown stands in L
      place[order[k]] = k;
  }


  cholmod_factor *
  WaveStiffness::Data::factor(const double k)
  {
    auto       *x      = static_cast<double *>(matrix->x);
    const auto &values = parts.values;
    for (std::size_t e = 0; e < values[0].size(); ++e)
      // (1) of doc/theory/bodies.md, K(k) = K0 + k K1 + k^2 K2 by Horner's rule; of a wheel k is the number n
      // of waves around it, which the 1/r of its strains makes n/r
      x[e] = values[0][e] + k * (values[1][e] + k * values[2][e]);
    const OnOneThread one_thread;
    // one analysis for all wavenumbers: the pattern is the same
    cholmod_factor *L = cholmod_copy_factor(symbolic, &common);
    cholmod_factorize(matrix, L, &common);
    constexpr double singular = 1e-13; // what rounding leaves of a pivot that is 0
    // a pivot that is 0 to round-off: a motion without strain, which foot or bore should hold
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
    // F of (doc/theory/bodies.md, 2.5-D elements): a column for each row and axis
    std::map<int, double> load;
    for (const unsigned int e : row.edges)
      {
        // hanging nodes of the surface hand their share to their masters
        const auto &edge    = mesh.running[e];
        const auto  weights = edge_integrals(mesh, edge);
        for (int n = 0; n < 3; ++n)
          for (const auto &[unknown, weight] : parts.unknowns[edge.node[n]])
            // integral of N over the row [m]
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
    return data_->parts.size();
  }


  std::vector<double>
  WaveStiffness::compliance(const double k, const std::vector<SurfaceRow> &rows)
  {
    Data           &d = *data_;
    cholmod_factor *L = d.factor(k);
    // 1. L of K = L L', packed column by column; of it the last ns x ns block
    cholmod_change_factor(CHOLMOD_REAL, 1, 0, 1, 1, L, &d.common);
    const int           n = d.parts.size(), ns = 3 * d.parts.n_surface, first = n - ns, nr = 3 * rows.size();
    std::vector<double> dense(std::size_t(ns) * ns, 0.), loads(std::size_t(ns) * nr, 0.);
    const auto         *start = static_cast<const int *>(L->p), *row = static_cast<const int *>(L->i);
    const auto         *value = static_cast<const double *>(L->x);
    for (int column = first; column < n; ++column)
      for (int e = start[column]; e < start[column + 1]; ++e)
        // the last ns x ns block of L, dense
        dense[std::size_t(column - first) * ns + row[e] - first] = value[e];
    // the factor takes most of the memory: away with it before the dense part
    cholmod_free_factor(&L, &d.common);
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (int a = 0; a < 3; ++a)
        for (const auto &[unknown, weight] : d.row_load(rows[r], a))
          // 2. F: a traction of 1/width on a row, so that C is the mean displacement of a row under a force
          // of 1 N/m on another. Forces of a wheel count for a radian: sqrt(r) on both sides brings C to a
          // force for each metre of track at the row's radius.
          loads[(3 * r + a) * ns + d.place[unknown] - first] =
            weight / rows[r].width * (d.wheel ? std::sqrt(rows[r].radius) : 1);
    // C = F' K^-1 F = (L^-1 F)' L^-1 F, and only the end of L meets the loads of the surface
    const double        one = 1, zero = 0;
    std::vector<double> compliance(std::size_t(nr) * nr);
    // 3. L^-1 F and its square, by BLAS; only the upper half is computed
    int code = 0;
    // rows above the last block do not matter: F is zero there, and so is L^-1 F
    dealii::trtrs("L", "N", "N", &ns, &nr, dense.data(), &ns, loads.data(), &ns, &code);
    dealii::syrk("U", "T", &nr, &ns, &one, loads.data(), &ns, &zero, compliance.data(), &nr);
    for (int i = 0; i < nr; ++i)
      for (int j = 0; j < i; ++j)
        compliance[i + std::size_t(nr) * j] = compliance[j + std::size_t(nr) * i];
    return compliance;
  }


  std::vector<Vector3>
  WaveStiffness::Data::solve(const double k, const std::vector<double> &load)
  {
    cholmod_factor *L = factor(k);
    // the whole solution, for displacements inside the section
    cholmod_dense *f = cholmod_zeros(load.size(), 1, CHOLMOD_REAL, &common);
    std::copy(load.begin(), load.end(), static_cast<double *>(f->x));
    cholmod_dense       *u      = cholmod_solve(CHOLMOD_A, L, f, &common);
    const auto          *values = static_cast<const double *>(u->x);
    std::vector<Vector3> of_nodes(parts.unknowns.size(), Vector3{});
    // held nodes stay at 0, hanging ones take their masters' mean
    for (std::size_t node = 0; node < of_nodes.size(); ++node)
      for (const auto &[unknown, weight] : parts.unknowns[node])
        for (int a = 0; a < 3; ++a)
          of_nodes[node][a] += weight * values[3 * unknown + a];
    cholmod_free_dense(&u, &common);
    cholmod_free_dense(&f, &common);
    cholmod_free_factor(&L, &common);
    return of_nodes;
  }


  std::vector<Vector3>
  WaveStiffness::displacements(const double                   k,
                               const std::vector<SurfaceRow> &rows,
                               const std::vector<Vector3>    &forces)
  {
    // [N/m] of a rail, [N] for each radian of a wheel
    std::vector<double> load(size(), 0.);
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (int a = 0; a < 3; ++a)
        for (const auto &[unknown, weight] : data_->row_load(rows[r], a))
          // a force spread evenly over its row
          load[unknown] += weight / rows[r].width * forces[r][a];
    return data_->solve(k, load);
  }


  std::vector<Point2>
  WaveStiffness::growth(const double rate, const double density)
  {
    // elastic: displacements go with omega^2, so that a table has them at 1 rad/s
    const Data         &d = *data_;
    std::vector<double> load(size(), 0.);
    for (const auto &cell : d.mesh.cells)
      for (int g = 0; g < 9; ++g)
        {
          const WavePoint point = wave_point(d.mesh, cell, g);
          const double    r     = point.place.y;
          for (unsigned int n = 0; n < n_wave_nodes; ++n)
            for (const auto &[unknown, weight] : d.parts.unknowns[cell[n]])
              // centrifugal load rho omega^2 r outwards; the other r is the weight of a radian. Wavenumber 0:
              // the same all around.
              load[3 * unknown + 1] += weight * point.value[n] * density * rate * rate * r * r * point.weight;
        }
    std::vector<Point2> growth;
    for (const Vector3 &u : data_->solve(0, load))
      // (x, outwards); a turning wheel does not twist
      growth.push_back({u[0], u[1]});
    return growth;
  }


  std::vector<Point2>
  WaveStiffness::growth(const double rate, const double density, const std::vector<SurfaceRow> &rows)
  {
    const std::vector<Point2> nodes = growth(rate, density);
    // the same means as those of displacements under loads
    std::vector<Point2> means;
    for (const SurfaceRow &row : rows)
      {
        Point2 mean;
        for (const unsigned int e : row.edges)
          {
            const auto &edge    = data_->mesh.running[e];
            const auto  weights = edge_integrals(data_->mesh, edge);
            for (int n = 0; n < 3; ++n)
              // mean over the row
              mean = mean + weights[n] / row.width * nodes[edge.node[n]];
          }
        means.push_back(mean);
      }
    return means;
  }
} // namespace wheelrail
