#pragma once

#include <wheelrail/mesh/local_mesh.h>

#include <mpi.h>

namespace wheelrail
{
  /// Values of all nodes of a rank, four numbers a node (the last one unused), equal on all ranks that hold
  /// a node; with products and norms over all ranks, in which every node counts once.
  class StaticVector
  {
  public:
    StaticVector() = default;
    /// Zeros. The mesh must outlive the vector.
    StaticVector(const LocalMesh &mesh, MPI_Comm communicator);

    /// Scalar product. Collective.
    double
    operator*(const StaticVector &other) const;

    /// Collective.
    double
    l2_norm() const;

    /// Largest absolute value. Collective.
    double
    linfty_norm() const;

    StaticVector &
    operator*=(double factor);
    StaticVector &
    operator-=(const StaticVector &other);

    /// *this += factor x other.
    void
    add(double factor, const StaticVector &other);

    /// *this = factor x *this + other.
    void
    scale_and_add(double factor, const StaticVector &other);

    double *
    data()
    {
      return values_.data();
    }
    const double *
    data() const
    {
      return values_.data();
    }

  private:
    const LocalMesh      *mesh_ = nullptr;
    MPI_Comm              communicator_{};
    AlignedVector<double> values_;
  };
} // namespace wheelrail
