#pragma once

#include <wheelrail/geometry/plane.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

namespace wheelrail
{
  constexpr double degree = M_PI / 180; ///< [rad]

  /// What a boundary edge of a section belongs to.
  enum class Boundary : unsigned int
  {
    free    = 0,
    running = 1, ///< rail head or wheel tread: where contact can happen
    foot    = 2, ///< base of the rail foot
    bore    = 3, ///< hub bore of the wheel
    end     = 4  ///< ends of the rail (set by the sweep, not by the section)
  };

  /// A plane cross-section as quadrilateral blocks with straight or curved edges, to be swept along
  /// the track (rail: x = X, y = Y of the track plane) or around the axle (wheel: x = lateral
  /// coordinate along the axle towards the track centre, y = radius).
  struct Section
  {
    /// Corners in lexicographic order: (0,0), (1,0), (0,1), (1,1) of the block coordinates; the
    /// block is right-handed (positive Jacobian).
    struct Block
    {
      std::array<unsigned int, 4> corner;
    };

    /// Key of an edge: its two corners, the smaller number first.
    using EdgeKey = std::array<unsigned int, 2>;

    /// Corners of the edges of a block in deal.II's order of faces: left, right, bottom, top.
    static constexpr unsigned int edge_corners[4][2] = {{0, 2}, {1, 3}, {0, 1}, {2, 3}};

    /// Key of an edge 0 to 3 of a block.
    static EdgeKey
    edge_key(const std::array<unsigned int, 4> &corner, const unsigned int edge)
    {
      const unsigned int a = corner[edge_corners[edge][0]], b = corner[edge_corners[edge][1]];
      return {a < b ? a : b, a < b ? b : a};
    }

    std::vector<Point2> corners; ///< [m]
    std::vector<Block>  blocks;

    /// Points of curved edges, for t from 0 (first corner of the key) to 1; edges not listed are
    /// straight. Neighbouring blocks share an edge, so they match by construction.
    std::map<EdgeKey, std::function<Point2(double)>> curved;

    /// Boundary marks; boundary edges not listed are free.
    std::map<EdgeKey, Boundary> boundary;

    /// Transfinite (Gordon and Hall 1973) position in a block at block coordinates in [0, 1]^2.
    Point2
    position(unsigned int block, double xi, double eta) const;
  };

  /// Quality of a section refined `subdivisions` times per block direction.
  struct SectionQuality
  {
    double area                = 0; ///< of the straight-sided quadrilaterals [m2]
    double min_scaled_jacobian = 1; ///< smallest corner sine over all quadrilaterals, 1 is best
    double min_edge            = 0; ///< [m]
    double max_edge            = 0; ///< [m]
  };

  /// Quality of one block; `subdivisions` is 1 or more.
  SectionQuality
  block_quality(const Section &section, unsigned int block, unsigned int subdivisions);
} // namespace wheelrail
