#include <wheelrail/base/errors.h>
#include <wheelrail/sections/touching_places.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelrail
{
  namespace
  {
    const Vector3    up   = {0, 1, 0};
    constexpr double none = std::numeric_limits<double>::infinity();
    constexpr int    bits = 30; // of a minimum: its place to 1e-9 m

    /// The gap over a section, for a wheel that is not lifted.
    double
    gap_at(const PosedWheel &wheel, const SectionColumn &column, const double s, const double Z)
    {
      const Point2 p = column.at(s).position;
      return wheel.distance({p.x, p.y, Z}, up, 0).value_or(none);
    }

    /// Least gap of a section within two lines beside `line`, which is moved there.
    double
    least_gap(const PosedWheel    &wheel,
              const SectionColumn &column,
              const double         Z,
              const double         reach,
              double              &line)
    {
      if (column.empty())
        return none;
      std::uintmax_t rounds = 60;
      const auto     least  = boost::math::tools::brent_find_minima(
        [&](const double s) { return std::min(gap_at(wheel, column, s, Z), 1.); },
        column.arc(line - reach),
        column.arc(line + reach),
        bits,
        rounds);
      line = column.line(least.first);
      return least.second;
    }

    /// Gaps on a grid of sections and lines.
    struct GapGrid
    {
      double                           Z0 = 0, step = 0;
      std::size_t                      stride = 1; ///< of the lines
      std::vector<std::vector<double>> gaps;       ///< [section][line / stride]

      double
      at(const std::size_t i, const std::size_t j) const
      {
        return i < gaps.size() && j < gaps[i].size() ? gaps[i][j] : none;
      }
    };

    GapGrid
    gap_grid(const SectionsSurface &rail, const PosedWheel &wheel, const double at)
    {
      constexpr double step = 2e-3, across = 0.5e-3, part_of_radius = 0.2;
      const double     reach = part_of_radius * wheel.on_section({0, 0, 0}, 0).radius;
      GapGrid          grid;
      grid.stride = std::max<std::size_t>(1, std::lround(across / rail.spacing()));
      grid.step   = step;
      const int n = static_cast<int>(std::ceil(reach / step));
      grid.Z0     = wheel.centre()[2] - n * step;
      for (int i = 0; i <= 2 * n; ++i)
        {
          const double         Z      = grid.Z0 + i * step;
          const SectionColumn  column = rail.column(at + Z);
          std::vector<double> &gaps   = grid.gaps.emplace_back();
          if (column.empty())
            continue;
          for (std::size_t line = 0; line < column.end(); line += grid.stride)
            if (line < column.first())
              gaps.push_back(none);
            else
              {
                const Point2 &p = column.points()[line - column.first()];
                gaps.push_back(wheel.distance({p.x, p.y, Z}, up, 0).value_or(none));
              }
        }
      return grid;
    }

    bool
    is_minimum(const GapGrid &grid, const std::size_t i, const std::size_t j)
    {
      const double here = grid.at(i, j);
      if (here == none)
        return false;
      for (int a = -1; a <= 1; ++a)
        for (int b = -1; b <= 1; ++b)
          if ((a != 0 || b != 0) && grid.at(i + a, j + b) < here)
            return false;
      return true;
    }

    /// The minimum beside a place of the grid.
    TouchingPlace
    refined(const SectionsSurface &rail,
            const PosedWheel      &wheel,
            const double           at,
            const double           Z0,
            const double           line0,
            const GapGrid         &grid)
    {
      const double      room  = 40; // lines on both sides that shape the section
      const double      reach = 2.0 * static_cast<double>(grid.stride);
      const std::size_t first = static_cast<std::size_t>(std::max(0., line0 - room)),
                        end   = static_cast<std::size_t>(line0 + room);
      double     line         = line0;
      const auto least        = [&](const double Z) {
        double here = line0;
        return std::min(least_gap(wheel, rail.column(at + Z, first, end), Z, reach, here), 1.);
      };
      std::uintmax_t      rounds = 60;
      const double        low = Z0 - 1.5 * grid.step, high = Z0 + 1.5 * grid.step;
      const double        Z = boost::math::tools::brent_find_minima(least, low, high, bits, rounds).first;
      const SectionColumn column = rail.column(at + Z, first, end);
      TouchingPlace       place;
      place.height                     = -least_gap(wheel, column, Z, reach, line);
      const SectionColumn::Point point = column.at(column.arc(line));
      place.line                       = line;
      place.place                      = {point.position.x, point.position.y, Z};
      place.normal                     = rail_normal(point);
      place.angle                      = std::atan(-point.tangent.y / point.tangent.x);
      place.slope                      = -place.normal[2] / place.normal[1];
      place.ahead                      = wheel.ahead(place.place);
      place.wheel                      = wheel.on_section(place.place, place.height);
      const double margin = 1e-6, beside = 1e-5;
      place.at_end = std::min(Z - low, high - Z) < margin ||
                     std::min(line - (line0 - reach), line0 + reach - line) < 1e-3 ||
                     column.arc(line) < margin || column.length() - column.arc(line) < margin ||
                     rail.column(at + Z - beside, first, end).empty() ||
                     rail.column(at + Z + beside, first, end).empty();
      return place;
    }
  } // namespace


  Vector3
  rail_normal(const SectionColumn::Point &point, const bool along)
  {
    const double side = point.tangent.x < 0 ? -1 : 1; // tangent to +X
    const Point2 t    = side * point.tangent;
    // across: (t, 0); along the track: (along, 1); Z x X is up
    const Point2 a = along ? point.along : Point2();
    return normalised(cross({a.x, a.y, 1}, {t.x, t.y, 0}));
  }


  std::vector<TouchingPlace>
  touching_places(const std::vector<SectionsSurface> &rails,
                  const PosedWheel                   &wheel,
                  const double                        at,
                  const double                        within)
  {
    constexpr double coarse = 0.3e-3, same = 0.2e-3; // error of the grid; of two minima that are one
    std::vector<TouchingPlace> places;
    std::vector<GapGrid>       grids;
    double                     least = none;
    for (const SectionsSurface &rail : rails)
      {
        grids.push_back(gap_grid(rail, wheel, at));
        for (const auto &row : grids.back().gaps)
          for (const double gap : row)
            least = std::min(least, gap);
      }
    if (least == none)
      throw InputError(
        "wheel and rails by slices do not lie over each other: at this place and lateral shift "
        "no part of a rail is below the running surface of the wheel");
    for (std::size_t r = 0; r < rails.size(); ++r)
      for (std::size_t i = 0; i < grids[r].gaps.size(); ++i)
        for (std::size_t j = 0; j < grids[r].gaps[i].size(); ++j)
          if (is_minimum(grids[r], i, j) && grids[r].at(i, j) < least + within + coarse)
            {
              TouchingPlace place = refined(rails[r],
                                            wheel,
                                            at,
                                            grids[r].Z0 + static_cast<double>(i) * grids[r].step,
                                            static_cast<double>(j * grids[r].stride),
                                            grids[r]);
              place.rail          = r;
              const bool known = std::any_of(places.begin(), places.end(), [&](const TouchingPlace &other) {
                return other.rail == r && norm(other.place - place.place) < same;
              });
              if (!known)
                places.push_back(place);
            }
    std::sort(places.begin(), places.end(), [](const TouchingPlace &a, const TouchingPlace &b) {
      return a.height > b.height;
    });
    for (TouchingPlace &place : places)
      place.gap = places.front().height - place.height;
    places.erase(
      std::remove_if(places.begin(), places.end(), [&](const TouchingPlace &p) { return p.gap > within; }),
      places.end());
    return places;
  }
} // namespace wheelrail
