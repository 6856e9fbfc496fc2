#include <wheelrail/base/errors.h>
#include <wheelrail/base/parallel.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/geometry/irregular_shapes.h>
#include <wheelrail/model/sliced_rails.h>
#include <wheelrail/profiles/height_noise.h>
#include <wheelrail/sections/rail_slices.h>
#include <wheelrail/sections/rise_over_section.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

// A rail whose section changes slowly is the swept rail of one section, whose surface rises and falls along
// the normal of that section (RunningSurface): whatever knows irregular surfaces knows it.

namespace wheelrail
{
  namespace
  {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    double
    highest(const SectionColumn &column)
    {
      double top = -HUGE_VAL;
      for (const Point2 &p : column.points())
        top = std::max(top, p.y);
      return top;
    }

    /// Distances of a section from the feet along their normals [m], the nearest one of each; not a number
    /// where there is none within `reach`. `top` of the section that the feet have [m].
    std::vector<double>
    distances(const SectionColumn &column, const std::vector<Foot> &feet, const double top)
    {
      constexpr double    reach = 12e-3, enough = 1e-12;
      std::vector<double> found(feet.size(), unknown);
      if (column.empty())
        return found;
      const auto shown = [&](const Point2 &p) { return Point2{-p.x, p.y - top}; };
      for (std::size_t i = 0; i < feet.size(); ++i)
        {
          const Foot &foot   = feet[i];
          const auto  beside = [&](const Point2 &p) { return dot(shown(p) - foot.position, foot.tangent); };
          double      last   = beside(column.points().front());
          for (std::size_t k = 1; k < column.points().size(); ++k)
            {
              const double before = last;
              last                = beside(column.points()[k]);
              if ((before < 0) == (last < 0) || norm(shown(column.points()[k]) - foot.position) > 2 * reach)
                continue;
              double a = column.arc(static_cast<double>(column.first() + k - 1)),
                     b = column.arc(static_cast<double>(column.first() + k)), s = a;
              for (int round = 0; round < 60 && b - a > enough; ++round)
                {
                  const SectionColumn::Point at = column.at(s = 0.5 * (a + b));
                  // a step of Newton where it stays between the ends
                  const double value                    = beside(at.position),
                               slope                    = dot({-at.tangent.x, at.tangent.y}, foot.tangent),
                               next                     = s - value / slope;
                  ((value < 0) == (before < 0) ? a : b) = s;
                  if (next > a && next < b)
                    {
                      const double there = beside(column.at(s = next).position);
                      if (std::abs(there) < enough)
                        break;
                      ((there < 0) == (before < 0) ? a : b) = s;
                    }
                }
              const double height = dot(shown(column.at(s).position) - foot.position, foot.normal);
              if (std::abs(height) < reach && !(std::abs(found[i]) <= std::abs(height)))
                found[i] = height;
            }
        }
      return found;
    }

    /// One rail, or two with a gap between them.
    struct SlicedRail
    {
      std::vector<SectionsSurface> rails;
      Range                        gap; ///< infinitely far for one rail [m]
    };

    SlicedRail
    read_sliced(const Scene &scene, const Slices &slices, std::vector<std::string> &notes)
    {
      SlicedRail sliced{{read_rail_slices(scene, "Profiles/Rail", scene.rail_profile, {}, notes)},
                        gap_of_rails(scene, slices)};
      if (std::isfinite(sliced.gap.s0))
        sliced.rails.push_back(read_rail_slices(scene, "Profiles/Second rail", scene.second_rail, {}, notes));
      return sliced;
    }

    /// How far sections stand above that of the start.
    class RiseFinder
    {
    public:
      RiseFinder(const SlicedRail &sliced, const std::vector<Foot> &feet, const double base)
        : sliced_(sliced)
        , feet_(feet)
        , top_(highest(sliced.rails.front().column(base)))
        , base_(distances(sliced.rails.front().column(base), feet, top_))
      {
      }

      /// Over all feet; beyond the slices that of their ends, in a gap what goes over [m].
      std::vector<double>
      at(const double place) const
      {
        const Range &gap = sliced_.gap;
        if (place <= gap.s0)
          return of(sliced_.rails.front(), place);
        if (place >= gap.s1)
          return of(sliced_.rails.back(), place);
        std::vector<double>       rise   = of(sliced_.rails.front(), gap.s0);
        const std::vector<double> behind = of(sliced_.rails.back(), gap.s1);
        const double              share  = passing_over(place, gap.s0, gap.s1);
        for (std::size_t i = 0; i < rise.size(); ++i)
          rise[i] += share * (behind[i] - rise[i]);
        return rise;
      }

    private:
      std::vector<double>
      of(const SectionsSurface &rail, const double place) const
      {
        std::vector<double> rise =
          distances(rail.column(std::clamp(place, rail.begin(), rail.end())), feet_, top_);
        for (std::size_t i = 0; i < rise.size(); ++i)
          rise[i] -= base_[i];
        return rise;
      }

      const SlicedRail        &sliced_;
      const std::vector<Foot> &feet_;
      double                   top_;
      std::vector<double>      base_;
    };

    /// The rows around one of them that all places have.
    std::pair<std::size_t, std::size_t>
    common_rows(const std::vector<std::vector<double>> &rises, const std::size_t row)
    {
      const auto whole = [&](const std::size_t i) {
        return std::none_of(
          rises.begin(), rises.end(), [&](const auto &rise) { return std::isnan(rise[i]); });
      };
      std::size_t first = row, end = row;
      while (first > 0 && whole(first - 1))
        --first;
      while (end < rises.front().size() && whole(end))
        ++end;
      return {first, end};
    }

    /// The rises over the feet, on a grid around the path.
    HeightGrid
    grid_of_rises(const Scene            &scene,
                  const TouchingProfiles &profiles,
                  const SlicedRail       &sliced,
                  const double            base,
                  const double            step)
    {
      constexpr double        beside         = 0.1;
      constexpr std::size_t   beside_contact = 10; // rows of 0.5 mm
      const std::vector<Foot> feet           = feet_of(profiles);
      const RiseFinder        finder(sliced, feet, base);
      const long              first = std::lround(std::floor(-beside / step)),
                 last               = std::lround((scene.mesh_distance() + beside) / step);
      HeightGrid grid;
      for (long k = first; k <= last; ++k)
        grid.along.push_back(scene.rail_place + static_cast<double>(k) * step);
      for (const SectionsSurface &rail : sliced.rails)
        for (const double place : grid.along)
          rail.refuse_jump(place);
      std::vector<std::vector<double>> rises(grid.along.size());
      parallel_for(rises.size(), [&](const std::size_t k) { rises[k] = finder.at(grid.along[k]); });
      std::size_t at = 0;
      while (at + 1 < feet.size() && feet[at].position.x < profiles.contact.rail_x)
        ++at;
      const auto [low, high] = common_rows(rises, at);
      if (at - low < beside_contact || high < at + beside_contact)
        throw InputError("Profiles/Rail = " + scene.rail_profile + ": between " + in_mm(grid.along.front()) +
                         " and " + in_mm(grid.along.back()) +
                         " its sections do not lie over each other 5 mm on both sides of the contact, or are "
                         "more than 12 mm apart: such a rail is for --places of geometry and halfspace");
      for (std::size_t row = low; row < high; ++row)
        {
          grid.across.push_back(feet[row].position.x);
          for (const std::vector<double> &rise : rises)
            grid.height.push_back(rise[row]);
        }
      return grid;
    }

    /// Lets the slices of a shape be off as a whole by draws of their noise. `origin`: where the place 0 of
    /// the slices lies along [m].
    void
    draw_slices(const Slices &slices, const double noise, const double origin, Irregularity &shape)
    {
      std::vector<double> places;
      for (const Slices::Slice &slice : slices.slices)
        places.push_back(slice.along + origin);
      shape.drawn = [places, noise, at = shape.at](const unsigned int draw) {
        HeightGrid line{places, {}, std::vector<double>(places.size(), 0.), {}, noise};
        const auto off = grid_irregularity(with_noise(line, true, draw), 0, 0, 0).at;
        return [at, off](const double across, const double along) {
          IrregularHeight       height = at(across, along);
          const IrregularHeight more   = off(across, along);
          height.height += more.height;
          height.along += more.along;
          return height;
        };
      };
    }

    /// What the wheel cannot touch: deeper than a chord of its circle by more than it is ever pressed in. At
    /// its ends a circle touches half of its length from the axle, as on a slope of that over the radius.
    Irregularity
    gap_between(const Range &gap, const double radius)
    {
      const double length = gap.s1 - gap.s0, deep = 0.3e-3 + 0.125 * length * length / radius;
      Irregularity shape;
      shape.name   = "Profiles";
      shape.begin  = gap.s0;
      shape.end    = gap.s1;
      shape.gap    = true;
      shape.kinks  = {{gap.s0}, {gap.s1}};
      shape.second = [middle = 0.5 * (gap.s0 + gap.s1)](double, const double along) {
        return along > middle;
      };
      shape.shortest = length;
      shape.measures = {deep, 0.5 * length / radius};
      shape.at       = [deep](double, double) { return IrregularHeight{-deep, 0, 0}; };
      return shape;
    }
  } // namespace


  Irregularities
  rise_of_slices(const Scene              &scene,
                 const TouchingProfiles   &profiles,
                 const double              start,
                 std::vector<std::string> &notes)
  {
    constexpr double nothing = 1e-9;
    const Slices     slices  = turned_slices(scene, scene.rail_profile);
    if (rails_beside(scene, slices))
      return rise_of_crossing(scene, profiles, start, notes);
    const SlicedRail sliced = read_sliced(scene, slices, notes);
    const double     length = std::isfinite(sliced.gap.s0) ? sliced.gap.s1 - sliced.gap.s0 : 0,
                 origin     = -scene.rail_place - start;
    const double least      = least_distance(slices.slices);
    // eight places leave nothing out in a gap
    const double     step = length > 0 ? std::min(step_along(least), length / 8) : step_along(least);
    const HeightGrid grid = grid_of_rises(scene, profiles, sliced, slice_of_start(scene, slices).along, step);
    Irregularities   list;
    if (length > 0)
      list.push_back(
        gap_between({sliced.gap.s0 + origin, sliced.gap.s1 + origin}, profiles.contact.rolling_radius));
    if (std::none_of(grid.height.begin(), grid.height.end(), [](const double height) {
          return std::abs(height) > nothing;
        }))
      return list;
    Irregularity shape  = rise_irregularity(grid, scene.rail_place, start);
    shape.shortest      = 8 * least;
    const double beside = 30e-3; // the head around the contact
    shape.measures = measures_of(shape, profiles.contact.rail_x - beside, profiles.contact.rail_x + beside);
    if (const double noise = sliced.rails.front().noise(); noise > 0)
      draw_slices(slices, noise, origin, shape);
    list.push_back(shape);
    return list;
  }
} // namespace wheelrail
