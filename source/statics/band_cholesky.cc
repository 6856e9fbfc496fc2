#include <wheelrail/statics/band_cholesky.h>

#include <stdexcept>

// LAPACK, reference manual: a trailing length for each character argument
extern "C"
{
  void
  dpbtrf_(const char *, const int *, const int *, double *, const int *, int *, std::size_t);
  void
  zpbtrf_(const char *, const int *, const int *, std::complex<double> *, const int *, int *, std::size_t);
  void
  dpbtrs_(const char *,
          const int *,
          const int *,
          const int *,
          const double *,
          const int *,
          double *,
          const int *,
          int *,
          std::size_t);
  void
  zpbtrs_(const char *,
          const int *,
          const int *,
          const int *,
          const std::complex<double> *,
          const int *,
          std::complex<double> *,
          const int *,
          int *,
          std::size_t);
}

// Cholesky's factors of a symmetric (hermitian) positive definite band matrix, by LAPACK.

namespace wheelrail
{
  namespace
  {
    constexpr auto decompose = [](auto *values, const int n, const int band) {
      const int rows = band + 1;
      int       info = 0;
      // A = L L' (Cholesky), lower band column by column: A(i, j) at values[(i - j) + rows j]; n band^2
      // operations
      if constexpr (std::is_same_v<decltype(values), double *>)
        dpbtrf_("L", &n, &band, values, &rows, &info, 1);
      else
        zpbtrf_("L", &n, &band, values, &rows, &info, 1);
      return info;
    };

    constexpr auto substitute = [](const auto *values, const int n, const int band, auto *x) {
      const int rows = band + 1, one = 1;
      int       info = 0;
      if constexpr (std::is_same_v<decltype(x), double *>)
        // L y = b, then L^H x = y: 4 n band operations, against n band^2 of the factor
        dpbtrs_("L", &n, &band, &one, values, &rows, x, &n, &info, 1);
      else
        zpbtrs_("L", &n, &band, &one, values, &rows, x, &n, &info, 1);
    };
  } // namespace


  template <typename Number>
  BandCholesky<Number>::BandCholesky(const std::size_t size, const std::size_t band)
    : size_(size)
    , band_(band)
    // lower half by columns, with the corner beyond the last row unused: n (band + 1) numbers
    , values_(size * (band + 1), Number(0))
  {
  }


  template <typename Number>
  void
  BandCholesky<Number>::factorise()
  {
    // info > 0: a pivot is not positive, which a stiffness has when nothing holds the body
    if (size_ > 0 && decompose(values_.data(), static_cast<int>(size_), static_cast<int>(band_)) != 0)
      throw std::runtime_error("a matrix is not positive definite");
  }


  template <typename Number>
  void
  BandCholesky<Number>::solve(Number *x) const
  {
    if (size_ > 0)
      substitute(values_.data(), static_cast<int>(size_), static_cast<int>(band_), x);
  }


  template class BandCholesky<double>;
  template class BandCholesky<std::complex<double>>;
} // namespace wheelrail
