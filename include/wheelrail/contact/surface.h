#pragma once

#include <wheelrail/base/vector3.h>
#include <wheelrail/geometry/running_surfaces.h>
#include <wheelrail/mesh/local_mesh.h>

#include <mpi.h>

#include <vector>

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

  /// The running surface of one body in its fine zone, known to all ranks; index i n_lateral + j.
  struct Surface
  {
    Body                       body = Body::rail;
    Lattice                    lattice;
    std::vector<Vector3>       reference; ///< [m]
    std::vector<double>        area;      ///< tributary area of the node on the facets [m2]
    std::vector<std::uint32_t> global_node;
    std::vector<int>           owner; ///< rank that sends the node's state
    std::vector<int>           local; ///< node on this rank, or -1
  };

  /// Collects the vertices of the finest running faces of a body. Collective.
  /// Throws RunError when the lattice has holes (the mesh does not cover the fine zone).
  Surface
  make_surface(const LocalMesh       &mesh,
               Body                   body,
               const RunningSurfaces &surfaces,
               const Lattice         &lattice,
               MPI_Comm               communicator);
} // namespace wheelrail
