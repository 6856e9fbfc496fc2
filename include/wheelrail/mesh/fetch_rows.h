#pragma once

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace wheelrail
{
  /// The rank where others leave and look for what belongs to a key: all find the same one, and keys spread
  /// evenly.
  inline unsigned int
  meeting_rank(const std::uint64_t key, const unsigned int n_ranks)
  {
    return static_cast<unsigned int>(((key * 0x9e3779b97f4a7c15u) >> 32) % n_ranks);
  }

  /// Rows of plain data of all ranks whose keys are wanted here, in an order that the ranks' rows alone give;
  /// one rank gets all of its own. `keys` has the key of each row; several rows may have the same. No rank
  /// holds more than its share of all rows and what it wants. Collective.
  template <typename T>
  std::vector<T>
  fetch_rows(const std::vector<std::uint64_t> &keys,
             const std::vector<T>             &values,
             const std::vector<std::uint64_t> &wanted,
             MPI_Comm                          communicator)
  {
    namespace mpi              = dealii::Utilities::MPI;
    const unsigned int n_ranks = mpi::n_mpi_processes(communicator);
    if (n_ranks == 1)
      return values;
    static_assert(std::is_trivially_copyable<T>::value, "bytes are sent");
    std::map<unsigned int, std::vector<std::uint64_t>> named, asked;
    std::map<unsigned int, std::vector<char>>          told, answers;
    const char *const                                  bytes = reinterpret_cast<const char *>(values.data());
    std::size_t width = keys.empty() ? 0 : values.size() / keys.size() * sizeof(T);
    for (std::size_t k = 0; k < keys.size(); ++k)
      {
        const unsigned int rank = meeting_rank(keys[k], n_ranks);
        named[rank].push_back(keys[k]);
        told[rank].insert(told[rank].end(), bytes + width * k, bytes + width * (k + 1));
      }
    for (const std::uint64_t key : wanted)
      asked[meeting_rank(key, n_ranks)].push_back(key);
    named = mpi::some_to_some(communicator, named);
    told  = mpi::some_to_some(communicator, told);
    asked = mpi::some_to_some(communicator, asked);
    // rows that met here, by key
    using Row = std::pair<std::uint64_t, const char *>;
    std::vector<Row> rows;
    for (const auto &[rank, here] : named)
      {
        const std::vector<char> &from = told.at(rank);
        width                         = from.size() / here.size();
        for (std::size_t k = 0; k < here.size(); ++k)
          rows.emplace_back(here[k], from.data() + width * k);
      }
    const auto before = [](const Row &a, const Row &b) { return a.first < b.first; };
    std::stable_sort(rows.begin(), rows.end(), before);
    for (const auto &[rank, here] : asked)
      for (const std::uint64_t key : here)
        {
          const auto found = std::equal_range(rows.begin(), rows.end(), Row(key, nullptr), before);
          for (auto row = found.first; row != found.second; ++row)
            answers[rank].insert(answers[rank].end(), row->second, row->second + width);
        }
    std::vector<T> all;
    for (const auto &[rank, answer] : mpi::some_to_some(communicator, answers))
      {
        const std::size_t before_it = all.size();
        all.resize(before_it + answer.size() / sizeof(T));
        std::memcpy(static_cast<void *>(all.data() + before_it), answer.data(), answer.size());
      }
    return all;
  }
} // namespace wheelrail
