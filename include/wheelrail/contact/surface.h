#pragma once

#include <wheelrail/base/body.h>
#include <wheelrail/base/vector3.h>
#include <wheelrail/geometry/running_surfaces.h>
#include <wheelrail/mesh/lattice.h>
#include <wheelrail/mesh/local_mesh.h>

#include <mpi.h>

#include <cstdint>
#include <vector>

namespace wheelrail
{
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
