#pragma once

#include <deal.II/grid/tria.h>

#include <wheelrail/mesh/local_mesh.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace wheelrail
{
  class Forest;

  /// The active cells of a rank and the nodes of the finest mesh at all vertices of their ancestors, those
  /// too that only other ranks hold.
  ///
  /// This header brings deal.II's triangulation along: for the coarse levels only.
  class AncestorVertices
  {
  public:
    using Triangulation = dealii::Triangulation<3>;
    using Cell          = Triangulation::cell_iterator;

    /// A node of the finest mesh as one rank knows it and another needs it.
    struct Node
    {
      std::uint32_t         global = 0;
      std::uint64_t         key    = 0;  ///< as LocalMesh::node_key
      std::array<double, 3> reference{}; ///< [m]
      Body                  body      = Body::rail;
      unsigned int          n_parents = 0; ///< not zero: the node hangs
      struct Parent
      {
        std::uint32_t         global;
        std::uint64_t         key;
        double                weight;
        std::array<double, 3> reference; ///< [m]
      };
      std::array<Parent, 4> parents;
    };

    /// `finest` is the local mesh of the forest. Collective.
    AncestorVertices(const Forest &forest, const LocalMesh &finest);

    /// Whether the vertex belongs to a cell of the rank or to an ancestor of one.
    bool
    knows(unsigned int vertex) const;

    /// The node at such a vertex.
    Node
    at(unsigned int vertex) const;

    std::vector<Cell> active; ///< in the order of finest.cells

  private:
    struct Place;
    Node
    node(unsigned int number) const;
    unsigned int
    own_node(const Place &place) const;
    void
    ask_others(MPI_Comm communicator);

    const Triangulation                   &triangulation_;
    const LocalMesh                       &finest_;
    std::vector<std::uint32_t>             local_;  ///< node of each vertex
    std::vector<std::uint32_t>             number_; ///< of each active cell
    std::vector<std::uint32_t>             hangs_;  ///< place of each node in finest.hanging
    std::unordered_map<unsigned int, Node> told_;   ///< vertices that other ranks know
  };
} // namespace wheelrail
