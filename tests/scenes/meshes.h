#pragma once

// Meshes of idealised bodies on one rank, made of structured blocks of hexahedra.

#include <wheelrail/base/vector3.h>
#include <wheelrail/mesh/local_mesh.h>

#include <array>
#include <functional>
#include <vector>

namespace scenes
{
  using wheelrail::BoundaryFace;
  using wheelrail::LocalMesh;
  using wheelrail::Vector3;

  using Cells     = std::array<unsigned int, 3>;
  using Nodes     = std::vector<unsigned int>;
  using Place     = std::function<Vector3(const Vector3 &)>; ///< from the unit cube to space [m]
  using Predicate = std::function<bool(const Vector3 &)>;    ///< of a reference position [m]

  /// A unit cube divided into cells and mapped to space; the map must keep the orientation.
  struct Block
  {
    Cells cells;
    Place place;
  };

  /// The mesh of all blocks; nodes nearer than a millionth of the mesh's size are one node. `faces` are
  /// the quadrilaterals that belong to one cell only, corners such that (n1 - n0) x (n2 - n0) points
  /// outwards, all marked free. Nodes and cells belong to `body`.
  LocalMesh
  make_mesh(const std::vector<Block> &blocks, wheelrail::Body body = wheelrail::Body::wheel);

  LocalMesh
  box(const Vector3  &low,
      const Vector3  &high,
      const Cells    &cells,
      wheelrail::Body body = wheelrail::Body::wheel);

  /// A box whose coarse cells with centres in `fine` are divided into eight; hanging nodes lie at the
  /// mean of their parents. Vertices of coarse cells inside the box are moved at random by up to
  /// `distortion` of the cells' size in each direction. The faces include those between both levels; those of
  /// divided cells are the finest.
  LocalMesh
  two_level_box(const Vector3   &low,
                const Vector3   &high,
                const Cells     &cells,
                const Predicate &fine,
                double           distortion = 0,
                wheelrail::Body  body       = wheelrail::Body::wheel);

  /// Moves the nodes chosen at random by up to `size` [m] in each direction, always in the same way.
  void
  distort(LocalMesh &mesh, double size, const Predicate &which);

  /// Both meshes in one; nodes and faces of the second are numbered after those of the first.
  LocalMesh
  join(const LocalMesh &first, const LocalMesh &second);

  /// Nodes whose reference position satisfies the predicate.
  Nodes
  select(const LocalMesh &mesh, const Predicate &which);

  /// Faces whose centre satisfies the predicate.
  std::vector<BoundaryFace>
  select_faces(const LocalMesh &mesh, const Predicate &which);

  /// Marks the faces whose centre satisfies the predicate.
  void
  mark_faces(LocalMesh &mesh, wheelrail::Boundary mark, const Predicate &which);

  /// Reference position of a node [m].
  Vector3
  place_of(const LocalMesh &mesh, unsigned int node);

  /// |x[component] - value| below a nanometre: a plane of nodes or faces.
  Predicate
  plane(int component, double value);
} // namespace scenes
