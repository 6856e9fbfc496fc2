#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/geometry/frame_profile.h>
#include <wheelrail/model/sliced_rails.h>
#include <wheelrail/profiles/height_noise.h>
#include <wheelrail/sections/slices_file.h>

#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Heights of the points of a slice over a profile along its outward normal, over x of the section, where
    /// the profile is not steeper than `base` has it and not farther away than `reach` [m].
    Heights
    heights_over(const std::vector<Point2> &points,
                 const Curve               &profile,
                 const FrameProfile        &base,
                 const double               outwards,
                 const double               reach)
    {
      constexpr double least = 1e-6, beside = 0.2e-3; // between two places; an end that tilts
      Heights          heights;
      for (const Point2 &p : points)
        {
          const CurvePoint foot = profile.at(profile.closest(p));
          const Point2 normal = outwards * Point2{foot.tangent.y, -foot.tangent.x}, way = p - foot.position;
          const double x = foot.position.x + dot(way, foot.tangent) * foot.tangent.x;
          // beside an end of the profile, or on a steep part of it
          if (std::abs(dot(way, foot.tangent)) < beside && norm(way) < reach && -x > base.s_min() - beside &&
              -x < base.s_max() + beside)
            heights.push_back({x, dot(way, normal)});
        }
      std::sort(heights.begin(), heights.end(), [](const Point2 &a, const Point2 &b) { return a.x < b.x; });
      heights.erase(std::unique(heights.begin(),
                                heights.end(),
                                [](const Point2 &a, const Point2 &b) { return b.x - a.x < least; }),
                    heights.end());
      return heights;
    }

    /// Heights as values of a cubic B-spline whose knots are the slices, with the heights of an interpolating
    /// spline at the averages of three knots as control points: even slices have their own heights there. It
    /// keeps straight lines straight and goes through the first and the last slice.
    void
    approximate_along(HeightGrid &grid)
    {
      const std::vector<double> &u = grid.along;
      const int                  n = static_cast<int>(u.size());
      // beyond the ends knots lie as far as inside
      const auto knot = [&](const int k) {
        return k < 0 ? 2 * u.front() - u[-k] : k >= n ? 2 * u.back() - u[2 * n - 2 - k] : u[k];
      };
      const std::unique_ptr<gsl_spline, decltype(&gsl_spline_free)> spline(
        gsl_spline_alloc(gsl_interp_cspline, n), gsl_spline_free);
      for (std::size_t row = 0; row < grid.height.size(); row += n)
        {
          gsl_spline_init(spline.get(), u.data(), grid.height.data() + row, n);
          const auto control = [&](const int k) {
            return gsl_spline_eval(spline.get(),
                                   std::clamp((knot(k - 1) + knot(k) + knot(k + 1)) / 3, u.front(), u.back()),
                                   nullptr);
          };
          for (int k = 1; k + 1 < n; ++k)
            {
              const double before = knot(k) - knot(k - 1), behind = knot(k + 1) - knot(k),
                           left  = behind * behind / ((before + behind) * (knot(k + 1) - knot(k - 2))),
                           right = before * before / ((before + behind) * (knot(k + 2) - knot(k - 1)));
              grid.height[row + k] =
                left * control(k - 1) + (1 - left - right) * control(k) + right * control(k + 1);
            }
        }
    }

    /// Length of the longest slice [m]; `low`, `high` come to where all slices lie beside each other.
    double
    longest_slice(const Slices &slices, double &low, double &high)
    {
      double longest = 0;
      for (const Slices::Slice &slice : slices.slices)
        {
          double length = 0, left = HUGE_VAL, right = -HUGE_VAL;
          for (const Point2 &p : slice.points)
            {
              length += norm(p - (&p == slice.points.data() ? p : *(&p - 1)));
              left  = std::min(left, p.x);
              right = std::max(right, p.x);
            }
          longest = std::max(longest, length);
          low     = std::max(low, left);
          high    = std::min(high, right);
        }
      return longest;
    }

    /// The heights of slices over a profile, along its outward normal: each 0.5 mm across where slices and
    /// profile lie beside each other, smoothed across as profiles are. `radius` of the circle on which the
    /// arcs of a wheel count [m], `noise` of the points [m] (negative: as found in them). Throws InputError
    /// where a slice is more than 5 mm away from the profile or narrower than 10 mm of it.
    HeightGrid
    heights_of_slices(const Slices      &slices,
                      const Curve       &profile,
                      const double       radius,
                      const double       noise,
                      const std::string &path)
    {
      constexpr double   spacing = 0.5e-3, reach = 5e-3, least = 10e-3, steepest = 4;
      const FrameProfile base(
        profile, Placement(), ContactFrame(), steepest); // its s is minus x of the section
      if (!slices.slices.front().features.empty())
        throw InputError(path +
                         ": slices with features (a rail in parts) are no irregularity; give them as "
                         "Profiles/Rail");
      std::vector<Heights> heights;
      HeightGrid           grid;
      double               low = -base.s_max(), high = -base.s_min();
      const auto           narrow = [&]() {
        if (!(high - low > least))
          throw InputError(path + ": slices and profile lie beside each other over less than " +
                           in_mm(least) + "; their lateral origins must be the same, y to the field side");
      };
      const double longest = longest_slice(slices, low, high);
      narrow();
      for (const Slices::Slice &slice : slices.slices)
        {
          grid.along.push_back(slices.wheel ? radius * slice.along : slice.along);
          heights.push_back(heights_over(slice.points, profile, base, slices.wheel ? -1 : 1, reach));
          if (heights.back().size() < 8)
            throw InputError(
              path + ": slice " + std::to_string(heights.size()) + " is more than " + in_mm(reach) +
              " away from the profile; slices have y to the field side and z down, and the origin "
              "of the profile");
          low  = std::max(low, heights.back().front().x);
          high = std::min(high, heights.back().back().x);
        }
      narrow();
      // as CONTACT divides the longest slice: between its points a spline rings beside kinks, and the
      // pressure there depends on where they lie
      const int n = 1 + static_cast<int>(std::floor(longest / spacing));
      for (int i = 0; i <= n; ++i)
        grid.across.push_back(low + (high - low) * i / n);
      const std::size_t m = grid.along.size();
      grid.height.resize(m * grid.across.size());
      for (std::size_t k = 0; k < m; ++k)
        {
          const double              deviation = noise >= 0 ? noise : largest_noise(heights[k]);
          const std::vector<double> line =
            smoothed(heights[k], deviation, stretch_of(deviation), grid.across);
          for (std::size_t row = 0; row < line.size(); ++row)
            grid.height[row * m + k] = line[row];
        }
      if (noise < 0)
        find_noise_of_slices(grid);
      return grid;
    }

    /// The irregularity of such heights, smoothed along unless their `noise` is given (0 or more): before the
    /// first slice and behind the last one they stay.
    Irregularity
    slices_irregularity(const HeightGrid &heights,
                        const Slices     &slices,
                        const double      place,
                        const double      noise,
                        const double      circumference)
    {
      const auto shape_of =
        [heights, noise, smoothed = slices.smoothed, place, circumference](const unsigned int draw) {
          HeightGrid grid = heights;
          if (noise < 0)
            smooth_along(grid, draw);
          if (smoothed)
            approximate_along(grid);
          return grid_irregularity(grid, place, 0, circumference);
        };
      Irregularity shape = shape_of(0);
      shape.endless      = true;
      if (heights.noise > 0)
        shape.drawn = [shape_of](const unsigned int draw) { return shape_of(draw).at; };
      return shape;
    }
  } // namespace


  Irregularity
  irregularity_of_slices(const ProfileSettings    &scene,
                         const IrregularityData   &data,
                         const TouchingProfiles   &profiles,
                         const double              place,
                         const double              radius,
                         std::vector<std::string> &notes)
  {
    const bool                wheel   = data.on_wheel();
    const ProfileFileOptions &options = wheel ? scene.wheel_file : scene.rail_file;
    const Slices              slices  = read_slices_file(data.file, options.unit);
    if (slices.wheel != wheel)
      throw InputError(data.file + ": slices of a " + (slices.wheel ? "wheel" : "rail") + " on the " +
                       (wheel ? "wheel" : "rail") + "; change Body");
    const Curve     &curve = wheel ? profiles.wheel.tread : profiles.rail.head;
    const HeightGrid grid  = heights_of_slices(slices, curve, radius, options.noise, data.file);
    if (grid.noise > 0)
      notes.push_back("slices off as a whole by " + text("%.2g um", 1e6 * grid.noise) +
                      " from one to the next");
    return slices_irregularity(grid, slices, place, options.noise, wheel ? 2 * M_PI * radius : 0);
  }
} // namespace wheelrail
