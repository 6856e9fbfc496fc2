#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace wheelrail
{
  /// A Hermitian positive definite matrix of double or std::complex<double> whose entries (i, j) vanish for
  /// |i - j| > band, and its factor L L^H (Cholesky, by LAPACK).
  template <typename Number>
  class BandCholesky
  {
  public:
    BandCholesky() = default;
    /// Zeros.
    BandCholesky(std::size_t size, std::size_t band);

    /// Entry (row, column) of the lower half, row - band <= column <= row.
    Number &
    operator()(const std::size_t row, const std::size_t column)
    {
      return values_[column * (band_ + 1) + row - column];
    }

    /// All entries, for sums over ranks.
    Number *
    data()
    {
      return values_.data();
    }
    std::size_t
    n_data() const
    {
      return values_.size();
    }

    /// Replaces the matrix by its factor. Throws std::runtime_error when it is not positive definite.
    void
    factorise();

    /// The right-hand side x, of the matrix's size, becomes the solution.
    void
    solve(Number *x) const;

  private:
    std::size_t         size_ = 0, band_ = 0;
    std::vector<Number> values_; ///< the columns of the lower half, each from its diagonal on
  };
} // namespace wheelrail
