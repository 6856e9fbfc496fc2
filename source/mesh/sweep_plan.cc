#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/mesh/rail_section.h>
#include <wheelrail/mesh/sweep_plan.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Lengths of blocks that fill a stretch [m] beside blocks of the length `spacing`: one, where there is
    /// only room for one, else growing ones.
    std::vector<double>
    growing_blocks(const double stretch, const double spacing)
    {
      constexpr double growth = 1.25, longest = 4;
      if (stretch < 2 * spacing)
        return {stretch};
      std::vector<double> lengths;
      double              sum = 0;
      for (double length = spacing; sum < stretch; sum += length)
        {
          length = std::min(growth * length, longest * spacing);
          lengths.push_back(length);
        }
      for (double &length : lengths)
        length *= stretch / sum;
      return lengths;
    }

    /// Borders of even blocks along the rail [m], in multiples of the spacing: first and last.
    struct EvenBlocks
    {
      long first, last;
    };

    /// The wheel's spacing over the range that is needed and `onward` beyond, two blocks at least, as far as
    /// the rail goes. There must be room for starts up to `start` blocks farther along.
    EvenBlocks
    even_blocks(const Range &rail,
                const Range &needed,
                const double spacing,
                const double onward,
                const int    start)
    {
      const double     beyond = std::max(onward, 2 * spacing);
      const auto       up     = [&](const double z) { return static_cast<long>(std::ceil(z / spacing)); };
      const auto       down   = [&](const double z) { return static_cast<long>(std::floor(z / spacing)); };
      const EvenBlocks even{up(std::max(needed.s0 - beyond, rail.s0 + spacing)),
                            down(std::min(needed.s1 + beyond, rail.s1 - spacing))};
      const long       first = down(needed.s0) - 1, last = up(needed.s1) + 1 + start;
      if (first < even.first || last > even.last)
        throw InputError(
          "Track/Rail length is too short: the rolled stretch with its fine cells reaches from " +
          in_mm(first * spacing) + " to " + in_mm(last * spacing) + ", the rail from " + in_mm(rail.s0) +
          " to " + in_mm(rail.s1) + "; take a longer rail or a shorter Run/Rolling distance");
      return even;
    }

    std::vector<double>
    rail_stations(const Range &rail, const EvenBlocks &even, const double spacing)
    {
      std::vector<double> stations;
      for (long k = even.first; k <= even.last; ++k)
        stations.push_back(k * spacing);
      std::vector<double> before;
      double              z = stations.front();
      for (const double length : growing_blocks(stations.front() - rail.s0, spacing))
        before.push_back(z -= length);
      z = stations.back();
      for (const double length : growing_blocks(rail.s1 - stations.back(), spacing))
        stations.push_back(z += length);
      stations.insert(stations.begin(), before.rbegin(), before.rend());
      stations.front() = rail.s0;
      stations.back()  = rail.s1;
      return stations;
    }

    /// Turns the blocks of a section so that opposite edges point the same way, which deal.II wants
    /// of a mesh; keeps them right-handed.
    void
    orient_blocks(Section &section)
    {
      std::vector<dealii::CellData<2>> cells(section.blocks.size());
      for (std::size_t b = 0; b < cells.size(); ++b)
        for (unsigned int v = 0; v < 4; ++v)
          cells[b].vertices[v] = section.blocks[b].corner[v];
      dealii::GridTools::consistently_order_cells(cells);
      for (std::size_t b = 0; b < cells.size(); ++b)
        {
          auto &corner = section.blocks[b].corner;
          for (unsigned int v = 0; v < 4; ++v)
            corner[v] = cells[b].vertices[v];
          const Point2 x = section.corners[corner[1]] - section.corners[corner[0]];
          const Point2 y = section.corners[corner[2]] - section.corners[corner[0]];
          if (cross(x, y) < 0)
            std::swap(corner[1], corner[2]);
        }
    }

    /// Both running surfaces over the strip and a cell beside it, as far as the profiles go.
    RunningSurfaces
    surfaces_of_strip(const TouchingProfiles &profiles, const FineStrip &strip, const double cell)
    {
      const FrameProfile &rail = profiles.rail_heights(), &wheel = profiles.wheel_heights(),
                         &tread = profiles.surfaces.wheel.profile();
      const double    s0 = std::max({strip.s.front() - cell, rail.s_min(), wheel.s_min(), tread.s_min()});
      const double    s1 = std::min({strip.s.back() + cell, rail.s_max(), wheel.s_max(), tread.s_max()});
      RunningSurfaces surfaces = profiles.surfaces;
      surfaces.tabulate(s0, s1);
      return surfaces;
    }

    /// Where the finest cells lie across while the contact is in each block of the path: over the overlaps in
    /// it and in the block on either side, and `margin` beside them, in pairs of cells.
    std::vector<Range>
    across_of_blocks(const SweepPlan &plan, const SweepSizes &sizes, const double margin)
    {
      constexpr std::size_t narrow = 4; // blocks
      const std::size_t     blocks = plan.strip.s.size() - 1;
      std::vector<Range>    across;
      if (!sizes.moving || sizes.overlaps.empty() || blocks <= narrow)
        return across;
      const double spacing = plan.block_length();
      const Range  strip   = plan.whole_strip();
      const double pair    = 2 * (strip.s1 - strip.s0) / (double(blocks) * (1 << plan.levels));
      for (int k = 0; k * spacing < sizes.distance + spacing; ++k)
        {
          Range hull{HUGE_VAL, -HUGE_VAL};
          for (const OverlapAt &one : sizes.overlaps)
            if (one.place >= (k - 1) * spacing && one.place <= (k + 2) * spacing)
              hull = {std::min(hull.s0, one.across.s0), std::max(hull.s1, one.across.s1)};
          if (hull.s1 > hull.s0)
            across.push_back(
              {std::max(strip.s0, strip.s0 + pair * std::floor((hull.s0 - margin - strip.s0) / pair)),
               std::min(strip.s1, strip.s0 + pair * std::ceil((hull.s1 + margin - strip.s0) / pair))});
          else
            across.push_back(strip);
        }
      return across;
    }
  } // namespace


  double
  SweepPlan::block_length() const
  {
    return 2 * M_PI * surfaces.rolling_radius / sectors;
  }


  SweepPlan
  make_sweep_plan(const TouchingProfiles &profiles, const WheelDimensions &wheel, const SweepSizes &sizes)
  {
    const ContactGeometry &contact = profiles.contact;
    SweepPlan              plan;
    plan.levels                       = mesh_levels(sizes.cell, sizes.coarse);
    const double        block         = sizes.cell * std::pow(2., plan.levels);
    const FrameProfile &wheel_heights = profiles.wheel_heights(), &rail_heights = profiles.rail_heights();
    plan.strip =
      sizes.strip.s1 > sizes.strip.s0
        ? fine_strip_over(contact.frame, wheel_heights, rail_heights, sizes.strip, block)
        : make_fine_strip(
            contact, wheel_heights, rail_heights, sizes.approach, sizes.fine_margin, block, sizes.across);
    plan.surfaces = surfaces_of_strip(profiles, plan.strip, sizes.cell);

    plan.sectors             = blocks_around(contact.rolling_radius, sizes.cell, sizes.coarse);
    const double     spacing = plan.block_length();
    const bool       impacts = profiles.surfaces.irregular();
    const double     part    = impacts ? 1 : kik_piotrowski;
    const Range      start   = overlap_along(profiles, part * sizes.approach, sizes.fine_margin);
    const Range      overlap{std::min(start.s0, sizes.along.s0), std::max(start.s1, sizes.along.s1)};
    constexpr double free_rail = 0.1;
    // pressure must not come to the outer two stations (Contact::at_border()), and stations lie up to a cell
    // within the stretch that is wanted
    const double margin = std::max(sizes.fine_margin, 3 * sizes.cell);
    plan.reach          = std::max(-overlap.s0, overlap.s1) + margin;
    // of cells that move over irregular surfaces, at least
    constexpr double ahead = 7.5e-3, behind = 12.5e-3;
    plan.around_block    = {overlap.s0 - std::max(impacts ? behind : 0, margin),
                            spacing + overlap.s1 + std::max(impacts ? ahead : 0, margin)};
    plan.fine            = {sizes.ahead.s0 - plan.reach, sizes.distance + sizes.ahead.s1 + plan.reach};
    plan.fine_depth      = sizes.fine_depth;
    const Range rail     = {0.5 * (sizes.distance - sizes.rail_length),
                            0.5 * (sizes.distance + sizes.rail_length)};
    plan.start_block     = static_cast<int>(std::lround(sizes.start / spacing));
    const auto even      = even_blocks(rail, plan.fine, spacing, sizes.onward, plan.start_block);
    plan.rail_stations   = rail_stations(rail, even, spacing);
    const double farther = plan.start_block * spacing;
    for (double &station : plan.rail_stations)
      station -= farther;
    plan.longest_path = std::max(
      sizes.distance,
      std::min((even.last - 1) * spacing - plan.reach, rail.s1 - std::max(free_rail, 3 * spacing)) - farther);
    plan.moving = sizes.moving;
    plan.across = across_of_blocks(plan, sizes, margin);
    if (plan.moving)
      plan.fine.s1 = std::min(plan.fine.s1, plan.around_block.s1);

    plan.rail = make_rail_section(profiles.rail, contact.rail, plan.strip, block);
    plan.wheel =
      make_wheel_section(profiles.wheel, wheel, contact.wheel, {contact.tread_frame, plan.strip.s}, block);
    orient_blocks(plan.rail);
    orient_blocks(plan.wheel);
    return plan;
  }
} // namespace wheelrail
