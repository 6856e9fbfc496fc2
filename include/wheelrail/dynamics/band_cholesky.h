#pragma once

#include <gsl/gsl_matrix.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace wheelrail
{
  /// A symmetric positive definite matrix whose entries (i, j) vanish for |i - j| > band, and its factor
  /// L L^T (Cholesky, by GSL).
  class BandCholesky
  {
  public:
    BandCholesky() = default;
    /// Zeros.
    BandCholesky(std::size_t size, std::size_t band);

    /// Entry (row, column) of the lower half, row - band <= column <= row.
    double &
    operator()(const std::size_t row, const std::size_t column)
    {
      return *gsl_matrix_ptr(values_.get(), column, row - column);
    }

    /// All entries, for sums over ranks.
    double *
    data()
    {
      return values_ ? values_->data : nullptr;
    }
    std::size_t
    n_data() const
    {
      return values_ ? values_->size1 * values_->size2 : 0;
    }

    /// Replaces the matrix by its factor. Throws std::runtime_error when it is not positive definite.
    void
    factorise();

    /// x becomes the solution for the right-hand side x.
    void
    solve(std::vector<double> &x) const;

  private:
    struct Free
    {
      void
      operator()(gsl_matrix *matrix) const
      {
        gsl_matrix_free(matrix);
      }
    };
    std::unique_ptr<gsl_matrix, Free> values_; ///< row k: the column k of the lower half, diagonal first
  };
} // namespace wheelrail
