#pragma once

#include <mpi.h>

#include <functional>

namespace wheelrail
{
  /// Calls `work` on rank 0 of `comm` only and makes its failure known to all: an InputError, a
  /// RunError or any other std::exception of rank 0 (which becomes a RunError) is thrown with the
  /// same text on every rank, so that no rank waits for one that gave up. Collective; also works
  /// before MPI_Init and then just calls `work`.
  void
  on_root(MPI_Comm comm, const std::function<void()> &work);
} // namespace wheelrail
