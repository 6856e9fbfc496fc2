#include <wheelrail/solid/boundary_nodes.h>
#include <wheelrail/solid/exchange.h>

#include <set>

// Nodes with boundary conditions: foot, bore, ends, running surface (marks of doc/theory/mesh.md, Sections of
// blocks).

namespace wheelrail
{
  std::vector<unsigned int>
  boundary_nodes(const LocalMesh &mesh, const Boundary mark)
  {
    // ascending: sums over these nodes have one order
    std::set<unsigned int> nodes;
    for (const auto &face : mesh.faces)
      if (face.mark == mark)
        nodes.insert(face.nodes.begin(), face.nodes.end());
    return {nodes.begin(), nodes.end()};
  }


  std::vector<unsigned int>
  held_boundary_nodes(const LocalMesh &mesh, const Boundary mark)
  {
    // A node on the border of ranks may have its marked face on another rank alone: without the sum over
    // ranks one would hold it and the other would move it.
    AlignedVector<double> marked(4 * mesh.n_nodes(), 0.);
    for (const unsigned int n : boundary_nodes(mesh, mark))
      marked[4 * n] = 1;
    sum_over_ranks(mesh, marked.data());
    std::vector<unsigned int> nodes;
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      if (marked[4 * n] > 0)
        nodes.push_back(n);
    return nodes;
  }
} // namespace wheelrail
