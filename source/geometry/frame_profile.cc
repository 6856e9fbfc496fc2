#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/geometry/frame_profile.h>

#include <algorithm>
#include <cmath>
#include <limits>

// Heights n(s) of a profile in a contact frame, from the exact segment: closed for lines and arcs, Newton's
// steps for polynomials and splines (doc/theory/geometry.md, Rigid contact, 2).

namespace wheelrail
{
  namespace
  {
    /// Parameter up to which the curve, followed from `start` forwards (direction 1) or backwards
    /// (-1), keeps an allowed tangent.
    template <typename Allowed>
    double
    walk(const Curve &curve, const double start, const int direction, const Allowed &allowed)
    {
      const int n      = static_cast<int>(curve.segments().size());
      double    inside = start;
      for (int i = std::min(static_cast<int>(start), n - 1); i >= 0 && i < n; i += direction)
        {
          // The segment alone, so that a joint shows its tangent.
          const Segment &alone   = curve.segments()[i];
          const int      samples = samples_on(alone, 64);
          const double   from = std::clamp(inside - i, 0., 1.), to = direction > 0 ? 1. : 0.;
          double         good = from;
          for (int k = 0; k <= samples; ++k)
            {
              const double f = k == samples ? to : from + (to - from) * k / samples;
              if (allowed(point_on(alone, f).tangent))
                {
                  good = f;
                  continue;
                }
              if (k == 0)
                return inside;
              double bad = f;
              for (double m = 0.5 * (good + bad); m != good && m != bad; m = 0.5 * (good + bad))
                (allowed(point_on(alone, m).tangent) ? good : bad) = m;
              return i + good;
            }
          inside = i + to;
        }
      return inside;
    }
  } // namespace


  FrameProfile::FrameProfile(const Curve        &curve,
                             const Placement    &placement,
                             const ContactFrame &frame,
                             const double        max_slope)
    : curve_(curve)
  {
    const double angle = placement.angle - frame.angle;
    origin_            = frame.to_frame(placement.origin);
    // x of a section points to the field side, s of the frame to the track centre: the section is mirrored,
    // then turned
    ex_                 = {-std::cos(angle), -std::sin(angle)};
    ey_                 = {-std::sin(angle), std::cos(angle)};
    const auto in_frame = [this](const Point2 &p) { return origin_ + p.x * ex_ + p.y * ey_; };
    const auto allowed  = [&](const Point2 &tangent) {
      const Point2 d = tangent.x * ex_ + tangent.y * ey_;
      return d.x > 0 && std::abs(d.y) <= max_slope * d.x;
    };

    double start = -1, nearest = std::numeric_limits<double>::max();
    for (const double t :
         curve_.roots([&](const Point2 &p) { return in_frame(p).x; }, 0, curve_.parameter_end()))
      {
        const CurvePoint p = curve_.at(t);
        if (allowed(p.tangent) && std::abs(in_frame(p.position).y) < nearest)
          {
            start   = t;
            nearest = std::abs(in_frame(p.position).y);
          }
      }
    if (start < 0)
      throw InputError("A profile does not pass over the contact point (lateral coordinate " +
                       in_mm(frame.origin.x) + " in the track plane) with a slope below " +
                       format_number(max_slope) +
                       ". Tread and rail head have to lie above each other: look at Track/Gauge, "
                       "Wheelset/Flange back distance and Lateral shift.");

    const double t_min = walk(curve_, start, -1, allowed), t_max = walk(curve_, start, 1, allowed);

    const int n = static_cast<int>(curve_.segments().size());
    for (int i = static_cast<int>(t_min); i < n && i < t_max; ++i)
      {
        const Segment &g = curve_.segments()[i];
        Piece          piece;
        piece.segment = i;
        piece.start   = in_frame(g.start);
        piece.end     = in_frame(g.end);
        if (g.kind == Segment::Kind::arc)
          {
            piece.centre = in_frame(g.centre);
            // Running towards +s, a clockwise arc of the frame lies above its centre; the mirroring
            // makes it counter-clockwise in the section.
            piece.side = g.angle_end > g.angle_start ? 1. : -1.;
          }
        joints_.push_back(in_frame(curve_.at(std::max<double>(t_min, i)).position).x);
        pieces_.push_back(piece);
      }
    const Segment &last = curve_.segments()[pieces_.back().segment];
    joints_.push_back(in_frame(position_on(last, t_max - pieces_.back().segment)).x);
    s_min_ = joints_.front();
    s_max_ = joints_.back();
  }


  const FrameProfile::Piece &
  FrameProfile::piece_at(const double s) const
  {
    const auto after = std::upper_bound(joints_.begin() + 1, joints_.end() - 1, s);
    return pieces_[after - joints_.begin() - 1];
  }


  double
  FrameProfile::abscissa(const Piece &piece, const double s) const
  {
    const Segment &g         = curve_.segments()[piece.segment];
    const bool     is_spline = g.kind == Segment::Kind::spline;
    const double   fraction  = (s - piece.start.x) / (piece.end.x - piece.start.x);
    double         v         = is_spline ? fraction : g.start.x + fraction * (g.end.x - g.start.x);
    const double   smallest  = is_spline ? 1e-15 : 1e-17; // u runs over 1, x over millimetres
    for (int i = 0; i < 50; ++i)
      {
        const PolynomialValue y = evaluate_polynomial(g.coefficients, v);
        const PolynomialValue x =
          is_spline ? evaluate_polynomial(g.coefficients_x, v) : PolynomialValue{v, 1, 0};
        // ds/dv is never zero, since the slope in the frame is bounded.
        // Newton's method for s(v) = s, s(v) = origin + x(v) ex + y(v) ey
        const double step =
          (s - origin_.x - ex_.x * x.value - ey_.x * y.value) / (ex_.x * x.slope + ey_.x * y.slope);
        v += step;
        if (std::abs(step) < smallest)
          break;
        if (i > 6 && std::abs(step) < 100 * smallest)
          break;
      }
    return v;
  }


  FrameProfile::Value
  FrameProfile::at(double s) const
  {
    s                    = std::clamp(s, s_min_, s_max_);
    const Piece   &piece = piece_at(s);
    const Segment &g     = curve_.segments()[piece.segment];
    if (g.kind == Segment::Kind::line)
      {
        const Point2 d     = piece.end - piece.start;
        const double slope = d.y / d.x;
        return {piece.start.y + slope * (s - piece.start.x), slope};
      }
    if (g.kind == Segment::Kind::arc)
      {
        const double ds = s - piece.centre.x;
        // n = n_c +- sqrt(r^2 - ds^2), as (r - ds)(r + ds) without cancellation; slope -ds/(n - n_c)
        const double height = piece.side * std::sqrt(std::max((g.radius - ds) * (g.radius + ds), 0.));
        return {piece.centre.y + height, -ds / height};
      }
    const double          v = abscissa(piece, s);
    const PolynomialValue y = evaluate_polynomial(g.coefficients, v);
    const PolynomialValue x =
      g.kind == Segment::Kind::spline ? evaluate_polynomial(g.coefficients_x, v) : PolynomialValue{v, 1, 0};
    return {origin_.y + ex_.y * x.value + ey_.y * y.value,
            // dn/ds = (dn/dv)/(ds/dv)
            (ex_.y * x.slope + ey_.y * y.slope) / (ex_.x * x.slope + ey_.x * y.slope)};
  }


  double
  FrameProfile::parameter(double s) const
  {
    s                    = std::clamp(s, s_min_, s_max_);
    const Piece   &piece = piece_at(s);
    const Segment &g     = curve_.segments()[piece.segment];
    double         f     = 0;
    if (g.kind == Segment::Kind::line)
      f = (s - piece.start.x) / (piece.end.x - piece.start.x);
    else if (g.kind == Segment::Kind::spline)
      f = abscissa(piece, s);
    else if (g.kind == Segment::Kind::polynomial)
      f = (abscissa(piece, s) - g.start.x) / (g.end.x - g.start.x);
    else
      {
        const Point2 d     = Point2{s, at(s).n} - piece.centre;
        const double half  = 0.5 * (g.angle_end - g.angle_start);
        const double angle = std::atan2(dot(d, ey_), dot(d, ex_)) - 0.5 * (g.angle_start + g.angle_end);
        f                  = 0.5 * (1. + std::remainder(angle, 2. * M_PI) / half);
      }
    return piece.segment + std::clamp(f, 0., 1.);
  }


  std::vector<double>
  common_places(const FrameProfile &wheel, const FrameProfile &rail, const double spacing)
  {
    const double low = std::max(wheel.s_min(), rail.s_min()), high = std::min(wheel.s_max(), rail.s_max());
    std::vector<double> places = {low, high};
    for (const FrameProfile *profile : {&wheel, &rail})
      for (const double s : profile->joints())
        if (s > low && s < high)
          places.push_back(s);
    const int n = static_cast<int>(std::ceil((high - low) / spacing));
    for (int i = 1; i < n; ++i)
      places.push_back(low + (high - low) * i / n);
    std::sort(places.begin(), places.end());
    return places;
  }


  double
  undeformed_distance(const FrameProfile &wheel, const FrameProfile &rail, const double s)
  {
    return wheel.at(s).n - rail.at(s).n;
  }


  std::vector<Range>
  interpenetration(const FrameProfile &wheel, const FrameProfile &rail, const double approach)
  {
    const std::vector<double> points = common_places(wheel, rail, 1e-4);
    const auto overlaps = [&](const double s) { return undeformed_distance(wheel, rail, s) < approach; };
    std::vector<Range> ranges;
    bool               inside = false;
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        const bool now = overlaps(points[i]);
        if (now != inside)
          {
            double edge = points[i];
            if (i > 0)
              for (double a = points[i - 1], m = 0.5 * (a + edge); m > a && m < edge; m = 0.5 * (a + edge))
                (overlaps(m) == inside ? a : edge) = m;
            if (now)
              ranges.push_back({edge, points.back()});
            else
              ranges.back().s1 = edge;
          }
        inside = now;
      }
    return ranges;
  }
} // namespace wheelrail
