#include <deal.II/lac/lapack_templates.h>

#include <wheelrail/base/errors.h>
#include <wheelrail/bodies/section_motions.h>

#include <cholmod.h>

#include <algorithm>
#include <cmath>
#include <string>

// (K(k) - omega^2 M) u = 0 of a section at one wavenumber: slowest motions by subspace iteration with a
// shift, as rigid motions have no stiffness at k = 0.

namespace wheelrail
{
  namespace
  {
    double
    dot_product(const std::vector<double> &a, const std::vector<double> &b)
    {
      double sum = 0;
      for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
      return sum;
    }
  } // namespace


  std::vector<double>
  product(const WaveMatrices &of, const std::array<double, 4> &factor, const std::vector<double> &x)
  {
    // y = (f_0 K0 + f_1 K1 + f_2 K2 + f_3 M) x
    std::vector<double> y(x.size(), 0.);
    for (int column = 0; column < of.size(); ++column)
      for (int e = of.start[column]; e < of.start[column + 1]; ++e)
        {
          // entry of the sum of four matrices at the same place of the pattern
          double value = 0;
          for (int p = 0; p < 4; ++p)
            value += factor[p] * of.values[p][e];
          // lower half alone is stored: each entry counts twice but on the diagonal
          y[of.row[e]] += value * x[column];
          if (of.row[e] != column)
            y[column] += value * x[of.row[e]];
        }
    return y;
  }


  struct ShiftedSection::Factor
  {
    cholmod_common  common{};
    cholmod_factor *factor = nullptr;
  };


  ShiftedSection::ShiftedSection(const WaveMatrices &of, const double k, const double shift)
    : factor_(std::make_unique<Factor>())
  {
    // one factor a wavenumber; each round of the iteration takes m solutions
    cholmod_common &common = factor_->common;
    cholmod_start(&common);
    common.print = 0;
    cholmod_sparse *matrix =
      cholmod_allocate_sparse(of.size(), of.size(), of.row.size(), 1, 1, -1, CHOLMOD_REAL, &common);
    // lower half, stype -1, real: as WaveMatrices stores it
    std::copy(of.start.begin(), of.start.end(), static_cast<int *>(matrix->p));
    std::copy(of.row.begin(), of.row.end(), static_cast<int *>(matrix->i));
    auto *x = static_cast<double *>(matrix->x);
    for (std::size_t e = 0; e < of.row.size(); ++e)
      // K(k) + shift M: positive definite also where a rigid motion has no stiffness
      x[e] = of.values[0][e] + k * (of.values[1][e] + k * of.values[2][e]) + shift * of.values[3][e];
    factor_->factor = cholmod_analyze(matrix, &common);
    cholmod_factorize(matrix, factor_->factor, &common);
    cholmod_free_sparse(&matrix, &common);
  }


  ShiftedSection::~ShiftedSection()
  {
    cholmod_free_factor(&factor_->factor, &factor_->common);
    cholmod_finish(&factor_->common);
  }


  std::vector<double>
  ShiftedSection::solve(std::vector<double> rhs)
  {
    // a view of the right-hand side, not a copy
    cholmod_dense b{};
    b.nrow = b.d = b.nzmax = rhs.size();
    b.ncol                 = 1;
    b.x                    = rhs.data();
    b.xtype                = CHOLMOD_REAL;
    b.dtype                = CHOLMOD_DOUBLE;
    cholmod_dense *x       = cholmod_solve(CHOLMOD_A, factor_->factor, &b, &factor_->common);
    const auto    *values  = static_cast<const double *>(x->x);
    // x of (K(k) + shift M) x = b, in place of b
    std::copy(values, values + rhs.size(), rhs.begin());
    cholmod_free_dense(&x, &factor_->common);
    return rhs;
  }


  SectionColumns
  slow_motions(const WaveMatrices &of, const double k, const unsigned int count, std::vector<double> *squares)
  {
    constexpr double shift = 1e6; // (160 Hz)^2: rigid motions have no stiffness
    constexpr int    most  = 40;
    // more columns than wanted: the error falls with the ratio of shifted squares of the last wanted and the
    // first left out
    const int      m = count + 8;
    ShiftedSection solver(of, k, shift);
    SectionColumns x(m, std::vector<double>(of.size()));
    unsigned int   seed = 1;
    for (auto &column : x)
      for (double &value : column)
        // noise, the same on every machine (linear congruence): no motion is missed
        value = (seed = seed * 1664525u + 1013904223u) / 4294967296. - 0.5;
    std::vector<double> values(m, 0.), before;
    for (int round = 0; round < most; ++round)
      {
        SectionColumns with_mass;
        for (auto &column : x)
          // 1. x <- (K(k) + shift M)^-1 M x: the slowest motions grow fastest (subspace iteration, Bathe and
          // Wilson 1972)
          column = solver.solve(product(of, {0, 0, 0, 1}, column));
        std::vector<double> a(std::size_t(m) * m), b(a.size()), work(40 * m);
        for (int j = 0; j < m; ++j)
          {
            // 2. Rayleigh and Ritz: a = X' K X, b = X' M X, a q = omega^2 b q by LAPACK; X q are the next x
            const auto stiff = product(of, {1, k, k * k, 0}, x[j]);
            const auto heavy = product(of, {0, 0, 0, 1}, x[j]);
            for (int i = 0; i < m; ++i)
              {
                a[i + std::size_t(m) * j] = dot_product(x[i], stiff);
                // m x m matrices of the subspace
                b[i + std::size_t(m) * j] = dot_product(x[i], heavy);
              }
          }
        const int kind = 1, length = 40 * m;
        int       code = 0;
        // values ascend: the slowest first
        dealii::sygv(
          &kind, "V", "U", &m, a.data(), &m, b.data(), &m, values.data(), work.data(), &length, &code);
        if (code != 0)
          throw RunError("The waves of the section could not be found at the wavenumber " +
                         std::to_string(k) + ": its slowest motions cannot be told apart.");
        SectionColumns turned(m, std::vector<double>(of.size(), 0.));
        for (int j = 0; j < m; ++j)
          for (int i = 0; i < m; ++i)
            for (std::size_t d = 0; d < turned[j].size(); ++d)
              turned[j][d] += a[i + std::size_t(m) * j] * x[i][d];
        x = std::move(turned);
        // 3. until the squares of the `count` slowest stay; the eight beside them only speed it up
        double change = before.empty() ? 1 : 0;
        for (unsigned int j = 0; j < count && !before.empty(); ++j)
          change = std::max(change, std::abs(values[j] - before[j]) / (std::abs(values[j]) + shift));
        before = values;
        if (change < 1e-9)
          break;
      }
    x.resize(count);
    if (squares)
      squares->assign(values.begin(), values.begin() + count);
    return x;
  }


  SectionColumns
  common_directions(const WaveMatrices &of, const SectionColumns &columns, const double least)
  {
    // columns are far from orthogonal: motions at one wavenumber are much like those at the next
    const int      n = columns.size();
    SectionColumns with_mass;
    for (const auto &column : columns)
      with_mass.push_back(product(of, {0, 0, 0, 1}, column));
    std::vector<double> gram(std::size_t(n) * n), values(n), work(40 * n), size(n);
    for (int i = 0; i < n; ++i)
      size[i] = std::sqrt(dot_product(columns[i], with_mass[i]));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        // Gram's matrix in the mass of columns of length 1; its eigenvectors over the root of their
        // eigenvalues are orthonormal directions. Those of the smallest eigenvalues are what columns have in
        // common, or round-off.
        gram[i + std::size_t(n) * j] = dot_product(columns[i], with_mass[j]) / (size[i] * size[j]);
    int length = 40 * n, code = 0;
    dealii::syev("V", "U", &n, gram.data(), &n, values.data(), work.data(), &length, &code);
    // from the largest eigenvalue down
    SectionColumns basis;
    // their sum is n: `least` is a share of it
    for (int j = n; j-- > 0 && values[j] > least * n;)
      {
        auto &direction = basis.emplace_back(of.size(), 0.);
        for (int i = 0; i < n; ++i)
          {
            // length 1 in the mass: X' M X = 1
            const double factor = gram[i + std::size_t(n) * j] / (size[i] * std::sqrt(values[j]));
            for (std::size_t d = 0; d < direction.size(); ++d)
              direction[d] += factor * columns[i][d];
          }
      }
    return basis;
  }
} // namespace wheelrail
