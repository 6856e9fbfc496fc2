#include <wheelrail/base/gather_all.h>
#include <wheelrail/solid/exchange.h>
#include <wheelrail/track/rail_foot.h>

#include <algorithm>

namespace wheelrail
{
  namespace
  {
    /// Integral of the straight function that is 1 at `one` and 0 at `zero` over the part of a piece between
    /// them [m].
    double
    integral(const double one, const double zero, const FootPiece &piece)
    {
      const double a = std::max(piece[0], std::min(one, zero)), b = std::min(piece[1], std::max(one, zero));
      return b > a ? (b - a) * (zero - 0.5 * (a + b)) / (zero - one) : 0;
    }

  } // namespace


  FootPiece
  whole_foot(const LocalMesh &mesh, MPI_Comm communicator)
  {
    double ends[2] = {1e300, 1e300};
    for (const BoundaryFace &face : mesh.faces)
      if (face.mark == Boundary::foot)
        for (const unsigned int node : face.nodes)
          {
            const double z = mesh.reference[4 * node + 2];
            ends[0]        = std::min(ends[0], z);
            ends[1]        = std::min(ends[1], -z);
          }
    MPI_Allreduce(MPI_IN_PLACE, ends, 2, MPI_DOUBLE, MPI_MIN, communicator);
    return {ends[0], -ends[1]};
  }


  RailFoot
  rail_foot(const Solid &solid, const std::vector<FootPiece> &pieces, MPI_Comm communicator)
  {
    const LocalMesh      &mesh = solid.mesh;
    AlignedVector<double> area(4 * mesh.n_nodes(), 0.);
    Vector3               normal{}; // of all faces, as long as their area
    for (const BoundaryFace &face : mesh.faces)
      if (face.mark == Boundary::foot)
        {
          const std::array<Vector3, 4> X      = mesh.places(face.nodes);
          const Vector3                across = 0.5 * cross(X[3] - X[0], X[2] - X[1]);
          add(normal, across[1] > 0 ? 1 : -1, across);
          // sections stand across the track: two nodes at either end of the face
          const auto [low, high] = std::minmax({X[0][2], X[1][2], X[2][2], X[3][2]});
          const double width     = norm(across) / (high - low);
          for (int a = 0; a < 4; ++a)
            for (const FootPiece &piece : pieces)
              {
                const bool at_low = X[a][2] < 0.5 * (low + high);
                area[4 * face.nodes[a]] += 0.5 * width * integral(X[a][2], at_low ? high : low, piece);
              }
        }
    condense(mesh, area.data());
    sum_over_ranks(mesh, area.data());
    ordered_sum(normal, communicator);
    const FootPiece whole = whole_foot(mesh, communicator);

    RailFoot foot;
    foot.width   = norm(normal) / (whole[1] - whole[0]);
    foot.axes[2] = {0, 0, 1};
    foot.axes[1] = normalised({normal[0], normal[1], 0});
    foot.axes[0] = cross(foot.axes[1], foot.axes[2]);
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      if (area[4 * n] > 0 && solid.mass[n] > 0)
        {
          foot.nodes.push_back(n);
          foot.area.push_back(area[4 * n]);
        }
    return foot;
  }
} // namespace wheelrail
