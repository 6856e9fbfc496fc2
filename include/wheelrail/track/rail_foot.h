#pragma once

#include <wheelrail/solid/solid.h>

#include <array>
#include <vector>

namespace wheelrail
{
  /// The base of the rail's foot, as its support sees it. All ranks that hold a node have it alike.
  struct RailFoot
  {
    /// Unit vectors in the track frame: across, to the track centre; normal to the base, upwards; along.
    std::array<Vector3, 3>    axes{};
    double                    width = 0; ///< [m]
    std::vector<unsigned int> nodes;     ///< of this rank that do not hang, ascending
    std::vector<double>       area;      ///< that each of them carries of the pieces asked for [m2]
  };

  /// A piece of the foot: between two places along the track [m].
  using FootPiece = std::array<double, 2>;

  /// From one end of the foot to the other. Collective.
  FootPiece
  whole_foot(const LocalMesh &mesh, MPI_Comm communicator);

  /// The foot of a mesh with the area of all `pieces`, ascending and apart from each other, shared out to its
  /// nodes by their trial functions along the track; those of hanging nodes go to their parents. Nodes
  /// without any are left out. Collective.
  RailFoot
  rail_foot(const Solid &solid, const std::vector<FootPiece> &pieces, MPI_Comm communicator);
} // namespace wheelrail
