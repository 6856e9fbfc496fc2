#pragma once

#include <wheelrail/mesh/swept_grid.h>

#include <cstdint>
#include <unordered_set>
#include <vector>

namespace wheelrail
{
  /// Stretches along the track, or around the wheel, where the finest cells lie [m].
  using FineZone = std::vector<Range>;

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
    CellTree(const SweepPlan &plan, const PerBody<SweptGrid> &grids, const PerBody<FineZone> &zones);

    bool
    divided(const CellPlace &cell) const
    {
      return divided_.count(cell.key()) > 0;
    }

    /// The cells that are not divided: rail, then wheel, column by column (from `first_column` on), block by
    /// block, parts of a block in the order of children.
    std::vector<CellPlace>
    leaves(const PerBody<int> &first_column) const;

  private:
    void
    divide(const CellPlace &cell);
    void
    divide_body(const RefinementRule &rule, const SweptGrid &grid);
    void
    balance();

    const PerBody<SweptGrid>           *grids_;
    std::vector<std::vector<CellPlace>> of_level_;
    std::unordered_set<std::uint64_t>   divided_;
  };
} // namespace wheelrail
