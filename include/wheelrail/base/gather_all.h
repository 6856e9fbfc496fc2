#pragma once

#include <mpi.h>

#include <iterator>
#include <type_traits>
#include <vector>

namespace wheelrail
{
  /// The values of all ranks. Plain data only: bytes are sent. One collective call.
  template <typename T>
  std::vector<T>
  gather_values(const T &own, MPI_Comm communicator)
  {
    static_assert(std::is_trivially_copyable<T>::value, "bytes are sent");
    int size;
    MPI_Comm_size(communicator, &size);
    std::vector<T> all(size);
    MPI_Allgather(&own, sizeof(T), MPI_BYTE, all.data(), sizeof(T), MPI_BYTE, communicator);
    return all;
  }

  /// The parts of all ranks, one after the other; `counts`: their sizes. One collective call.
  template <typename T>
  std::vector<T>
  gather_all(const std::vector<T> &own, const std::vector<int> &counts, MPI_Comm communicator)
  {
    static_assert(std::is_trivially_copyable<T>::value, "bytes are sent");
    std::vector<int> begin = {0};
    for (const int count : counts)
      begin.push_back(begin.back() + count);
    std::vector<T> all(begin.back());
    MPI_Datatype   type;
    MPI_Type_contiguous(sizeof(T), MPI_BYTE, &type);
    MPI_Type_commit(&type);
    MPI_Allgatherv(own.data(), own.size(), type, all.data(), counts.data(), begin.data(), type, communicator);
    MPI_Type_free(&type);
    return all;
  }

  /// The same where sizes are not known. Collective.
  template <typename T>
  std::vector<T>
  gather_all(const std::vector<T> &own, MPI_Comm communicator)
  {
    return gather_all(own, gather_values(static_cast<int>(own.size()), communicator), communicator);
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
