#pragma once

// Tests on several ranks: rank 0 prints all checks, the others only what failed.

#include <deal.II/base/mpi.h>

#include "check.h"

#include <iostream>
#include <sstream>

namespace test
{
  /// Starts and ends MPI; keep one in main().
  class Parallel
  {
  public:
    Parallel(int &argc, char **&argv)
      : mpi_(argc, argv, 1)
    {
      MPI_Comm_rank(MPI_COMM_WORLD, &rank);
      MPI_Comm_size(MPI_COMM_WORLD, &size);
      if (rank > 0)
        screen_ = std::cout.rdbuf(text_.rdbuf());
    }

    /// Prints the result; the exit code of main().
    int
    report()
    {
      if (screen_ == nullptr)
        return test::report();
      std::cout.rdbuf(screen_);
      for (std::string line; std::getline(text_, line);)
        if (line.rfind("FAILED", 0) == 0)
          std::cout << "rank " << rank << ": " << line << std::endl;
      return failures() == 0 ? 0 : 1;
    }

    int rank = 0, size = 1;

  private:
    dealii::Utilities::MPI::MPI_InitFinalize mpi_;
    std::stringstream                        text_;
    std::streambuf                          *screen_ = nullptr;
  };
} // namespace test
