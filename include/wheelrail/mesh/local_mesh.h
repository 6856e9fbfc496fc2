#pragma once

#include <wheelrail/base/body.h>
#include <wheelrail/base/simd.h>
#include <wheelrail/base/vector3.h>
#include <wheelrail/mesh/section.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace dealii::Utilities::MPI
{
  class Partitioner;
}

namespace wheelrail
{
  /// A quadrilateral of the boundary that one rank holds.
  struct BoundaryFace
  {
    std::array<unsigned int, 4> nodes; ///< local, lexicographic
    Boundary                    mark;
    Body                        body;
    unsigned int                cell = 0;      ///< that it belongs to
    bool                        finest;        ///< belongs to a cell of the finest level
    bool                        strip = false; ///< of a block below the strip where contact can happen
  };

  /// The vector that the first three of a node's four numbers are.
  inline Vector3
  vector_at(const AlignedVector<double> &values, const std::size_t node)
  {
    return {values[4 * node], values[4 * node + 1], values[4 * node + 2]};
  }

  /// The nodes and cells of one rank as plain arrays: everything the explicit solver needs of a mesh.
  ///
  /// Local nodes are the vertices of the rank's own cells and the parents of its hanging nodes: those that
  /// the rank owns, then those of other ranks, both with ascending numbers over all ranks, as a ghosted
  /// vector of deal.II has them. Every rank that holds a node integrates it, with the same sums, so that no
  /// state is sent.
  struct LocalMesh
  {
    std::vector<std::uint32_t> global_node; ///< n_nodes, number over all ranks that this mesh alone gives
    unsigned int               n_owned = 0;
    /// Of four numbers a node; see share_nodes().
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner;
    AlignedVector<double>
                      reference; ///< 4 x n_nodes: X, Y, Z, 0 [m], hanging nodes at the mean of their parents
    std::vector<Body> node_body;

    std::vector<std::array<unsigned int, 8>> cells; ///< local nodes, lexicographic
    std::vector<Body>                        cell_body;
    std::vector<unsigned char>               cell_level;

    /// What cells and nodes are known by from mesh to mesh, from rank to rank and in files, see
    /// CellPlace::key() and SweptGrid::vertex_key().
    std::vector<std::uint64_t> cell_key, node_key;

    /// Hanging nodes: value of node hanging[k] = sum of weight x value over
    /// parents[hanging_begin[k] .. hanging_begin[k + 1]).
    std::vector<unsigned int> hanging, hanging_begin, parents;
    std::vector<double>       weights;

    std::vector<BoundaryFace> faces;

    std::size_t
    n_nodes() const
    {
      return global_node.size();
    }

    bool
    owns(const std::size_t node) const
    {
      return node < n_owned;
    }

    /// Reference place of a node [m].
    Vector3
    place(const std::size_t node) const
    {
      return vector_at(reference, node);
    }

    /// Those of the corners of a cell, or a face.
    template <std::size_t n>
    std::array<Vector3, n>
    places(const std::array<unsigned int, n> &nodes) const
    {
      std::array<Vector3, n> X;
      for (std::size_t a = 0; a < n; ++a)
        X[a] = place(nodes[a]);
      return X;
    }

    /// A number from -1 to 1 for a component of a node that looks like chance, alike on every partition.
    double
    noise(const std::size_t node, const unsigned int component) const
    {
      return (3 * node_key[node] + component) * 2654435761u % 1000003u / 500001.5 - 1;
    }
  };
} // namespace wheelrail
