#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/parallel.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/mesh/cell_tree.h>
#include <wheelrail/model/moved_cells.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/solid/element_blocks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Where irregularities move nodes on the path, along [m].
    Range
    moved_stretch(const SweepPlan &plan, const Body body)
    {
      Range stretch{HUGE_VAL, -HUGE_VAL};
      for (const Irregularity &one : plan.surfaces[body].irregularities())
        if (one.carried == CarriedBy::mesh)
          stretch = {std::min(stretch.s0, one.begin), std::max(stretch.s1, one.end)};
      if (body == Body::rail)
        stretch = {std::max(stretch.s0, -plan.reach), std::min(stretch.s1, plan.longest_path + plan.reach)};
      return stretch;
    }

    /// The column that holds the contact of the start, and those where nodes are moved.
    std::vector<int>
    columns_on_path(const SweepPlan &plan, const SweptGrid &grid)
    {
      const Range      stretch = moved_stretch(plan, grid.body());
      const double     around  = grid.closed() ? grid.n_columns() * plan.block_length() : 0;
      std::vector<int> columns(1, 0);
      while (!grid.closed() && grid.along(0, columns.front() + 1) <= 0)
        ++columns.front();
      for (int k = 0; k < grid.n_columns(); ++k)
        {
          const double a = grid.along(0, k), b = grid.along(0, k + 1);
          double       apart = 0.5 * (a + b) - 0.5 * (stretch.s0 + stretch.s1);
          if (around > 0)
            apart = std::remainder(apart, around);
          if (std::abs(apart) < 0.5 * (stretch.s1 - stretch.s0 + std::abs(b - a)))
            columns.push_back(k);
        }
      return columns;
    }

    /// A part of the strip with finest cells, and the blocks of the path from whose windows it is taken.
    struct PartOfStrip
    {
      Range across;
      int   first, last;
    };

    std::vector<PartOfStrip>
    parts_of_strip(const SweepPlan &plan)
    {
      std::vector<PartOfStrip> parts;
      for (std::size_t k = 0; k < plan.across.size(); ++k)
        {
          const Range &across = plan.across[k];
          const int    block  = static_cast<int>(k);
          if (!parts.empty() && parts.back().across.s0 == across.s0 && parts.back().across.s1 == across.s1)
            parts.back().last = block;
          else
            parts.push_back({across, block, block});
        }
      if (parts.empty())
        parts.push_back({plan.whole_strip(), 0, 0});
      return parts;
    }

    /// The columns that windows on a part of the strip reach; the first one, of the start, is always among
    /// them.
    std::vector<int>
    columns_of_part(const SweepPlan        &plan,
                    const Body              body,
                    const std::vector<int> &columns,
                    const PartOfStrip      &part)
    {
      if (plan.across.empty() || body == Body::wheel)
        return columns;
      const Range &around = plan.around_block;
      const int beyond = static_cast<int>(std::ceil(std::max(-around.s0, around.s1) / plan.block_length()));
      std::vector<int> reached;
      for (const int column : columns)
        if (const int block = column - columns.front();
            block == 0 || (block >= part.first - beyond && block <= part.last + beyond))
          reached.push_back(column);
      return reached;
    }

    /// Cells of a column that lies within the finest ones with all its neighbours along.
    std::vector<CellPlace>
    cells_of_column(const SweepPlan          &plan,
                    const PerBody<SweptGrid> &grids,
                    const Body                body,
                    const int                 column,
                    const Range              &across)
    {
      const double      beside = 3 * plan.block_length(), begin = grids[body].along(0, column);
      PerBody<FineZone> zones;
      zones[body] = {{Range{begin - beside, begin + beside}, across}};
      PerBody<std::set<int>> columns;
      columns[body] = {column};
      const RefinementRule   rule(plan, grids, zones);
      const CellTree         tree(rule, grids, columns);
      std::vector<CellPlace> cells;
      const auto             collect = [&](const auto &self, const CellPlace &cell) -> void {
        if (!tree.divided(cell))
          cells.push_back(cell);
        else
          for (unsigned int c = 0; c < 8; ++c)
            self(self, cell.child(c));
      };
      CellPlace block;
      block.body = body;
      block.k    = column;
      for (block.block = 0; block.block < grids[body].n_blocks(); ++block.block)
        collect(collect, block);
      return cells;
    }

    struct Stiffest
    {
      double                 bound = 0; ///< omega^2 [1/s2]
      std::array<Vector3, 8> at{};      ///< its vertices [m]
    };

    Stiffest
    stiffest(const SweptGrid              &grid,
             const std::vector<CellPlace> &cells,
             const int                     farther, ///< by columns
             const Elasticity             &steel)
    {
      Stiffest most;
      for (CellPlace cell : cells)
        {
          cell.k += farther * (1 << cell.level);
          std::array<Vector3, 8> X;
          for (unsigned int v = 0; v < 8; ++v)
            X[v] = grid.position(cell, v);
          if (const double bound = element_frequency_bound(element_geometry(X), steel); bound > most.bound)
            most = {bound, X};
        }
      return most;
    }
  } // namespace


  StableStep
  step_on_path(const Scene &scene, const SweepPlan &plan)
  {
    const PerBody<Elasticity> steel{elasticity(scene.rail_material), elasticity(scene.wheel_material)};
    const double              highest = highest_frequency(scene);
    const PerBody<SweptGrid>  grids{SweptGrid(plan, Body::rail), SweptGrid(plan, Body::wheel)};
    StableStep                stable;
    double                    largest = 0;
    for (const Body body : both_bodies)
      {
        const std::vector<int> on_path = columns_on_path(plan, grids[body]);
        for (const PartOfStrip &part : parts_of_strip(plan))
          {
            const std::vector<int>       columns = columns_of_part(plan, body, on_path, part);
            const std::vector<CellPlace> cells =
              cells_of_column(plan, grids, body, columns.front(), part.across);
            std::vector<Stiffest> found(columns.size());
            const auto            look = [&](const std::size_t n) {
              found[n] = stiffest(grids[body], cells, columns[n] - columns.front(), steel[body]);
            };
            look(0); // finds the places of the section, which all columns have
            parallel_for(columns.size() - 1, [&](const std::size_t n) { look(n + 1); });
            for (const Stiffest &one : found)
              if (one.bound > largest)
                {
                  largest       = one.bound;
                  stable.body   = body;
                  stable.length = std::cbrt(element_geometry(one.at).volume);
                  stable.place  = {};
                  for (const Vector3 &X : one.at)
                    add(stable.place, 1. / 8, X);
                }
          }
      }
    stable.scaled = largest > highest;
    stable.step   = stable_step(std::min(largest, highest), scene.bulk_viscosity);
    return stable;
  }


  void
  lower_step_to_path(const Scene &scene, const SweepPlan &plan, const double at_start, StableStep &stable)
  {
    const auto moves_nodes = [&plan](const Body body) {
      const Range stretch = moved_stretch(plan, body);
      return stretch.s0 < stretch.s1;
    };
    if (std::none_of(both_bodies.begin(), both_bodies.end(), moves_nodes))
      return;
    constexpr double even    = 1 - 1e-3;
    const StableStep on_path = step_on_path(scene, plan);
    const double     shorter = on_path.step / at_start;
    if (shorter > even)
      return;
    stable.step *= shorter;
    stable.scaled = on_path.scaled;
    stable.body   = on_path.body;
    stable.length = on_path.length;
    stable.place  = on_path.place;
  }


  void
  check_added_mass(const Scene &scene, const MeshQuality &quality)
  {
    constexpr double most = 1e-3;
    for (const Body body : both_bodies)
      if (quality.scaled_share[body] > most)
        throw InputError(entry_text(scene, "Mesh", "Mass scaling") + ": it would add " +
                         text("%.2g", 100 * quality.scaled_share[body]) + " % to the mass of the " +
                         body_name(body) +
                         ", and 0.1 % is accepted; leave it out, or take a smaller Mesh/Solution cell size");
  }
} // namespace wheelrail
