#pragma once

#include "near.h"

namespace test
{
  /// Rank and number of ranks of a test that needs MPI, which the first of them starts. On several ranks an
  /// exception ends all of them: the others would wait for the one that left.
  struct Parallel
  {
    Parallel();
    int rank = 0, size = 1;
  };
} // namespace test
