#include <wheelrail/geometry/surface_kinks.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// How much more the slope of the distance over z changes across a place than beside it: a jump of it,
    /// and nothing of what is round.
    double
    jump_along(const RunningSurfaces &surfaces, const double s, const double z, const double aside)
    {
      constexpr double step  = 0.02e-3; // [m]
      const auto       slope = [&](const double from) {
        return (surfaces.distance(s, z + from + step) - surfaces.distance(s, z + from - step)) / (2 * step);
      };
      const double behind = slope(-aside), ahead = slope(aside);
      // jump of the slope over 2 a, less what it changes over the 2 a on either side, in the mean: of a
      // smooth curve the difference is of third order
      return ahead - behind - 0.5 * (slope(3 * aside) - ahead + behind - slope(-3 * aside));
    }

    void
    add_joints(const FrameProfile          &profile,
               const double                 sign,
               const std::vector<PatchRow> &rows,
               const double                 spacing,
               SurfaceKinks                &kinks)
    {
      const std::vector<double> &joints = profile.joints();
      for (std::size_t k = 1; k + 1 < joints.size(); ++k)
        if (std::any_of(rows.begin(), rows.end(), [&](const PatchRow &row) {
              return std::abs(row.s - joints[k]) <= spacing;
            }))
          kinks.add(sign * (std::atan(profile.at(joints[k]).slope) -
                            std::atan(profile.at(std::nextafter(joints[k], joints[k - 1])).slope)));
    }
  } // namespace


  void
  SurfaceKinks::add(const double jump)
  {
    edge  = std::max(edge, jump);
    notch = std::max(notch, -jump);
  }


  SurfaceKinks
  surface_kinks(const RunningSurfaces &surfaces, const std::vector<PatchRow> &rows, const double spacing)
  {
    SurfaceKinks kinks;
    add_joints(surfaces.outline.profile(), 1, rows, spacing, kinks);
    add_joints(surfaces.rail.profile(), -1, rows, spacing, kinks);
    const double circumference = 2 * M_PI * surfaces.rolling_radius;
    const Range  gap           = surfaces.rail.gap(); // whose ends are square
    for (const Body body : both_bodies)
      for (const auto &[along, aside] : surfaces[body].kinks())
        {
          // an arc of the wheel, which is closed
          const double z = body == Body::rail
                             ? along
                             : surfaces.rolling_radius *
                                 std::sin(std::remainder(along, circumference) / surfaces.rolling_radius);
          for (const PatchRow &row : rows)
            if (z >= row.z0 - spacing && z <= row.z1 + spacing &&
                (body == Body::rail || std::abs(std::remainder(along, circumference)) < 0.25 * circumference))
              kinks.add(z == gap.s0 || z == gap.s1 ? M_PI / 2 : jump_along(surfaces, row.s, z, aside));
        }
    return kinks;
  }
} // namespace wheelrail
