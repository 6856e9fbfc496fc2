#include <wheelrail/base/parallel.h>
#include <wheelrail/geometry/irregular_shapes.h>
#include <wheelrail/sections/crossing_surface.h>
#include <wheelrail/sections/cubic_spline.h>
#include <wheelrail/sections/rise_over_section.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace wheelrail
{
  std::vector<Foot>
  feet_of(const TouchingProfiles &profiles)
  {
    constexpr double    spacing = 0.5e-3, steepest = 4;
    const Placement    &section = profiles.contact.rail;
    const ContactFrame &frame   = profiles.contact.frame;
    const FrameProfile  head(profiles.rail.head, section, frame, steepest);
    const int           n = static_cast<int>((head.s_max() - head.s_min()) / spacing);
    std::vector<Foot>   feet;
    for (int i = 0; i <= n; ++i)
      {
        const double              s      = head.s_max() + (head.s_min() - head.s_max()) * i / n;
        const FrameProfile::Value height = head.at(s);
        const double              secant = std::sqrt(1 + height.slope * height.slope);
        const auto   to_section = [&](const Point2 &q) { return section.to_section(frame.to_track(q)); };
        const Point2 at         = to_section({s, height.n});
        feet.push_back({at,
                        to_section({s + 1 / secant, height.n + height.slope / secant}) - at,
                        to_section({s - height.slope / secant, height.n + 1 / secant}) - at});
      }
    return feet;
  }


  double
  passing_over(const double at, const double from, const double to)
  {
    const double t = std::clamp((at - from) / (to - from), 0., 1.);
    return t * t * t * (10 - t * (15 - 6 * t));
  }


  Irregularity
  rise_irregularity(const HeightGrid &grid, const double begin, const double start)
  {
    Irregularity shape = grid_irregularity(grid, -begin - start, 0, 0);
    shape.name         = "Profiles";
    shape.endless      = true;
    shape.kinks.clear(); // between slices the sections are interpolated
    return shape;
  }


  namespace
  {
    /// How far the heights lie from a foot along its normal [m].
    double
    distance_from(const Foot &foot, const CubicSpline &heights, const double top)
    {
      constexpr int    most   = 60;
      constexpr double enough = 1e-12;
      double           t      = 0;
      for (int round = 0; round < most; ++round)
        {
          // heights and normals are no steeper than the wheel's strip: the distance shrinks with each round
          const double x    = foot.position.x + t * foot.normal.x,
                       miss = heights.at(x).value - top - foot.position.y - t * foot.normal.y;
          t += miss / foot.normal.y;
          if (std::abs(miss) < enough)
            break;
        }
      return t;
    }

    /// The feet between the ends of the surface.
    std::vector<Foot>
    feet_on(const CrossingSurface &surface, const TouchingProfiles &profiles)
    {
      constexpr double  beside = 5e-3; // a distance may lead there
      std::vector<Foot> feet;
      for (const Foot &foot : feet_of(profiles))
        if (foot.position.x > surface.across.front() + beside &&
            foot.position.x < surface.across.back() - beside)
          feet.push_back(foot);
      return feet;
    }
  } // namespace


  Irregularities
  rise_of_crossing(const Scene              &scene,
                   const TouchingProfiles   &profiles,
                   const double              start,
                   std::vector<std::string> &notes)
  {
    const auto              surface = std::make_shared<const CrossingSurface>(scene, profiles.wheel, notes);
    const std::vector<Foot> feet    = feet_on(*surface, profiles);
    const std::size_t       n       = surface->along.size();
    double                  top     = -HUGE_VAL;
    for (const Point2 &p : surface->section_of_start())
      top = std::max(top, p.y);
    HeightGrid grid;
    grid.along = surface->along;
    grid.height.resize(n * feet.size());
    for (const Foot &foot : feet)
      grid.across.push_back(foot.position.x);
    parallel_for(n, [&](const std::size_t k) {
      const CubicSpline heights(surface->across, surface->height[k]);
      for (std::size_t row = 0; row < feet.size(); ++row)
        grid.height[row * n + k] = distance_from(feet[row], heights, top);
    });
    Irregularity shape     = rise_irregularity(grid, scene.rail_place, start);
    shape.shortest         = surface->shortest;
    shape.measures         = measures_of(shape, grid.across.front(), grid.across.back());
    shape.measures.touched = surface->slope;
    shape.second = [surface, begin = scene.rail_place + start](const double across, const double along) {
      return surface->on_second(across, along + begin);
    };
    return {shape};
  }
} // namespace wheelrail
