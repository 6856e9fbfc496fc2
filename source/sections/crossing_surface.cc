#include <wheelrail/base/errors.h>
#include <wheelrail/base/parallel.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/sections/crossing_heights.h>
#include <wheelrail/sections/crossing_surface.h>
#include <wheelrail/sections/rail_slices.h>
#include <wheelrail/sections/rise_over_section.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace wheelrail
{
  namespace
  {
    constexpr double nothing = -HUGE_VAL;
    constexpr double near    = 0.3e-3; // of the wheel: under load it comes there [m]

    /// The larger of two heights, rounded where they differ by less than 0.4 mm, up to the second derivative.
    double
    higher(const double a, const double b)
    {
      constexpr double round = 0.4e-3;
      const double     rest  = std::max(0., 1 - std::abs(a - b) / round);
      return std::max(a, b) + round / 6 * rest * rest * rest;
    }

    /// Where heights stand highest over the lowest line of the wheel, and by how much [m].
    std::pair<std::size_t, double>
    highest_over(const std::vector<double> &height, const std::vector<double> &wheel)
    {
      std::pair<std::size_t, double> most{0, nothing};
      for (std::size_t i = 0; i < wheel.size(); ++i)
        if (height[i] - wheel[i] > most.second)
          most = {i, height[i] - wheel[i]};
      return most;
    }

    double
    over_wheel(const std::vector<double> &height, const std::vector<double> &wheel)
    {
      return highest_over(height, wheel).second;
    }
  } // namespace


  /// One of the two rails over the places of a surface.
  struct CrossingSurface::OneRail
  {
    std::string                      entry;     ///< with its value
    std::vector<SectionColumn>       columns;   ///< along; empty where the rail is not, or cut off
    std::vector<std::vector<double>> height;    ///< [along][across] [m]
    Range                            ends;      ///< where it is [m]
    double                           sinks = 0; ///< length of an end [m]
  };


  void
  CrossingSurface::lay_places(const ProfileSettings &scene, const double distance)
  {
    constexpr double beside = 0.1;
    double           least  = HUGE_VAL;
    slices_                 = {HUGE_VAL, -HUGE_VAL};
    for (const std::string &path : {scene.rail_profile, scene.second_rail})
      {
        const auto slices = turned_slices(scene, path).slices;
        least             = std::min(least, least_distance(slices));
        slices_ = {std::min(slices_.s0, slices.front().along), std::max(slices_.s1, slices.back().along)};
      }
    shortest          = 8 * least;
    const double step = step_along(least);
    start             = static_cast<std::size_t>(std::ceil(beside / step));
    const auto n      = start + static_cast<std::size_t>(std::ceil((distance + beside) / step));
    for (std::size_t k = 0; k <= n; ++k)
      along.push_back(scene.rail_place + (static_cast<double>(k) - static_cast<double>(start)) * step);
  }


  CrossingSurface::OneRail
  CrossingSurface::read_rail(const Scene              &scene,
                             const std::string        &name,
                             const std::string        &path,
                             std::vector<std::string> &notes) const
  {
    const SectionsSurface rail  = read_rail_slices(scene, "Profiles/" + name, path, {}, notes);
    const double          least = 3 * scene.cell_size;
    const std::size_t     n     = along.size();
    OneRail               one{
      entry_text(scene, "Profiles", name), {}, {}, {rail.begin(), rail.end()}, std::max(least, 10e-3)};
    std::vector<SectionColumn> columns(n);
    for (const double place : along)
      rail.refuse_jump(std::clamp(place, slices_.s0, slices_.s1));
    parallel_for(n, [&](const std::size_t k) {
      columns[k] = rail.column(std::clamp(along[k], slices_.s0, slices_.s1));
    });
    const auto  there = [&](const std::size_t k) { return !columns[k].empty(); };
    const auto  thick = [&](const std::size_t k) { return there(k) && width_of(columns[k]) >= least; };
    std::size_t first = 0, last = n - 1;
    while (first < n && !thick(first))
      ++first;
    if (first == n)
      throw InputError(one.entry + ": its head is thinner than three cells, " + in_mm(least) +
                       ", all along the path, or is not there; take a smaller Mesh/Solution cell size");
    while (!thick(last))
      --last;
    const auto cut_off = [&](const char *where, const double end) {
      notes.push_back(one.entry + ": what lies " + where + in_mm(end) +
                      " of it is cut off, where its head is thinner than three cells, " + in_mm(least) +
                      ", 5 mm below its top");
      return end;
    };
    if (first > 0 && there(first - 1))
      one.ends.s0 = cut_off("in front of ", along[first]);
    if (last + 1 < n && there(last + 1))
      one.ends.s1 = cut_off("behind ", along[last]);
    one.height.assign(n, std::vector<double>(across.size(), nothing));
    parallel_for(n, [&](const std::size_t k) {
      if (k >= first && k <= last && there(k))
        one.height[k] = heights_of(columns[k], across);
      else
        columns[k] = {};
    });
    one.columns = std::move(columns);
    return one;
  }


  /// How far an end of a rail among others lets it sink at a place [m].
  double
  CrossingSurface::sunk(const OneRail &rail, const double place) const
  {
    double share = 1;
    if (rail.ends.s0 > slices_.s0)
      share *= passing_over(place - rail.ends.s0, 0, rail.sinks);
    if (rail.ends.s1 < slices_.s1)
      share *= passing_over(rail.ends.s1 - place, 0, rail.sinks);
    return 2 * below * (1 - share);
  }


  /// Heights g of what the wheel sweeps over the highest places of the rails [m], and how far ahead of the
  /// axle or behind it the wheel touches. Throws InputError where it touches beyond `edge` across.
  std::vector<double>
  CrossingSurface::swept(const std::vector<double> &highest,
                         const std::vector<double> &highest_across,
                         const double               edge,
                         const double               radius)
  {
    const std::size_t   n = along.size();
    std::vector<double> wheel(n, nothing), heights(n, HUGE_VAL);
    const auto          circle = [&](const std::size_t a, const std::size_t k) {
      return (along[k] - along[a]) * (along[k] - along[a]) / (2 * radius);
    };
    double farthest = 0;
    for (std::size_t a = 0; a < n; ++a)
      {
        std::size_t at = a;
        for (std::size_t k = 0; k < n; ++k)
          if (const double touches = highest[k] - circle(a, k); touches > wheel[a])
            {
              wheel[a] = touches;
              at       = k;
            }
        if (a < start || a + start >= n) // beside the path
          continue;
        farthest = std::max(farthest, std::abs(along[at] - along[a]));
        if (highest_across[at] > edge)
          throw InputError("at " + in_mm(along[a]) +
                           " along the rails the wheel stands on its field-side edge, " +
                           in_mm(highest_across[at]) +
                           " beside the middle of the section, beyond the fine cells; end the path before, "
                           "by a shorter Run/Rolling distance");
      }
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t a = 0; a < n; ++a)
        heights[k] = std::min(heights[k], wheel[a] + circle(a, k));
    constexpr double more = 5e-3; // under load patches reach beyond the point of touch
    slope                 = farthest / radius + more;
    return heights;
  }


  void
  CrossingSurface::fill(const std::vector<OneRail> &rails,
                        const std::vector<double>  &wheel,
                        const Scene                &scene,
                        const WheelProfile         &profile,
                        std::vector<std::string>   &notes)
  {
    // fine cells end in front of the chamfer (make_fine_strip()), and half a patch is two cells
    const double      edge = across.back() - 0.3 * scene.coarse_cell_size - 2 * scene.cell_size;
    const std::size_t n = along.size(), m = across.size();
    height.assign(n, std::vector<double>(m, nothing));
    second_.assign(n, std::vector<char>(m, 0));
    std::vector<double> highest(n), highest_across(n);
    for (std::size_t k = 0; k < n; ++k)
      {
        for (const OneRail &rail : rails)
          for (std::size_t i = 0; i < m; ++i)
            height[k][i] = std::max(height[k][i], rail.height[k][i] - sunk(rail, along[k]));
        for (std::size_t i = 0; i < m; ++i)
          second_[k][i] = rails.back().height[k][i] > rails.front().height[k][i];
        const auto [i, most] = highest_over(height[k], wheel);
        highest[k]           = most;
        highest_across[k]    = across[i];
      }
    if (*std::max_element(highest.begin(), highest.end()) == nothing)
      throw InputError("wheel and rails by slices do not lie over each other");
    const std::vector<double> heights = swept(highest, highest_across, edge, scene.track.nominal_radius);
    refuse_flange(rails, heights, scene, profile);
    std::size_t first = m, end = 0;
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < m; ++i)
        {
          const double wheel_there = wheel[i] + heights[k];
          if (height[k][i] > wheel_there - near)
            {
              first = std::min(first, i);
              end   = std::max(end, i + 1);
            }
          height[k][i] = higher(height[k][i], wheel_there - below);
        }
    note_ends(rails, wheel, heights, notes);
    note_far(rails, wheel, heights, notes);
    keep(first, end);
  }


  /// Tells of ends that the wheel comes near.
  void
  CrossingSurface::note_ends(const std::vector<OneRail> &rails,
                             const std::vector<double>  &wheel,
                             const std::vector<double>  &heights,
                             std::vector<std::string>   &notes) const
  {
    const auto comes_near = [&](const OneRail &rail, const double place) {
      constexpr double beside = 10e-3; // of the path
      if (place < along[start] - beside || place > along.back() - along[start] + along.front() + beside)
        return false;
      const auto k =
        static_cast<std::size_t>(std::lower_bound(along.begin(), along.end(), place) - along.begin());
      return over_wheel(rail.height[k], wheel) > heights[k] - near;
    };
    for (const OneRail &rail : rails)
      for (const bool front : {true, false})
        {
          const double end = front ? rail.ends.s0 : rail.ends.s1;
          if ((front ? end > slices_.s0 : end < slices_.s1) &&
              comes_near(rail, front ? end + rail.sinks : end - rail.sinks - (along[1] - along[0])))
            notes.push_back(rail.entry + (front ? ": begins at " : ": ends at ") + in_mm(end) +
                            " within reach of the wheel: its surface sinks there over " + in_mm(rail.sinks) +
                            ", and what the wheel does there is not that of a square end");
        }
  }


  /// Tells of rails that the wheel does not come near on the path.
  void
  CrossingSurface::note_far(const std::vector<OneRail> &rails,
                            const std::vector<double>  &wheel,
                            const std::vector<double>  &heights,
                            std::vector<std::string>   &notes) const
  {
    for (const OneRail &rail : rails)
      {
        bool comes_near = false;
        for (std::size_t k = start; k + start < along.size() && !comes_near; ++k)
          comes_near = over_wheel(rail.height[k], wheel) - sunk(rail, along[k]) > heights[k] - near;
        if (!comes_near)
          notes.push_back(rail.entry + ": the wheel comes nowhere near it on the path");
      }
  }


  /// Throws InputError where the flange would lie in a rail when the tread rolls over both.
  void
  CrossingSurface::refuse_flange(const std::vector<OneRail> &rails,
                                 const std::vector<double>  &heights,
                                 const Scene                &scene,
                                 const WheelProfile         &profile) const
  {
    const PosedWheel wheel(profile, scene.track, wheelset_pose(scene));
    for (std::size_t k = start; k + start < along.size(); ++k)
      for (const OneRail &rail : rails)
        for (const Point2 &p : rail.columns[k].points())
          {
            const double x = -p.x;
            if (x >= across.front()) // of the tread, which rolls over both
              continue;
            const auto free = above_section(wheel, {x, p.y}, scene.track, heights[k]);
            if (free && *free < 0)
              throw InputError(
                "at " + in_mm(along[k]) + " along the rails the flange runs into " + rail.entry +
                "; y of all slices should point to the field side (Profiles/Rail mirror); else "
                "move the wheel by Wheelset/Lateral shift, or roll a shorter "
                "Run/Rolling distance");
          }
  }


  void
  CrossingSurface::keep(std::size_t first, std::size_t end)
  {
    const auto beside = static_cast<std::size_t>(20e-3 / crossing_spacing);
    const auto circle = static_cast<std::size_t>( // 2D-Geo looks from there
      std::lower_bound(across.begin(), across.end(), -0.5 * crossing_spacing) - across.begin());
    first             = std::min(first, circle);
    end               = std::max(end, circle + 1);
    first             = first > beside ? first - beside : 0;
    end               = std::min(across.size(), end + beside);
    const auto cut    = [&](auto &row) {
      row = {row.begin() + static_cast<std::ptrdiff_t>(first),
             row.begin() + static_cast<std::ptrdiff_t>(end)};
    };
    cut(across);
    for (std::size_t k = 0; k < along.size(); ++k)
      {
        cut(height[k]);
        cut(second_[k]);
      }
  }


  CrossingSurface::CrossingSurface(const Scene              &scene,
                                   const WheelProfile       &profile,
                                   std::vector<std::string> &notes)
  {
    const WheelLine wheel = wheel_line(scene, profile);
    across                = wheel.across;
    lay_places(scene, scene.mesh_distance());
    fill({read_rail(scene, "Rail", scene.rail_profile, notes),
          read_rail(scene, "Second rail", scene.second_rail, notes)},
         wheel.height,
         scene,
         profile,
         notes);
  }


  bool
  CrossingSurface::on_second(const double x, const double place) const
  {
    const auto nearest = [](const std::vector<double> &places, const double at) {
      const double step = (places.back() - places.front()) / static_cast<double>(places.size() - 1);
      return static_cast<std::size_t>(
        std::clamp(std::round((at - places.front()) / step), 0., static_cast<double>(places.size() - 1)));
    };
    return second_[nearest(along, place)][nearest(across, x)] != 0;
  }


  std::vector<Point2>
  CrossingSurface::section_of_start() const
  {
    constexpr double           radius = 13e-3, turn = 0.5e-3 / radius, side = 20e-3, step = 1e-3;
    const std::vector<double> &top = height[start];
    std::vector<Point2>        points;
    for (std::size_t i = across.size(); i-- > 0;)
      if (i % 2 == 0) // each 0.5 mm
        points.push_back({across[i], top[i]});
    for (const int sign : {1, -1}) // the field side is put in front, the gauge side behind
      {
        // beside the flange no steeper than its face, so that blocks have room below the corner
        const double steep        = std::atan(sign > 0 ? 20. : 2.75);
        const Point2 a            = sign > 0 ? points[1] : points[points.size() - 2],
                     b            = sign > 0 ? points[0] : points.back();
        const double        begin = std::atan2(a.y - b.y, sign * (b.x - a.x)); // angle downwards
        const Point2        centre{b.x - sign * radius * std::sin(begin), b.y - radius * std::cos(begin)};
        std::vector<Point2> end;
        const int           n = static_cast<int>(std::ceil((steep - begin) / turn));
        for (int k = 1; k <= n; ++k)
          {
            const double angle = begin + (steep - begin) * k / n;
            end.push_back({centre.x + sign * radius * std::sin(angle), centre.y + radius * std::cos(angle)});
          }
        const Point2 low = end.back();
        for (double down = step; down < side; down += step)
          end.push_back({low.x + sign * down / std::tan(steep), low.y - down});
        if (sign > 0)
          points.insert(points.begin(), end.rbegin(), end.rend());
        else
          points.insert(points.end(), end.begin(), end.end());
      }
    return points;
  }
} // namespace wheelrail
