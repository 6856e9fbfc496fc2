#pragma once

#include <wheelrail/base/body.h>
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
    int          around = 0; ///< stations of a body that is closed, 0: it is not

    std::size_t
    index(const unsigned int i, const unsigned int j) const
    {
      return std::size_t(i) * n_lateral + j;
    }

    /// Station at a place along the track, or around the wheel, where it is the one next to those stored.
    long
    station(double along) const;
  };

  /// The stations in the stretch `range` of a body and the rows in the part `across` of the strip [m]. Other
  /// ranges of the same plan store other parts of the same endless lattice; on the wheel, stations go on
  /// after a turn.
  Lattice
  make_lattice(const SweepPlan &plan, Body body, const Range &range, const Range &across);
} // namespace wheelrail
