#pragma once

#include <deal.II/base/mpi.h>

#include <iterator>
#include <type_traits>
#include <vector>

namespace wheelrail
{
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
    return gather_all(
      own, dealii::Utilities::MPI::all_gather(communicator, static_cast<int>(own.size())), communicator);
  }

  /// The parts of all ranks, one after the other, on rank 0; nothing elsewhere. deal.II's gather() compresses
  /// what it sends, which takes longer than sending it. Collective.
  template <typename Values>
  Values
  gather_on_root(const Values &own, MPI_Comm communicator)
  {
    using T = typename Values::value_type;
    static_assert(std::is_trivially_copyable<T>::value, "bytes are sent");
    const std::vector<int> counts =
      dealii::Utilities::MPI::gather(communicator, static_cast<int>(own.size()));
    std::vector<int> begin = {0};
    for (const int count : counts)
      begin.push_back(begin.back() + count);
    Values       all(begin.back(), T());
    MPI_Datatype type;
    MPI_Type_contiguous(sizeof(T), MPI_BYTE, &type);
    MPI_Type_commit(&type);
    MPI_Gatherv(own.data(), own.size(), type, all.data(), counts.data(), begin.data(), type, 0, communicator);
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
