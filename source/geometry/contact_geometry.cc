#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/contact_geometry.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// A local minimum of the vertical gap between wheel and rail.
    struct GapMinimum
    {
      double X      = 0;     ///< in the track plane [m]
      double gap    = 0;     ///< [m], with the axle at the height of the nominal radius
      bool   smooth = false; ///< wheel and rail have a common tangent there
    };

    /// What stays the same for all shifts and rolls.
    struct Pair
    {
      const RailProfile     &rail;
      const WheelProfile    &wheel;
      const TrackDimensions &track;
      Placement              rail_placement;
      FrameProfile           rail_heights;
      double                 flank_end; ///< last parameter of the tread before the rounded top of the flange
    };

    // Steeper parts than this are not sought: they would touch sideways, not when lowered.
    constexpr double steepest_slope = 20;

    /// The last parameter of the tread, going down the flange, with a slope of 45 degrees or more:
    /// beyond it the wheel has climbed and stands on its flange. The end of a tread without such a flank.
    double
    find_flank_end(const Curve &tread)
    {
      double lowest = std::numeric_limits<double>::max(), found = 0, candidate = 0;
      for (std::size_t k = 0; k < tread.segments().size(); ++k)
        {
          const int n = samples_on(tread.segments()[k], 64);
          for (int i = 0; i <= n; ++i)
            {
              const CurvePoint p = point_on(tread.segments()[k], static_cast<double>(i) / n);
              const double     t = k + static_cast<double>(i) / n;
              if (p.position.x > 0 || p.tangent.x >= 0)
                continue;
              if (p.tangent.y / p.tangent.x >= 1)
                candidate = t;
              if (p.position.y < lowest)
                {
                  lowest = p.position.y;
                  found  = candidate;
                }
            }
        }
      return found > 0 ? found : tread.parameter_end();
    }

    std::vector<GapMinimum>
    gap_minima(const FrameProfile &wheel, const FrameProfile &rail)
    {
      const std::vector<double> points = common_places(wheel, rail, 2e-4);
      // gap'(X) = wheel' - rail': from falling to rising there is a minimum, with a common tangent where the
      // slope is 0 and not a jump
      const auto slope = [&](const double X) { return wheel.at(X).slope - rail.at(X).slope; };
      const auto entry = [&](const double X) {
        return GapMinimum{X, undeformed_distance(wheel, rail, X), std::abs(slope(X)) < 1e-3};
      };

      std::vector<GapMinimum> minima;
      bool                    rising = slope(points.front()) > 0;
      if (rising)
        minima.push_back(entry(points.front()));
      for (std::size_t i = 1; i < points.size(); ++i)
        {
          const bool now = slope(points[i]) > 0;
          if (now && !rising)
            {
              double a = points[i - 1], b = points[i];
              for (double m = 0.5 * (a + b); m > a && m < b; m = 0.5 * (a + b))
                (slope(m) > 0 ? b : a) = m;
              minima.push_back(entry(a));
            }
          rising = now;
        }
      if (!rising)
        minima.push_back(entry(points.back()));
      std::sort(minima.begin(), minima.end(), [](const auto &a, const auto &b) { return a.gap < b.gap; });
      return minima;
    }

    /// A wheel above its rail, with the axle at the height of the nominal radius.
    struct PlacedWheel
    {
      double       shift, roll, yaw;
      WheelOutline outline;
      Placement    placement;

      PlacedWheel(const Pair &pair, const WheelsetPose &pose, const double roll)
        : shift(pose.lateral_shift)
        , roll(roll)
        , yaw(pose.yaw)
        , outline(wheel_outline(pair.wheel, pair.track, roll, yaw))
        , placement(place_wheel(pair.track, shift, roll, pair.track.nominal_radius))
      {
      }
    };

    /// All local minima of the gap, lowest first; none when tread and rail head are not above each other.
    std::vector<GapMinimum>
    minima_at(const Pair &pair, const PlacedWheel &wheel)
    {
      const auto  &zones = wheel.outline.curve.segments();
      const double first = wheel.placement.to_track(zones.front().start).x;
      const double last  = wheel.placement.to_track(zones.back().end).x;
      // A margin for the last, vertical micrometres of the flange back, which are left out.
      if (first > -5e-3 || last < 5e-3)
        return {};
      return gap_minima(FrameProfile(wheel.outline.curve, wheel.placement, ContactFrame(), steepest_slope),
                        pair.rail_heights);
    }

    /// Height of the axle's middle above Y = 0 when the wheel touches.
    std::optional<double>
    axle_height(const Pair &pair, const WheelsetPose &pose, const double roll)
    {
      const auto minima = minima_at(pair, PlacedWheel(pair, pose, roll));
      if (minima.empty())
        return {};
      // the wheel sinks until the least gap is 0
      return pair.track.nominal_radius - minima.front().gap;
    }

    /// The roll at which both wheels touch: root of the difference of the two axle heights, which
    /// grows with the roll by about the distance of the running circles.
    std::optional<double>
    roll_from_contact(const Pair &pair, const Pair &opposite, const WheelsetPose &pose)
    {
      const auto difference = [&](const double roll) -> std::optional<double> {
        const auto a = axle_height(pair, pose, roll), b = axle_height(opposite, mirrored(pose), -roll);
        if (!a || !b)
          return {};
        // both wheels of one axle touch where both ask for the same height
        return *a - *b;
      };

      double     low = 0, high = 0;
      const auto at_zero = difference(0);
      if (!at_zero)
        return {};
      if (*at_zero == 0)
        return 0.;
      double f_low = *at_zero, f_high = *at_zero;
      for (double step = 1e-4; f_low > 0 || f_high < 0; step *= 2)
        {
          if (step > 0.05)
            return {};
          double    &end   = *at_zero > 0 ? low : high;
          const auto value = difference(*at_zero > 0 ? end - step : end + step);
          if (!value)
            return {};
          (*at_zero > 0 ? high : low)     = end;
          (*at_zero > 0 ? f_high : f_low) = *at_zero > 0 ? f_low : f_high;
          end += *at_zero > 0 ? -step : step;
          (*at_zero > 0 ? f_low : f_high) = *value;
        }

      bool       known = true; // both wheels touch at every roll that was tried
      const auto value = [&](const double roll) {
        const auto found = difference(roll);
        known            = known && found;
        return found.value_or(0.); // which ends the search
      };
      std::uintmax_t steps = 100;
      const auto     root  = boost::math::tools::toms748_solve(
        // root to 52 bits (Alefeld, Potra and Shi 1995, TOMS 748)
        value,
        low,
        high,
        f_low,
        f_high,
        boost::math::tools::eps_tolerance<double>(52),
        steps);
      if (!known)
        return {};
      return 0.5 * (root.first + root.second);
    }

    /// Fills what is known of the contact at X, where wheel and rail have a common tangent.
    void
    describe_point(const Pair &pair, const FrameProfile &outline, const double X, ContactGeometry &contact)
    {
      const double              wheel_t  = contact.outline.on_tread(outline.parameter(X));
      const double              rail_t   = pair.rail_heights.parameter(X);
      const CurvePoint          on_wheel = pair.wheel.tread.at(wheel_t), on_rail = pair.rail.head.at(rail_t);
      const FrameProfile::Value height = pair.rail_heights.at(X);
      contact.frame                    = {{X, height.n}, std::atan(height.slope)};
      contact.rail_x                   = on_rail.position.x;
      contact.rail_y                   = on_rail.position.y;
      contact.wheel_x                  = on_wheel.position.x;
      contact.wheel_y                  = on_wheel.position.y;
      // contact angle positive where the surface falls to the gauge side
      contact.angle = -contact.frame.angle;
      contact.axis  = axle_line(contact.wheel, pair.track, contact.yaw);
      const AxleLine::SurfacePoint point =
        contact.axis.surface_point(contact.frame.origin, contact.frame.angle);
      contact.along = point.along;
      contact.ahead = point.ahead;
      // y of a tread is 0 on the running circle and positive towards the axle
      contact.rolling_radius  = pair.track.nominal_radius - contact.wheel_y;
      contact.forward_radius  = contact.rolling_radius * std::cos(contact.yaw);
      contact.rail_curvature  = on_rail.curvature;
      contact.wheel_curvature = -on_wheel.curvature; // the wheel's steel lies to the right
      contact.rail_segment    = pair.rail.head.segments()[on_rail.segment].name;
      contact.wheel_segment   = pair.wheel.tread.segments()[on_wheel.segment].name;
    }

    /// Where the wheel stands, from its section in touch and its first contact point. A straight wheel is the
    /// straight one of the pose; one with yaw is turned about its axle, until its lowest line is in touch,
    /// and about the vertical through the middle of the axle, and moved along until it touches at Z = 0.
    void
    place_pose(const TrackDimensions &track, ContactGeometry &contact)
    {
      contact.pose        = {contact.wheel, track.nominal_radius, {}};
      contact.tread_frame = contact.frame;
      if (contact.yaw == 0)
        return;
      const Vector3  axis = contact.pose.axis(), centre = contact.pose.centre();
      const Vector3  middle = {contact.axis.middle.x, contact.axis.middle.y, 0};
      const Rotation yaw({0, 1, 0}, contact.yaw), straight({0, 1, 0}, -contact.yaw);
      const Vector3  point = {contact.frame.origin.x, contact.frame.origin.y, contact.along};
      const Rotation about(axis, -contact.pose.angle(middle + straight(point - middle)));
      for (int k = 0; k < 3; ++k)
        {
          Vector3 unit{};
          unit[k]             = 1;
          const Vector3 image = yaw(about(unit));
          for (int i = 0; i < 3; ++i)
            contact.pose.motion.rows[i][k] = image[i];
        }
      contact.pose.motion.move =
        middle + yaw(centre - middle) - contact.pose.motion.turned(centre) - Vector3{0, 0, contact.along};
    }

    /// The common tangent's place on the tread, before the wheel is turned by its yaw.
    void
    place_tread_frame(const CurvePoint &on_tread, ContactGeometry &contact)
    {
      const Point2 origin = contact.wheel.to_track(on_tread.position),
                   along  = contact.wheel.to_track(on_tread.position + on_tread.tangent) - origin;
      contact.tread_frame = {origin, std::atan2(along.y, along.x)};
    }

    /// Fills the contact of one wheel; returns why there is none, or an empty text.
    std::string
    touch(const Pair &pair, const WheelsetPose &pose, const double roll, ContactGeometry &contact)
    {
      PlacedWheel wheel(pair, pose, roll);
      const auto  minima = minima_at(pair, wheel);
      if (minima.empty())
        return "the tread and the rail head do not lie above each other";
      const GapMinimum &first = minima.front();

      contact.lateral_shift = wheel.shift;
      contact.roll          = roll;
      contact.yaw           = wheel.yaw;
      contact.rail          = pair.rail_placement;
      contact.wheel   = place_wheel(pair.track, wheel.shift, roll, pair.track.nominal_radius - first.gap);
      contact.axle    = contact.wheel.to_track({0, pair.track.nominal_radius});
      contact.outline = std::move(wheel.outline);

      const FrameProfile outline(contact.outline.curve, contact.wheel, ContactFrame(), steepest_slope);
      if (contact.outline.on_tread(outline.parameter(first.X)) > pair.flank_end + 1e-6)
        return "the flange stands on the rail";
      if (!first.smooth)
        return "the wheel rests on an edge of its profile or of the rail head";
      describe_point(pair, outline, first.X, contact);
      place_pose(pair.track, contact);
      if (contact.yaw != 0)
        place_tread_frame(pair.wheel.tread.at(contact.outline.on_tread(outline.parameter(first.X))), contact);

      ContactGeometry there = contact;
      for (std::size_t i = 1; i < minima.size(); ++i)
        if (minima[i].smooth)
          {
            describe_point(pair, outline, minima[i].X, there);
            contact.further.push_back({(minima[i].gap - first.gap) * std::cos(there.angle),
                                       there.rail_x,
                                       there.wheel_x,
                                       there.angle,
                                       there.along,
                                       there.ahead,
                                       there.rail_curvature,
                                       there.wheel_curvature,
                                       there.frame});
          }
      std::sort(contact.further.begin(), contact.further.end(), [](const auto &a, const auto &b) {
        return a.gap < b.gap;
      });
      contact.second_gap = -1;
      for (std::size_t i = 1; i < minima.size() && contact.second_gap < 0; ++i)
        if (minima[i].smooth)
          {
            contact.second_gap    = minima[i].gap - first.gap;
            contact.second_rail_x = pair.rail.head.at(pair.rail_heights.parameter(minima[i].X)).position.x;
          }
      return "";
    }

    std::string
    try_contact(const Pair &pair, const Pair &opposite, const WheelsetPose &pose, ContactGeometry &contact)
    {
      std::optional<double> roll = pose.roll == RollMode::given ? pose.roll_angle : 0.;
      if (pose.roll == RollMode::from_contact)
        roll = roll_from_contact(pair, opposite, pose);
      if (!roll)
        return "no roll of the wheelset lets both wheels touch their rails";
      ContactGeometry other;
      std::string     here  = touch(pair, pose, *roll, contact);
      std::string     there = touch(opposite, mirrored(pose), -*roll, other);
      contact.other_radius  = other.rolling_radius;
      if (!here.empty() || there.empty())
        return here;
      return "at the other wheel of the wheelset (shift of opposite sign) " + there;
    }

    /// The largest shift of one sign, to 0.1 mm, up to which there is contact from zero on; or
    /// nothing.
    std::optional<double>
    last_possible(const Pair &pair, const Pair &opposite, const WheelsetPose &pose, const double sign)
    {
      ContactGeometry ignored;
      const auto      possible = [&](const int tenths) {
        WheelsetPose moved  = pose;
        moved.lateral_shift = sign * 1e-4 * tenths;
        return try_contact(pair, opposite, moved, ignored).empty();
      };
      int good = 0, bad = 20;
      if (!possible(good))
        return {};
      for (; bad < 600 && possible(bad); bad += 20)
        good = bad;
      while (bad - good > 1)
        (possible((good + bad) / 2) ? good : bad) = (good + bad) / 2;
      return sign * 1e-4 * good;
    }
  } // namespace


  ContactGeometry
  find_contact(const RailProfile     &rail,
               const WheelProfile    &wheel,
               const TrackDimensions &track,
               const WheelsetPose    &pose,
               const WheelOnRail     *other)
  {
    const auto pair_of = [&](const RailProfile &on, const WheelProfile &of) {
      const Placement placed = place_rail(on, track);
      return Pair{on,
                  of,
                  track,
                  placed,
                  FrameProfile(on.head, placed, ContactFrame(), steepest_slope),
                  find_flank_end(of.tread)};
    };
    const Pair                pair = pair_of(rail, wheel);
    const std::optional<Pair> left =
      other ? std::optional<Pair>(pair_of(other->rail, other->wheel)) : std::nullopt;
    const Pair &opposite = left ? *left : pair;

    ContactGeometry   contact;
    const std::string reason = std::isfinite(pose.lateral_shift) ? try_contact(pair, opposite, pose, contact)
                                                                 : "the shift is not a finite number";
    if (reason.empty())
      return contact;

    std::ostringstream text;
    text << "Wheel '" << wheel.name << "' and rail '" << rail.name
         << "' have no contact point at a lateral shift of " << 1e3 * pose.lateral_shift << " mm: " << reason
         << ". ";
    const auto most  = last_possible(pair, opposite, pose, 1.),
               least = last_possible(pair, opposite, pose, -1.);
    if (most && least)
      text << "With this track, shifts from " << 1e3 * *least << " to " << 1e3 * *most
           << " mm are possible; set Wheelset/Lateral shift within them.";
    else
      text << "Not even the centred wheelset has one; check Track/Gauge, Wheelset/Flange back distance and "
              "the profiles.";
    throw InputError(text.str());
  }
} // namespace wheelrail
