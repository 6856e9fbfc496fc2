#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_vector.h>

#include <wheelrail/dynamics/band_cholesky.h>

#include <stdexcept>

namespace wheelrail
{
  BandCholesky::BandCholesky(const std::size_t size, const std::size_t band)
    : values_(size == 0 ? nullptr : gsl_matrix_calloc(size, band + 1))
  {
  }


  void
  BandCholesky::factorise()
  {
    gsl_set_error_handler_off();
    if (values_ && gsl_linalg_cholesky_band_decomp(values_.get()) != GSL_SUCCESS)
      throw std::runtime_error("a matrix is not positive definite");
  }


  void
  BandCholesky::solve(std::vector<double> &x) const
  {
    if (!values_)
      return;
    gsl_vector_view view = gsl_vector_view_array(x.data(), x.size());
    gsl_linalg_cholesky_band_svx(values_.get(), &view.vector);
  }
} // namespace wheelrail
