#include <wheelrail/statics/static_vector.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  StaticVector::StaticVector(const LocalMesh &mesh, MPI_Comm communicator)
    : mesh_(&mesh)
    , communicator_(communicator)
    , values_(4 * mesh.n_nodes(), 0.)
  {
  }


  double
  StaticVector::operator*(const StaticVector &other) const
  {
    double sum = 0;
    for (std::size_t n = 0; n < mesh_->n_nodes(); ++n)
      if (mesh_->owned[n])
        for (std::size_t k = 4 * n; k < 4 * n + 3; ++k)
          sum += values_[k] * other.values_[k];
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    return sum;
  }


  double
  StaticVector::l2_norm() const
  {
    return std::sqrt(*this * *this);
  }


  /// A value that is not a number makes the norm one, which std::max would pass over.
  double
  StaticVector::linfty_norm() const
  {
    double largest = 0;
    for (std::size_t n = 0; n < mesh_->n_nodes(); ++n)
      for (std::size_t k = 4 * n; k < 4 * n + 3; ++k)
        if (!(std::abs(values_[k]) <= largest))
          largest = std::isfinite(values_[k]) ? std::abs(values_[k]) : INFINITY;
    MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, communicator_);
    return largest;
  }


  StaticVector &
  StaticVector::operator*=(const double factor)
  {
    for (double &value : values_)
      value *= factor;
    return *this;
  }


  StaticVector &
  StaticVector::operator-=(const StaticVector &other)
  {
    add(-1, other);
    return *this;
  }


  void
  StaticVector::add(const double factor, const StaticVector &other)
  {
    for (std::size_t k = 0; k < values_.size(); ++k)
      values_[k] += factor * other.values_[k];
  }


  void
  StaticVector::scale_and_add(const double factor, const StaticVector &other)
  {
    for (std::size_t k = 0; k < values_.size(); ++k)
      values_[k] = factor * values_[k] + other.values_[k];
  }
} // namespace wheelrail
