#pragma once

#include <wheelrail/state/checkpoint.h>

#include <mpi.h>

#include <vector>

namespace test
{
  /// A whole checkpoint, which rank 0 has, by way of a file's bytes on all ranks. Collective.
  inline wheelrail::Checkpoint
  everywhere(const wheelrail::Checkpoint &whole, const int rank)
  {
    std::vector<char> bytes;
    if (rank == 0)
      bytes = wheelrail::checkpoint_bytes(whole);
    unsigned long size = bytes.size();
    MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG, 0, MPI_COMM_WORLD);
    bytes.resize(size);
    MPI_Bcast(bytes.data(), static_cast<int>(size), MPI_CHAR, 0, MPI_COMM_WORLD);
    return wheelrail::checkpoint_from_bytes({bytes.begin(), bytes.end()});
  }
} // namespace test
