#pragma once

#include <wheelrail/mesh/swept_grid.h>

#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_set>
#include <vector>

namespace wheelrail
{
  /// Where finest cells lie [m]: a stretch along the track, or around the wheel, and a part of the strip.
  struct FineBox
  {
    FineBox(const Range &along, const Range &across = {-HUGE_VAL, HUGE_VAL})
      : along(along)
      , across(across)
    {
    }

    Range along, across;
  };

  using FineZone = std::vector<FineBox>;

  /// Which cells are divided for what lies in them, neighbours apart: all that overlap the box below the
  /// strip, wherever its zones are, down to the finest level. Cells beside it grow with the distance, and are
  /// not divided where the blocks are so thin that their parts would be thinner than the finest cells: those
  /// alone should govern the stable time step.
  class RefinementRule
  {
  public:
    /// Plan, grids and zones must outlive the rule.
    RefinementRule(const SweepPlan &plan, const PerBody<SweptGrid> &grids, const PerBody<FineZone> &zones);

    /// Whether a cell below the finest level is divided.
    bool
    wanted(const CellPlace &cell) const;

    /// Into how many cells one is divided.
    int
    n_parts(const CellPlace &cell) const;

  private:
    const SweepPlan          *plan_;
    const PerBody<SweptGrid> *grids_;
    const PerBody<FineZone>  *zones_;
    double                    finest_; ///< size of the finest cells [m]
  };

  /// The cells that follow from the rule, with neighbours, also over edges and corners, that differ by one
  /// level at most.
  class CellTree
  {
  public:
    /// Those of some columns of coarse blocks alone, so that no rank holds those of the whole mesh. A cell
    /// makes others divide in blocks that touch its own and in none beyond, since these would be divided for
    /// ancestors that reach from it to there: a column beside each of those is looked at.
    CellTree(const RefinementRule         &rule,
             const PerBody<SweptGrid>     &grids,
             const PerBody<std::set<int>> &columns);

    bool
    divided(const CellPlace &cell) const
    {
      return divided_.count(cell.key()) > 0;
    }

  private:
    void
    divide(const CellPlace &cell);
    void
    divide_body(const RefinementRule &rule, const SweptGrid &grid, const std::set<int> &columns);
    void
    balance();

    const PerBody<SweptGrid>           *grids_;
    std::vector<std::vector<CellPlace>> of_level_;
    std::unordered_set<std::uint64_t>   divided_;
  };
} // namespace wheelrail
