#include <wheelrail/base/format_text.h>
#include <wheelrail/profiles/measured_profiles.h>
#include <wheelrail/wear/worn_profiles.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace wheelrail
{
  namespace
  {
    constexpr double spacing     = 0.25e-3; ///< of the points [m]
    constexpr double depth_taken = 30e-3;   ///< of the rail, below its top [m]
    constexpr double flange_back = 70e-3;   ///< from the running circle [m], EN 13715

    MeasuredProfile
    read_shape(const WornShape &shape, const ProfileKind kind, const std::string &name)
    {
      ProfileFileOptions options;
      options.kind   = kind;
      options.mirror = ProfileMirror::no;
      options.unit   = ProfileUnit::millimetre;
      options.noise  = 0;
      return read_profile_text(shape_as_text(shape, name), name, options);
    }

    std::string
    named(const WornShape &shape, const std::string &profile)
    {
      const bool is_new =
        std::all_of(shape.depth.begin(), shape.depth.end(), [](const double d) { return d == 0; });
      return (is_new ? "" : "worn ") + profile;
    }

    /// Where the points cross a level between two of them, from one side; the other coordinate, of the first
    /// crossing that `wanted` takes. Not a number where there is none.
    double
    crossing(const std::vector<Point2> &points,
             double Point2::*const of,
             const double          level,
             const std::size_t     begin,
             const std::size_t     end)
    {
      double Point2::*const other = of == &Point2::x ? &Point2::y : &Point2::x;
      for (std::size_t k = begin + 1; k < end; ++k)
        {
          const double a = points[k - 1].*of - level, b = points[k].*of - level;
          if (a == 0 || a * b < 0)
            return points[k - 1].*other + (points[k].*other - points[k - 1].*other) * a / (a - b);
        }
      return std::numeric_limits<double>::quiet_NaN();
    }

    std::size_t
    at_extreme(const std::vector<Point2> &points, const double sign)
    {
      return std::max_element(points.begin(),
                              points.end(),
                              [&](const Point2 &a, const Point2 &b) { return sign * a.y < sign * b.y; }) -
             points.begin();
    }
  } // namespace


  WornShape
  rail_shape(const RailProfile &rail)
  {
    double top = -1;
    for (const Segment &segment : rail.head.segments())
      top = std::max({top, segment.start.y, segment.end.y});
    return worn_shape(rail.head, top - depth_taken, spacing, true);
  }


  WornShape
  wheel_shape(const WheelProfile &wheel)
  {
    return worn_shape(wheel.tread, -1, spacing, false);
  }


  std::string
  shape_as_text(const WornShape &shape, const std::string &what)
  {
    std::string table =
      "# " + what + "; x to the field side [mm], y up [mm], worn depth [mm], damage, net cracks\n";
    for (std::size_t k = 0; k < shape.points.size(); ++k)
      table += text("%.9f %.9f %.9f %.6g %.6g\n",
                    1e3 * shape.points[k].x,
                    1e3 * shape.points[k].y,
                    1e3 * shape.depth[k],
                    shape.damage[k],
                    shape.cracks[k]);
    return table;
  }


  SceneProfiles
  profiles_of(const WornShape &rail, const WornShape &wheel, const Scene &scene)
  {
    std::vector<std::string> unread;
    SceneProfiles            profiles;
    profiles.rail = measured_rail(
      read_shape(rail, ProfileKind::rail, named(rail, scene.rail_profile)), scene.rail_body, unread);
    profiles.wheel = measured_wheel(read_shape(wheel, ProfileKind::wheel, named(wheel, scene.wheel_profile)),
                                    scene.wheel.rim_width,
                                    unread,
                                    WheelOrigin::running_circle);
    return profiles;
  }


  WornDimensions
  worn_dimensions(const WornShape &new_rail, const WornShape &rail, const WornShape &wheel)
  {
    WornDimensions    worn;
    const auto       &tread  = wheel.points;
    const std::size_t tip    = at_extreme(tread, -1);
    const double      circle = crossing(tread, &Point2::x, 0, 0, tip);
    const double      face   = crossing(tread, &Point2::y, circle - 10e-3, 0, tip + 1),
                 near_tip    = crossing(tread, &Point2::y, tread[tip].y + 2e-3, 0, tip + 1);
    worn.flange_height       = circle - tread[tip].y;
    worn.flange_thickness    = face + flange_back;
    worn.flange_gradient     = face - near_tip;
    const auto       &before = new_rail.points;
    const auto       &now    = rail.points;
    const std::size_t top    = at_extreme(before, 1);
    const double      gauge  = before[top].y - 14e-3;
    worn.rail_height =
      crossing(before, &Point2::x, 0, 0, before.size()) - crossing(now, &Point2::x, 0, 0, now.size());
    // the gauge side has the least x
    worn.rail_side = crossing(now, &Point2::y, gauge, top, now.size()) -
                     crossing(before, &Point2::y, gauge, top, before.size());
    return worn;
  }
} // namespace wheelrail
