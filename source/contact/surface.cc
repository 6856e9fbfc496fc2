#include <wheelrail/base/errors.h>
#include <wheelrail/base/gather_all.h>
#include <wheelrail/contact/surface.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

// Lattice of the running surface: nodes by station and row, tributary areas A of the quadrature on the nodes
// (doc/theory/contact.md, doc/theory/mesh.md, The lattice).

namespace wheelrail
{
  namespace
  {
    /// What a rank tells about one lattice node.
    struct Entry
    {
      std::size_t   index;
      std::uint32_t global_node;
      int           owner;
      Vector3       X;
    };

    /// Quarter of the facets around each lattice node.
    void
    add_areas(Surface &surface)
    {
      const Lattice &lattice = surface.lattice;
      surface.area.assign(surface.reference.size(), 0.);
      for (unsigned int i = 0; i + 1 < lattice.n_along; ++i)
        for (unsigned int j = 0; j + 1 < lattice.n_lateral; ++j)
          {
            const std::size_t corner[4] = {lattice.index(i, j),
                                           lattice.index(i + 1, j),
                                           lattice.index(i, j + 1),
                                           lattice.index(i + 1, j + 1)};
            const auto       &X         = surface.reference;
            // area of a facet = |d1 x d2|/2, d1, d2 its diagonals; a quarter to each corner
            const Vector3 diagonal1 = X[corner[3]] - X[corner[0]], diagonal2 = X[corner[2]] - X[corner[1]];
            const double  quarter = norm(cross(diagonal1, diagonal2)) / 8;
            // bilinear hat functions over a parallelogram: the integral of each is a quarter of it [m2]
            for (const auto c : corner)
              surface.area[c] += quarter;
          }
    }
  } // namespace


  Surface
  make_surface(const LocalMesh       &mesh,
               const Body             body,
               const RunningSurfaces &surfaces,
               const Lattice         &lattice,
               MPI_Comm               communicator)
  {
    int rank;
    MPI_Comm_rank(communicator, &rank);
    Surface           surface;
    const std::size_t n = std::size_t(lattice.n_along) * lattice.n_lateral;
    surface.body        = body;
    surface.lattice     = lattice;
    surface.reference.resize(n);
    surface.global_node.resize(n);
    surface.owner.assign(n, -1);
    surface.local.assign(n, -1);

    std::vector<Entry>     own;
    std::set<unsigned int> done;
    for (const auto &face : mesh.faces)
      if (face.body == body && face.mark == Boundary::running && face.finest)
        for (const unsigned int node : face.nodes)
          if (done.insert(node).second)
            {
              const Vector3 X = mesh.place(node);
              // station i = Z (or arc) over the spacing, row j = (s - s_begin) over the spacing
              // (doc/theory/mesh.md, The lattice)
              const auto place = surfaces[body].unmoved(X);
              const long i     = lattice.station(place.along) - lattice.first_station;
              const long j     = std::lround((place.s - lattice.s_begin) / lattice.spacing_lateral);
              if (i < 0 || j < 0 || i >= long(lattice.n_along) || j >= long(lattice.n_lateral))
                continue;
              const std::size_t k = lattice.index(i, j);
              surface.local[k]    = node;
              // several ranks may hold the node: the lowest wins below
              own.push_back({k, mesh.global_node[node], rank, X});
            }
    for (const Entry &entry : gather_all(own, communicator))
      {
        const std::size_t k = entry.index;
        if (surface.owner[k] >= 0 && surface.owner[k] <= entry.owner)
          continue;
        surface.global_node[k] = entry.global_node;
        surface.owner[k]       = entry.owner;
        surface.reference[k]   = entry.X;
      }
    for (std::size_t k = 0; k < n; ++k)
      if (surface.owner[k] < 0)
        throw RunError("the fine zone of the " + std::string(body_name(body)) + " has a hole at station " +
                       std::to_string(k / lattice.n_lateral) + ", row " +
                       std::to_string(k % lattice.n_lateral) + ": choose another coarse cell size");
    // a rank may hold a lattice node as a vertex of coarser or other cells only
    std::vector<std::pair<std::uint32_t, unsigned int>> sorted;
    for (unsigned int node = 0; node < mesh.n_nodes(); ++node)
      sorted.emplace_back(mesh.global_node[node], node);
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t k = 0; k < n; ++k)
      {
        const auto found =
          std::lower_bound(sorted.begin(), sorted.end(), std::make_pair(surface.global_node[k], 0u));
        surface.local[k] =
          found != sorted.end() && found->first == surface.global_node[k] ? int(found->second) : -1;
      }
    add_areas(surface);
    return surface;
  }
} // namespace wheelrail
