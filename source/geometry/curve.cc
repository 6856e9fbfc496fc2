#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/curve.h>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <limits>

namespace wheelrail
{
  namespace
  {
    constexpr double pi = 3.14159265358979323846;

    double
    abscissa(const Segment &g, const double f)
    {
      return g.start.x + f * (g.end.x - g.start.x);
    }

    Point2
    position_on(const Segment &g, const double f)
    {
      if (g.kind == Segment::Kind::line)
        return g.start + f * (g.end - g.start);
      if (g.kind == Segment::Kind::arc)
        {
          const double a = g.angle_start + f * (g.angle_end - g.angle_start);
          return {g.centre.x + g.radius * std::cos(a), g.centre.y + g.radius * std::sin(a)};
        }
      const double x = abscissa(g, f);
      return {x, evaluate_polynomial(g.coefficients, x).value};
    }

    /// Position, tangent and curvature at the fraction f of the segment.
    CurvePoint
    point_on(const Segment &g, const double f)
    {
      CurvePoint point;
      if (g.kind == Segment::Kind::line)
        {
          const Point2 d = g.end - g.start;
          point.position = g.start + f * d;
          point.tangent  = (1. / norm(d)) * d;
        }
      else if (g.kind == Segment::Kind::arc)
        {
          const double a = g.angle_start + f * (g.angle_end - g.angle_start);
          const double c = std::cos(a), s = std::sin(a);
          const double turn = g.angle_end > g.angle_start ? 1. : -1.;
          point.position    = {g.centre.x + g.radius * c, g.centre.y + g.radius * s};
          point.tangent     = {-turn * s, turn * c};
          point.curvature   = turn / g.radius;
        }
      else
        {
          const double          x    = abscissa(g, f);
          const PolynomialValue p    = evaluate_polynomial(g.coefficients, x);
          const double          sign = g.end.x > g.start.x ? 1. : -1.;
          const double          w    = std::sqrt(1. + p.slope * p.slope);
          point.position             = {x, p.value};
          point.tangent              = {sign / w, sign * p.slope / w};
          point.curvature            = sign * p.second / (w * w * w);
        }
      return point;
    }

    /// Arc length between the fractions f0 and f1 of a segment [m], f1 >= f0.
    double
    length_on(const Segment &g, const double f0, const double f1)
    {
      if (g.kind == Segment::Kind::line)
        return (f1 - f0) * norm(g.end - g.start);
      if (g.kind == Segment::Kind::arc)
        return (f1 - f0) * g.radius * std::abs(g.angle_end - g.angle_start);

      const auto speed = [&g](const double x) {
        const double slope = evaluate_polynomial(g.coefficients, x).slope;
        return std::sqrt(1. + slope * slope);
      };
      // Four panels of 20 points reach round-off on the longest zone of the standard wheels.
      const int n   = 4;
      double    sum = 0;
      for (int i = 0; i < n; ++i)
        {
          const double x0 = abscissa(g, f0 + (f1 - f0) * i / n);
          const double x1 = abscissa(g, f0 + (f1 - f0) * (i + 1) / n);
          sum +=
            boost::math::quadrature::gauss<double, 20>::integrate(speed, std::min(x0, x1), std::max(x0, x1));
        }
      return sum;
    }

    /// Fraction of the segment at arc length `distance` beyond f0; the end must lie within it.
    double
    advance_on(const Segment &g, const double f0, const double distance)
    {
      if (distance == 0)
        return f0;
      if (g.kind != Segment::Kind::polynomial)
        return std::clamp(f0 + distance / length_on(g, 0, 1), 0., 1.);

      const double width = std::abs(g.end.x - g.start.x);
      double       f     = std::clamp(f0 + distance / length_on(g, 0, 1), 0., 1.);
      for (int i = 0; i < 20; ++i)
        {
          const double reached = f >= f0 ? length_on(g, f0, f) : -length_on(g, f, f0);
          const double slope   = evaluate_polynomial(g.coefficients, abscissa(g, f)).slope;
          const double step    = (distance - reached) / (width * std::sqrt(1. + slope * slope));
          f                    = std::clamp(f + step, 0., 1.);
          if (std::abs(step) < 1e-15)
            break;
        }
      return f;
    }

    /// Fraction of the polynomial closest to p: stationary points of the distance are bracketed
    /// by samples and refined by Newton steps that never leave their bracket.
    double
    closest_on_polynomial(const Segment &g, const Point2 &p)
    {
      const auto condition = [&](const double x, double &derivative) {
        const PolynomialValue q = evaluate_polynomial(g.coefficients, x);
        derivative              = 1. + q.slope * q.slope + (q.value - p.y) * q.second;
        return x - p.x + (q.value - p.y) * q.slope;
      };
      const auto distance2 = [&](const double x) {
        const Point2 d = Point2{x, evaluate_polynomial(g.coefficients, x).value} - p;
        return dot(d, d);
      };

      const double low = std::min(g.start.x, g.end.x), high = std::max(g.start.x, g.end.x);
      double       best_x = distance2(low) <= distance2(high) ? low : high;
      double       best   = distance2(best_x), unused;

      const int n  = 24;
      double    xa = low, va = condition(low, unused);
      for (int i = 1; i <= n; ++i)
        {
          const double xb = low + (high - low) * i / n;
          const double vb = condition(xb, unused);
          if (va < 0 && vb >= 0)
            {
              double a = xa, b = xb, x = 0.5 * (xa + xb);
              for (int k = 0; k < 80; ++k)
                {
                  double       derivative;
                  const double v  = condition(x, derivative);
                  (v < 0 ? a : b) = x;
                  double next     = derivative > 0 ? x - v / derivative : 0.5 * (a + b);
                  if (!(next > a && next < b))
                    next = 0.5 * (a + b);
                  const bool done = std::abs(next - x) < 1e-17 || next == x || b - a < 1e-17;
                  x               = next;
                  if (done)
                    break;
                }
              const double d = distance2(x);
              if (d < best)
                {
                  best   = d;
                  best_x = x;
                }
            }
          xa = xb;
          va = vb;
        }
      return std::clamp((best_x - g.start.x) / (g.end.x - g.start.x), 0., 1.);
    }

    double
    closest_on(const Segment &g, const Point2 &p)
    {
      if (g.kind == Segment::Kind::line)
        {
          const Point2 d = g.end - g.start;
          return std::clamp(dot(p - g.start, d) / dot(d, d), 0., 1.);
        }
      if (g.kind == Segment::Kind::arc)
        {
          const double half  = 0.5 * (g.angle_end - g.angle_start);
          const double mid   = 0.5 * (g.angle_end + g.angle_start);
          const double delta = std::remainder(std::atan2(p.y - g.centre.y, p.x - g.centre.x) - mid, 2. * pi);
          return std::clamp(0.5 * (1. + delta / half), 0., 1.);
        }
      return closest_on_polynomial(g, p);
    }
  } // namespace


  PolynomialValue
  evaluate_polynomial(const std::vector<double> &coefficients, const double x)
  {
    PolynomialValue p;
    double          half_second = 0;
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c)
      {
        half_second = half_second * x + p.slope;
        p.slope     = p.slope * x + p.value;
        p.value     = p.value * x + *c;
      }
    p.second = 2. * half_second;
    return p;
  }


  Segment
  reversed(const Segment &segment)
  {
    Segment g = segment;
    std::swap(g.start, g.end);
    std::swap(g.angle_start, g.angle_end);
    return g;
  }


  Segment
  mirrored(const Segment &segment)
  {
    if (segment.kind == Segment::Kind::polynomial)
      throw InputError("Segment '" + segment.name +
                       "' is a polynomial and cannot be mirrored; only lines and arcs can. Give the mirrored "
                       "half of the outline by its own segments.");
    Segment g     = segment;
    g.start.x     = -g.start.x;
    g.end.x       = -g.end.x;
    g.centre.x    = -g.centre.x;
    g.angle_start = pi - g.angle_start;
    g.angle_end   = pi - g.angle_end;
    return g;
  }


  Curve::Curve(std::vector<Segment> segments)
    : segments_(std::move(segments))
  {
    for (std::size_t i = 0; i < segments_.size(); ++i)
      {
        const Segment &g = segments_[i];
        const double   l = length_on(g, 0, 1);
        if (!(l > 0))
          throw InputError("Segment " + std::to_string(i) + " '" + g.name +
                           "' of a profile has no length. Leave it out or correct its end points.");
        if (i > 0 && norm(g.start - segments_[i - 1].end) > 1e-6)
          throw InputError("Segments " + std::to_string(i - 1) + " '" + segments_[i - 1].name + "' and " +
                           std::to_string(i) + " '" + g.name + "' of a profile are " +
                           std::to_string(1e3 * norm(g.start - segments_[i - 1].end)) +
                           " mm apart; at most 0.001 mm is accepted. Correct their end points.");
        lengths_.push_back(l);

        // A sampled box enlarged by the sagitta that a sample interval can hide.
        Box       box{g.start, g.start};
        const int n = 32;
        for (int k = 0; k <= n; ++k)
          {
            const Point2 p = position_on(g, static_cast<double>(k) / n);
            box.low        = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
            box.high       = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
          }
        const double margin = l / n;
        boxes_.push_back({box.low - Point2{margin, margin}, box.high + Point2{margin, margin}});
      }
  }


  CurvePoint
  Curve::at(const double t) const
  {
    const int    n       = static_cast<int>(segments_.size());
    const double clamped = std::clamp(t, 0., parameter_end());
    const int    i       = std::min(static_cast<int>(clamped), n - 1);
    CurvePoint   point   = point_on(segments_[i], clamped - i);
    point.segment        = i;
    return point;
  }


  double
  Curve::length(const double t0, const double t1) const
  {
    double sum = 0;
    for (int i = 0; i < static_cast<int>(segments_.size()); ++i)
      {
        const double f0 = std::clamp(t0 - i, 0., 1.), f1 = std::clamp(t1 - i, 0., 1.);
        if (f0 == 0 && f1 == 1)
          sum += lengths_[i];
        else if (f1 > f0)
          sum += length_on(segments_[i], f0, f1);
      }
    return sum;
  }


  double
  Curve::advance(const double t0, const double distance) const
  {
    const int    n       = static_cast<int>(segments_.size());
    const double clamped = std::clamp(t0, 0., parameter_end());
    int          i       = std::min(static_cast<int>(clamped), n - 1);
    double       f       = clamped - i;
    double       rest    = distance;
    if (rest >= 0)
      for (; i < n; ++i, f = 0)
        {
          const double available = f == 0 ? lengths_[i] : length_on(segments_[i], f, 1);
          if (rest <= available)
            return i + advance_on(segments_[i], f, rest);
          rest -= available;
        }
    else
      for (; i >= 0; --i, f = 1)
        {
          const double available = f == 1 ? lengths_[i] : length_on(segments_[i], 0, f);
          if (-rest <= available)
            return i + advance_on(segments_[i], f, rest);
          rest += available;
        }
    return distance >= 0 ? parameter_end() : 0.;
  }


  double
  Curve::closest(const Point2 &p) const
  {
    double best = std::numeric_limits<double>::max(), t = 0;
    for (std::size_t i = 0; i < segments_.size(); ++i)
      {
        const Box   &b  = boxes_[i];
        const double dx = std::max({b.low.x - p.x, 0., p.x - b.high.x});
        const double dy = std::max({b.low.y - p.y, 0., p.y - b.high.y});
        if (dx * dx + dy * dy >= best)
          continue;
        const double f = closest_on(segments_[i], p);
        const Point2 d = position_on(segments_[i], f) - p;
        if (dot(d, d) < best)
          {
            best = dot(d, d);
            t    = static_cast<double>(i) + f;
          }
      }
    return t;
  }


  std::vector<double>
  Curve::roots(const std::function<double(const Point2 &)> &level, const double t0, const double t1) const
  {
    std::vector<double> result;
    const int           intervals = 64;
    bool                first = true, positive_before = false;
    for (int i = 0; i < static_cast<int>(segments_.size()); ++i)
      {
        const double f0 = std::clamp(t0 - i, 0., 1.), f1 = std::clamp(t1 - i, 0., 1.);
        if (f1 <= f0)
          continue;
        double fa = f0;
        bool   pa = level(position_on(segments_[i], fa)) >= 0;
        if (!first && pa != positive_before)
          result.push_back(i); // the change sits in the jump of the joint
        for (int k = 1; k <= intervals; ++k)
          {
            const double fb = k == intervals ? f1 : f0 + (f1 - f0) * k / intervals;
            const bool   pb = level(position_on(segments_[i], fb)) >= 0;
            if (pa != pb)
              {
                double a = fa, b = fb;
                for (double m = 0.5 * (a + b); m > a && m < b; m = 0.5 * (a + b))
                  ((level(position_on(segments_[i], m)) >= 0) == pa ? a : b) = m;
                result.push_back(i + b);
              }
            fa = fb;
            pa = pb;
          }
        positive_before = pa;
        first           = false;
      }
    return result;
  }
} // namespace wheelrail
