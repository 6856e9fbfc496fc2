#pragma once

#include <wheelrail/base/body.h>
#include <wheelrail/base/vector3.h>
#include <wheelrail/mesh/cell_place.h>
#include <wheelrail/mesh/sweep_plan.h>

#include <array>
#include <cstdint>
#include <vector>

namespace wheelrail
{
  /// One body of a sweep plan, divided down to its finest cells: numbers and places of all points that a
  /// vertex can have, and what refinement asks of a cell. Places come from the exact section.
  ///
  /// Columns are the coarse blocks along the track or around the wheel; stations count the finest cells
  /// along, 2^levels in a column. The wheel is closed: its last station is the first one.
  class SweptGrid
  {
  public:
    SweptGrid(const SweepPlan &plan, Body body);

    Body
    body() const
    {
      return body_;
    }
    unsigned int
    levels() const
    {
      return plan_->levels;
    }
    int
    n_blocks() const
    {
      return static_cast<int>(section().blocks.size());
    }
    int
    n_columns() const
    {
      return n_columns_;
    }
    bool
    closed() const
    {
      return body_ == Body::wheel;
    }

    /// Corners of the section's blocks, which come first among its points.
    unsigned int
    n_corners() const
    {
      return first_edge_point_;
    }
    /// Those of one block, in the order of Section::Block.
    const std::array<unsigned int, 4> &
    corners(const int block) const
    {
      return section().blocks[block].corner;
    }
    /// Sections between the coarse blocks along the body: one more than columns, but on the closed wheel.
    int
    n_sections() const
    {
      return n_columns_ + !closed();
    }
    /// Corner and section of a node of the coarse blocks, by its key.
    unsigned int
    corner_of_key(const std::uint64_t key) const
    {
      return key >> 24 & 0x3fffffffff;
    }
    int
    section_of_key(const std::uint64_t key) const
    {
      return static_cast<int>(key & 0xffffff) / parts_;
    }

    /// Directions in which all sections look alike: those of the track for the rail; along the axle, outwards
    /// and around for the section of a wheel.
    std::array<Vector3, 3>
    axes(int section) const;

    /// Reference positions [m] of a coarse block's vertices, lexicographic.
    std::array<Vector3, 8>
    coarse_vertices(int block, int column) const;

    /// Number of a point of the section: place (i, j) of the finest lattice of a block, 0 to 2^levels. Blocks
    /// that share an edge or a corner share its points.
    std::uint32_t
    point(int block, int i, int j) const;

    /// Unique key of a vertex of either body.
    std::uint64_t
    vertex_key(int block, int i, int j, int station) const;

    /// Reference position of that vertex [m], before hanging vertices are averaged.
    Vector3
    position(int block, int i, int j, int station) const;

    /// The same of a cell's vertex, lexicographic.
    std::uint64_t
    vertex_key(const CellPlace &cell, unsigned int v) const;
    Vector3
    position(const CellPlace &cell, unsigned int v) const;

    /// Distance of a cell from the box of finest cells in the section: the larger of those across, from the
    /// part of the strip in `across`, and in depth; negative inside [m].
    double
    section_distance(const CellPlace &cell, const Range &across) const;

    /// Smallest stretch of the unit cube onto a cell [m]: the edge of a cube, the thickness of a flat or
    /// skewed cell. The stable time step is in proportion to it.
    double
    width(const CellPlace &cell) const;

    /// Z, or the arc coordinate, of a border between cells of a level [m]; on the wheel it falls with k.
    double
    along(unsigned int level, int k) const;

    /// What the edge of a block belongs to; edges in the order left, right, bottom, top.
    Boundary
    mark(int block, unsigned int edge) const
    {
      return marks_[block][edge];
    }

    /// Whether a block lies below the strip of finest cells.
    bool
    in_strip(int block) const;

    /// The cells of the section that touch the place (i, j) of a block's lattice of `level`.
    struct SectionCell
    {
      int block, i, j;
    };
    std::vector<SectionCell>
    touching(unsigned int level, int block, int i, int j) const;

  private:
    struct Measures
    {
      Range  across;
      double depth = 0, width = -1;
    };
    const Section &
    section() const
    {
      return body_ == Body::rail ? plan_->rail : plan_->wheel;
    }
    Point2
    place(int block, int i, int j) const;
    Vector3
    at_station(const Point2 &p, int station) const;
    const Measures &
    measures(const CellPlace &cell) const;

    /// A block beside an edge or a corner of another one, and which of its own it is.
    struct Neighbour
    {
      int          block;
      unsigned int own;
    };

    const SweepPlan                          *plan_;
    Body                                      body_;
    int                                       n_columns_, parts_;
    bool                                      moved_; ///< by irregularities of the surface
    std::uint32_t                             first_edge_point_, first_inner_point_;
    std::vector<std::array<std::uint32_t, 4>> edges_; ///< of each block
    std::vector<std::array<Boundary, 4>>      marks_;
    std::vector<std::vector<Neighbour>>       at_corner_, at_edge_;
    // found when first asked for: fine ones are needed near the strip alone
    mutable std::vector<Point2>                             places_;       ///< on edges of blocks
    mutable std::vector<std::vector<Point2>>                inner_places_; ///< of each block
    mutable std::vector<std::vector<std::vector<Measures>>> measures_;     ///< of each level and block
  };
} // namespace wheelrail
