#pragma once

#include <mpi.h>

#include <iterator>
#include <type_traits>
#include <vector>

namespace wheelrail
{
  /// The parts of all ranks, one after the other. Plain data only: bytes are sent. Collective.
  template <typename T>
  std::vector<T>
  gather_all(const std::vector<T> &own, MPI_Comm communicator)
  {
    static_assert(std::is_trivially_copyable<T>::value, "bytes are sent");
    int size, n = static_cast<int>(own.size());
    MPI_Comm_size(communicator, &size);
    std::vector<int> counts(size), begin(size, 0);
    MPI_Allgather(&n, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator);
    for (int r = 1; r < size; ++r)
      begin[r] = begin[r - 1] + counts[r - 1];
    std::vector<T> all(begin.back() + counts.back());
    MPI_Datatype   type;
    MPI_Type_contiguous(sizeof(T), MPI_BYTE, &type);
    MPI_Type_commit(&type);
    MPI_Allgatherv(own.data(), n, type, all.data(), counts.data(), begin.data(), type, communicator);
    MPI_Type_free(&type);
    return all;
  }

  /// Sums over ranks in the order of the ranks, so that all of them get the same bits. Collective.
  template <typename Values>
  void
  ordered_sum(Values &values, MPI_Comm communicator)
  {
    const std::vector<double> own(std::begin(values), std::end(values));
    const std::vector<double> all = gather_all(own, communicator);
    for (std::size_t k = 0; k < own.size(); ++k)
      {
        values[k] = 0;
        for (std::size_t r = k; r < all.size(); r += own.size())
          values[k] += all[r];
      }
  }
} // namespace wheelrail
