#include <wheelrail/geometry/wheel_outline.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// The wheelset turned by roll about the track's direction, then by yaw about the vertical.
    struct Turn
    {
      double cr, sr, cy, sy;

      Turn(const double roll, const double yaw)
        : cr(std::cos(roll))
        , sr(std::sin(roll))
        , cy(std::cos(yaw))
        , sy(std::sin(yaw))
      {
      }

      /// Sine of the angle in front of the lowest place at which a part of slope g (dy/dx of the section) has
      /// its normal across the track, less the small turn by the roll; beyond 1 it has none.
      double
      sine(const double g) const
      {
        return -g * cr * sy / std::hypot(cy, sr * sy);
      }
    };

    /// A point of the outline and its derivative with respect to the fraction of a segment.
    struct OutlinePoint
    {
      Point2 position, slope;
    };

    OutlinePoint
    outline_point(const Segment &segment, const double f, const TrackDimensions &track, const Turn &turn)
    {
      const CurvePoint p = point_on(segment, f);
      const double     b = running_circle_distance(track), r = track.nominal_radius;
      // place along the axle and distance from it, and their change with the arc length
      const double xi = -b - p.position.x, rho = r - p.position.y, d_xi = -p.tangent.x, d_rho = -p.tangent.y;
      const double g = p.tangent.y / p.tangent.x, sine = turn.sine(g);
      const double theta = std::asin(sine) + std::atan2(turn.sr * turn.sy, turn.cy);
      const double d_theta =
        turn.sine(p.curvature / (p.tangent.x * p.tangent.x)) / std::sqrt(1 - sine * sine);
      const double c = std::cos(theta), s = std::sin(theta);

      const auto to_section = [&](const double ahead_of_yaw, const double forward, const double up) {
        const double X = ahead_of_yaw * turn.cy + forward * turn.sy;
        return Point2{-(turn.cr * X + turn.sr * up), -turn.sr * X + turn.cr * up};
      };
      const Point2 place =
        to_section(xi * turn.cr + rho * c * turn.sr, rho * s, xi * turn.sr - rho * c * turn.cr);
      const Point2 slope = to_section(d_xi * turn.cr + (d_rho * c - rho * s * d_theta) * turn.sr,
                                      d_rho * s + rho * c * d_theta,
                                      d_xi * turn.sr - (d_rho * c - rho * s * d_theta) * turn.cr);
      // the section's origin lies on the running circle
      return {place + Point2{-b, r}, speed_on(segment, f) * slope};
    }

    /// Cubics with the ends and end slopes of both points, over u from 0 to 1.
    Segment
    cubic(const std::string &name, const OutlinePoint &a, const OutlinePoint &b, const double length)
    {
      Segment segment;
      segment.kind  = Segment::Kind::spline;
      segment.name  = name;
      segment.start = a.position;
      segment.end   = b.position;
      const auto coefficients =
        [](const double p, const double q, const double m, const double n) -> std::vector<double> {
        return {p, m, 3 * (q - p) - 2 * m - n, m + n - 2 * (q - p)};
      };
      segment.coefficients_x =
        coefficients(a.position.x, b.position.x, length * a.slope.x, length * b.slope.x);
      segment.coefficients = coefficients(a.position.y, b.position.y, length * a.slope.y, length * b.slope.y);
      return segment;
    }
  } // namespace


  double
  WheelOutline::on_tread(const double t) const
  {
    if (parameters.empty())
      return t;
    const int k = std::clamp(static_cast<int>(t), 0, static_cast<int>(parameters.size()) - 2);
    return parameters[k] + (t - k) * (parameters[k + 1] - parameters[k]);
  }


  WheelOutline
  wheel_outline(const WheelProfile &wheel, const TrackDimensions &track, const double roll, const double yaw)
  {
    if (yaw == 0)
      return {wheel.tread, {}};
    constexpr double     spacing = 0.25e-3, most = 0.95;
    const Turn           turn(roll, yaw);
    std::vector<Segment> pieces;
    WheelOutline         outline;
    for (std::size_t k = 0; k < wheel.tread.segments().size(); ++k)
      {
        const Segment &whole = wheel.tread.segments()[k];
        const int      n     = std::max(1, static_cast<int>(std::ceil(length_on(whole, 0, 1) / spacing)));
        for (int i = 0; i < n; ++i)
          {
            const double f0 = static_cast<double>(i) / n, f1 = static_cast<double>(i + 1) / n;
            const auto   steep = [&](const double f) {
              const Point2 tangent = point_on(whole, f).tangent;
              return tangent.x >= 0 || std::abs(turn.sine(tangent.y / tangent.x)) > most;
            };
            if (steep(f0) || steep(f1))
              {
                if (whole.start.x < 0) // behind the flange nothing touches
                  {
                    k = wheel.tread.segments().size();
                    break;
                  }
                pieces.clear();
                outline.parameters.clear();
                continue;
              }
            OutlinePoint       first = outline_point(whole, f0, track, turn);
            const OutlinePoint last  = outline_point(whole, f1, track, turn);
            // where slopes jump by a rounding of the standard, so do places, by less than a micrometre
            if (!pieces.empty())
              first.position = pieces.back().end;
            else
              outline.parameters.push_back(k + f0);
            pieces.push_back(cubic(whole.name, first, last, f1 - f0));
            outline.parameters.push_back(k + f1);
          }
      }
    outline.curve = Curve(std::move(pieces));
    return outline;
  }


  AxleLine::SurfacePoint
  AxleLine::surface_point(const Point2 &place, const double tangent) const
  {
    const Point2 inwards = {-std::sin(tangent), std::cos(tangent)}, axis = {direction[0], direction[1]},
                 between = middle - place;
    // place + distance * inwards = middle + share * axis
    const double distance = cross(between, axis) / cross(inwards, axis),
                 share    = cross(between, inwards) / cross(inwards, axis);
    const double sine     = dot(inwards, axis);
    const double along = share * direction[2], level = std::hypot(direction[0], direction[2]);
    return {along,
            (along * direction[0] - (place.x - middle.x) * direction[2]) / level,
            distance * std::sqrt(1 - sine * sine),
            -std::asin(sine)};
  }


  AxleLine
  axle_line(const Placement &wheel, const TrackDimensions &track, const double yaw)
  {
    const double b = running_circle_distance(track);
    const double c = std::cos(wheel.angle), s = std::sin(wheel.angle);
    return {wheel.to_track({-b, track.nominal_radius}), {c * std::cos(yaw), s, -c * std::sin(yaw)}};
  }
} // namespace wheelrail
