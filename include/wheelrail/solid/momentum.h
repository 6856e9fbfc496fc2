#pragma once

#include <wheelrail/solid/motion.h>

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace wheelrail
{
  /// Corrects the velocities of bodies that have come to another mesh, so that their momenta stay.
  ///
  /// Where cells have changed, `is_changed` of the key of a cell of either mesh, the motion of the whole
  /// stays: of each body, behind Z = `middle` [m] and ahead of it, the rigid velocity field that fits best
  /// (least squares, weighted with the mass) is that of the mesh before; nodes take part in proportion to the
  /// share of their mass that has changed. That leaves rigid motions as they are, whatever mass chords of
  /// other cells gain or lose. What linear and angular momentum of a body then still lack, the mass gained or
  /// lost at its velocity, is spread over all of its free nodes as a rigid field: some 1e-5 m/s, and momenta
  /// are those before to round-off. Nodes without inverse mass in `inertia` keep their velocity. Collective.
  void
  conserve_momentum(const Solid                              &before,
                    Solid                                    &after,
                    const std::function<bool(std::uint64_t)> &is_changed,
                    double                                    middle,
                    const std::vector<NodeInertia>           &inertia,
                    MPI_Comm                                  communicator);
} // namespace wheelrail
