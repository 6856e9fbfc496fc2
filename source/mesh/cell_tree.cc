#include <wheelrail/mesh/cell_tree.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelrail
{
  namespace
  {
    /// Distance of the stretch [a, b] from a range; around a closed body of length `around` (0: not closed).
    double
    distance_along(const Range &range, const double a, const double b, const double around)
    {
      const double middle = 0.5 * (range.s0 + range.s1), own = 0.5 * (a + b);
      const double shift = around > 0 ? around * std::round((middle - own) / around) : 0;
      return std::max(a + shift - range.s1, range.s0 - b - shift);
    }
  } // namespace


  RefinementRule::RefinementRule(const SweepPlan          &plan,
                                 const PerBody<SweptGrid> &grids,
                                 const PerBody<FineZone>  &zones)
    : plan_(&plan)
    , grids_(&grids)
    , zones_(&zones)
    , finest_((plan.strip.s.back() - plan.strip.s.front()) / (plan.strip.s.size() - 1) /
              std::pow(2., plan.levels))
  {
  }


  bool
  RefinementRule::wanted(const CellPlace &cell) const
  {
    const SweptGrid &grid    = (*grids_)[cell.body];
    const double     overlap = -1e-3 * finest_; // distances below count as overlap with the box
    // cells of 2^k finest sizes may reach up to 4 (2^k - 1) finest sizes from the finest ones
    const unsigned int k     = plan_->levels - cell.level - 1;
    const double       reach = 4 * finest_ * (std::pow(2., k) - 1) - 1e-3 * finest_;
    const auto   ends     = std::minmax({grid.along(cell.level, cell.k), grid.along(cell.level, cell.k + 1)});
    const double around   = grid.closed() ? grid.n_columns() * plan_->block_length() : 0.;
    double       distance = std::numeric_limits<double>::max();
    for (const FineBox &box : (*zones_)[cell.body])
      if (const double along = distance_along(box.along, ends.first, ends.second, around); along < reach)
        distance = std::min(distance, std::max(along, grid.section_distance(cell, box.across)));
    // a cell beside the box is not divided when its parts would be thinner than the finest cells
    // and so cut the stable time step (0.95: tests/stable_step.cc finds no thinner ones in the box), or
    // thinner than 0.6 of the wanted size: the whole, at most 1.2 of it, is then nearer
    const double thinnest = finest_ * std::max(0.95, 0.6 * std::pow(2., k));
    return distance < reach && (distance < overlap || 0.5 * grid.width(cell) > thinnest);
  }


  CellTree::CellTree(const RefinementRule         &rule,
                     const PerBody<SweptGrid>     &grids,
                     const PerBody<std::set<int>> &columns)
    : grids_(&grids)
    , of_level_(grids.rail.levels())
  {
    for (const Body body : both_bodies)
      divide_body(rule, grids[body], columns[body]);
    balance();
  }


  int
  RefinementRule::n_parts(const CellPlace &cell) const
  {
    if (cell.level == plan_->levels || !wanted(cell))
      return 1;
    int n = 0;
    for (unsigned int c = 0; c < 8; ++c)
      n += n_parts(cell.child(c));
    return n;
  }


  void
  CellTree::divide(const CellPlace &cell)
  {
    if (divided_.insert(cell.key()).second)
      of_level_[cell.level].push_back(cell);
  }


  void
  CellTree::divide_body(const RefinementRule &rule, const SweptGrid &grid, const std::set<int> &columns)
  {
    if (grid.levels() == 0)
      return;
    std::vector<CellPlace> divided, next;
    CellPlace              coarse;
    coarse.body = grid.body();
    std::set<int> looked_at;
    for (const int column : columns)
      for (int k = column - 1; k <= column + 1; ++k)
        if (grid.closed() || (k >= 0 && k < grid.n_columns()))
          looked_at.insert((k + grid.n_columns()) % grid.n_columns());
    for (const int column : looked_at)
      for (coarse.k = column, coarse.block = 0; coarse.block < grid.n_blocks(); ++coarse.block)
        if (rule.wanted(coarse))
          divided.push_back(coarse);
    for (unsigned int level = 0; !divided.empty(); ++level)
      {
        next.clear();
        for (const CellPlace &cell : divided)
          {
            divide(cell);
            if (level + 1 < grid.levels())
              for (unsigned int c = 0; c < 8; ++c)
                if (rule.wanted(cell.child(c)))
                  next.push_back(cell.child(c));
          }
        divided.swap(next);
      }
  }


  /// All cells that touch a divided one are of its level or finer: their parents are divided, too.
  void
  CellTree::balance()
  {
    for (unsigned int level = of_level_.size(); level-- > 1;)
      for (std::size_t n = 0; n < of_level_[level].size(); ++n)
        {
          const CellPlace  cell   = of_level_[level][n];
          const SweptGrid &grid   = (*grids_)[cell.body];
          const int        around = grid.n_columns() << level;
          for (unsigned int v = 0; v < 4; ++v)
            for (const auto &beside : grid.touching(level, cell.block, cell.i + (v & 1), cell.j + (v >> 1)))
              for (int k = cell.k - 1; k <= cell.k + 1; ++k)
                {
                  if (!grid.closed() && (k < 0 || k >= around))
                    continue;
                  CellPlace other = cell;
                  other.block     = beside.block;
                  other.i         = static_cast<unsigned short>(beside.i);
                  other.j         = static_cast<unsigned short>(beside.j);
                  other.k         = (k + around) % around;
                  divide(other.ancestor(static_cast<unsigned char>(level - 1)));
                }
        }
  }
} // namespace wheelrail
