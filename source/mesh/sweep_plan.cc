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
    /// Block borders along the rail: the wheel's spacing where it rolls, stretched to the given ends
    /// elsewhere.
    std::vector<double>
    rail_stations(const double begin,
                  const double end,
                  const double fine_begin,
                  const double fine_end,
                  const double spacing)
    {
      const long first = static_cast<long>(std::floor(fine_begin / spacing)) - 1;
      const long last  = static_cast<long>(std::ceil(fine_end / spacing)) + 1;
      if (first * spacing < begin + spacing || last * spacing > end - spacing)
        throw InputError(
          "Track/Rail length is too short: the rolled stretch with its fine cells reaches from " +
          in_mm(first * spacing) + " to " + in_mm(last * spacing) + ", the rail from " + in_mm(begin) +
          " to " + in_mm(end) + "; take a longer rail or a shorter Run/Rolling distance");
      std::vector<double> stations;
      const auto          fill = [&](const double from, const double to) {
        const int n = std::max(1, static_cast<int>(std::lround((to - from) / spacing)));
        for (int k = 0; k < n; ++k)
          stations.push_back(from + (to - from) * k / n);
      };
      fill(begin, first * spacing);
      for (long k = first; k < last; ++k)
        stations.push_back(k * spacing);
      fill(last * spacing, end);
      stations.push_back(end);
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
    surfaces_of_strip(const TouchingProfiles &profiles,
                      const FineStrip        &strip,
                      const double            nominal_radius,
                      const double            cell)
    {
      const FrameProfile &rail = profiles.rail_heights, &wheel = profiles.wheel_heights;
      const double        s0 = std::max({strip.s.front() - cell, rail.s_min(), wheel.s_min()});
      const double        s1 = std::min({strip.s.back() + cell, rail.s_max(), wheel.s_max()});
      RunningSurfaces     surfaces;
      surfaces.frame           = profiles.contact.frame;
      surfaces.rail            = HeightTable(rail, s0, s1);
      surfaces.wheel           = HeightTable(wheel, s0, s1);
      surfaces.wheel_placement = profiles.contact.wheel;
      surfaces.nominal_radius  = nominal_radius;
      surfaces.rolling_radius  = profiles.contact.rolling_radius;
      return surfaces;
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
    plan.levels        = std::max(0L, std::lround(std::log2(sizes.coarse / sizes.cell)));
    const double block = sizes.cell * std::pow(2., plan.levels);
    plan.strip         = make_fine_strip(
      contact, profiles.wheel_heights, profiles.rail_heights, sizes.approach, sizes.fine_margin, block);
    plan.surfaces = surfaces_of_strip(profiles, plan.strip, wheel.nominal_radius, sizes.cell);

    plan.sectors        = std::lround(2 * M_PI * contact.rolling_radius / block);
    const double reach  = half_length_bound(sizes.approach, contact.rolling_radius) + sizes.fine_margin;
    plan.moving         = sizes.moving;
    plan.fine_begin     = -reach;
    plan.fine_end       = sizes.distance + reach;
    plan.fine_depth     = sizes.fine_depth;
    const double middle = 0.5 * sizes.distance;
    plan.rail_stations  = rail_stations(middle - 0.5 * sizes.rail_length,
                                       middle + 0.5 * sizes.rail_length,
                                       plan.fine_begin - (sizes.moving ? plan.block_length() : 0),
                                       plan.fine_end + (sizes.moving ? plan.block_length() : 0),
                                       plan.block_length());
    if (sizes.moving)
      {
        constexpr double least_ahead = 7.5e-3, least_behind = 12.5e-3;
        plan.fine_begin -= std::max(0., least_behind - sizes.fine_margin);
        plan.fine_end = plan.block_length() + reach + std::max(0., least_ahead - sizes.fine_margin);
      }

    plan.rail  = make_rail_section(profiles.rail, contact.rail, plan.strip, block);
    plan.wheel = make_wheel_section(profiles.wheel, wheel, contact.wheel, plan.strip, block);
    orient_blocks(plan.rail);
    orient_blocks(plan.wheel);
    return plan;
  }
} // namespace wheelrail
