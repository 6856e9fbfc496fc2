#pragma once

#include <wheelrail/mesh/curve_stretch.h>
#include <wheelrail/mesh/section.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// A chain of corners of a section that forms one side of a patch.
  using Side = std::vector<unsigned int>;

  /// Part of a chain, from its corner `first` to its corner `last`, both included.
  Side
  part(const Side &side, unsigned int first, unsigned int last);

  /// `a` followed by `b`, the end of `a` being the start of `b`.
  Side
  joined(const Side &a, const Side &b);

  /// Number of columns to be placed between the first two of four bottom points so that the columns
  /// that come down from `top` are bent least (sum of squares of their sideways way), when
  /// `middle` columns stand between the second and the third and each part gets one or more.
  unsigned int
  columns_left(const std::vector<Point2> &top, const std::array<Point2, 4> &bottom, unsigned int middle);

  /// Puts a section together from patches of n x m blocks.
  class SectionBuilder
  {
  public:
    /// Adds a corner and returns its number.
    unsigned int
    corner(const Point2 &p);

    const Point2 &
    point(unsigned int corner) const
    {
      return section_.corners[corner];
    }

    /// Makes the edge from corner a to corner b follow `curve` (t from 0 at a to 1 at b).
    void
    curve(unsigned int a, unsigned int b, std::function<Point2(double)> curve);

    /// Marks the edges of a chain.
    void
    mark(const Side &side, Boundary boundary);

    /// Chain of n edges at equal spacing along a stretch of a profile between two corners that
    /// exist already.
    Side
    along(unsigned int first, unsigned int last, const CurveStretch &stretch, unsigned int n);

    /// Chain of n straight edges at equal spacing between two corners.
    Side
    straight(unsigned int first, unsigned int last, unsigned int n);

    /// Fills the region between four chains (bottom and top from left to right, left and right
    /// from bottom to top) with blocks; corners inside are placed by transfinite interpolation of
    /// the chains. Blocks may be folded until they are smoothed.
    void
    patch(const std::string &name, const Side &bottom, const Side &top, const Side &left, const Side &right);

    /// Smooths the blocks of the finished section (smooth_section) by moving the corners from number
    /// `first` to `last` that lie inside and are not in `fixed`.
    void
    smooth(unsigned int first, unsigned int last, const Side &fixed, double block_size);

    /// Takes sharp turns, such as lips of worn rails, out of the running edges of blocks that would be folded
    /// or nearly so by them: means over as short a part of the edge as serves, its ends kept. Blocks whose
    /// edges are in `exact` stay as they are.
    void
    round_edges(const Side &exact);

    /// Throws RunError when a block is folded, which names the patch.
    void
    check() const;

    /// The section as built so far.
    const Section &
    section() const
    {
      return section_;
    }

  private:
    Section                  section_;
    std::vector<std::string> patch_of_block_;
  };
} // namespace wheelrail
