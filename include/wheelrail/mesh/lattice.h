#pragma once

#include <wheelrail/mesh/sweep_plan.h>

#include <cstddef>

namespace wheelrail
{
  /// The lattice on which the vertices of a running surface lie in the fine zone: stations along
  /// the track at `first_station + i` times `spacing_along`, rows across at `s_begin + j spacing`.
  struct Lattice
  {
    int          first_station = 0;
    unsigned int n_along = 0, n_lateral = 0;
    double       spacing_along = 0, s_begin = 0, spacing_lateral = 0; ///< [m]

    std::size_t
    index(const unsigned int i, const unsigned int j) const
    {
      return std::size_t(i) * n_lateral + j;
    }
  };

  /// The stations between fine_begin and fine_end of a plan and the rows of its strip; the same on rail and
  /// wheel. Another fine range of the same plan stores another part of the same endless lattice.
  Lattice
  make_lattice(const SweepPlan &plan);
} // namespace wheelrail
