#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/segment.h>

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {

    double
    abscissa(const Segment &g, const double f)
    {
      return g.start.x + f * (g.end.x - g.start.x);
    }

    /// Position with the first two derivatives with respect to a parameter.
    struct Motion
    {
      Point2 position, first, second;
    };

    /// Of a polynomial over x, of a spline over u.
    Motion
    motion_on(const Segment &g, const double v)
    {
      const PolynomialValue y = evaluate_polynomial(g.coefficients, v);
      if (g.kind == Segment::Kind::polynomial)
        return {{v, y.value}, {1, y.slope}, {0, y.second}};
      const PolynomialValue x = evaluate_polynomial(g.coefficients_x, v);
      return {{x.value, y.value}, {x.slope, y.slope}, {x.second, y.second}};
    }

    /// Fraction of the polynomial or spline closest to p: stationary points of the distance are
    /// bracketed by samples and refined by Newton steps that never leave their bracket.
    double
    closest_by_samples(const Segment &g, const Point2 &p)
    {
      const auto condition = [&](const double v, double &derivative) {
        const Motion q = motion_on(g, v);
        derivative     = dot(q.first, q.first) + dot(q.position - p, q.second);
        return dot(q.position - p, q.first);
      };
      const auto distance2 = [&](const double v) {
        const Point2 d = motion_on(g, v).position - p;
        return dot(d, d);
      };

      const bool   is_spline = g.kind == Segment::Kind::spline;
      const double begin = is_spline ? 0 : g.start.x, finish = is_spline ? 1 : g.end.x;
      const double low = std::min(begin, finish), high = std::max(begin, finish);
      double       best_v = distance2(low) <= distance2(high) ? low : high;
      double       best   = distance2(best_v), unused;
      const double small  = 1e-17 * (is_spline ? 100 : 1); // u runs over 1, x over millimetres

      const int n  = samples_on(g, 24);
      double    va = low, fa = condition(low, unused);
      for (int i = 1; i <= n; ++i)
        {
          const double vb = low + (high - low) * i / n;
          const double fb = condition(vb, unused);
          if (fa < 0 && fb >= 0)
            {
              double a = va, b = vb, v = 0.5 * (va + vb);
              for (int k = 0; k < 80; ++k)
                {
                  double       derivative;
                  const double f  = condition(v, derivative);
                  (f < 0 ? a : b) = v;
                  double next     = derivative > 0 ? v - f / derivative : 0.5 * (a + b);
                  if (!(next > a && next < b))
                    next = 0.5 * (a + b);
                  const bool done = std::abs(next - v) < small || next == v || b - a < small;
                  v               = next;
                  if (done)
                    break;
                }
              const double d = distance2(v);
              if (d < best)
                {
                  best   = d;
                  best_v = v;
                }
            }
          va = vb;
          fa = fb;
        }
      return std::clamp((best_v - begin) / (finish - begin), 0., 1.);
    }

    bool
    is_straight_or_round(const Segment &g)
    {
      return g.kind == Segment::Kind::line || g.kind == Segment::Kind::arc;
    }

    void
    refuse_polynomial(const Segment &segment, const std::string &verb)
    {
      if (segment.kind == Segment::Kind::polynomial)
        throw InputError("Segment '" + segment.name + "' is a polynomial and cannot be " + verb +
                         "; only lines, arcs and splines can. Give the " + verb +
                         " part of the outline by its own segments.");
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
    if (g.kind == Segment::Kind::spline)
      for (std::vector<double> *c : {&g.coefficients, &g.coefficients_x})
        {
          // sum c_i (1 - u)^i by repeated synthetic division at u = 1, then u to -u
          for (std::size_t k = 0; k < c->size(); ++k)
            for (std::size_t i = c->size() - 1; i > k; --i)
              (*c)[i - 1] += (*c)[i];
          for (std::size_t i = 1; i < c->size(); i += 2)
            (*c)[i] = -(*c)[i];
        }
    return g;
  }


  Segment
  mirrored(const Segment &segment)
  {
    refuse_polynomial(segment, "mirrored");
    Segment g     = segment;
    g.start.x     = -g.start.x;
    g.end.x       = -g.end.x;
    g.centre.x    = -g.centre.x;
    g.angle_start = M_PI - g.angle_start;
    g.angle_end   = M_PI - g.angle_end;
    for (double &c : g.coefficients_x)
      c = -c;
    return g;
  }


  Segment
  moved(const Segment &segment, const Point2 &by)
  {
    refuse_polynomial(segment, "moved");
    Segment g = segment;
    g.start   = g.start + by;
    g.end     = g.end + by;
    g.centre  = g.centre + by;
    if (g.kind == Segment::Kind::spline)
      {
        g.coefficients_x.at(0) += by.x;
        g.coefficients.at(0) += by.y;
      }
    return g;
  }


  Segment
  part_of(const Segment &segment, const double f0, const double f1)
  {
    if (!is_straight_or_round(segment))
      throw InputError("Segment '" + segment.name + "' is neither a line nor an arc and cannot be cut.");
    Segment g     = segment;
    g.start       = position_on(segment, f0);
    g.end         = position_on(segment, f1);
    g.angle_start = segment.angle_start + f0 * (segment.angle_end - segment.angle_start);
    g.angle_end   = segment.angle_start + f1 * (segment.angle_end - segment.angle_start);
    return g;
  }


  Segment
  line_segment(const std::string &name, const Point2 &start, const Point2 &end)
  {
    Segment g;
    g.name  = name;
    g.start = start;
    g.end   = end;
    return g;
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
    if (g.kind == Segment::Kind::spline)
      return {evaluate_polynomial(g.coefficients_x, f).value, evaluate_polynomial(g.coefficients, f).value};
    const double x = abscissa(g, f);
    return {x, evaluate_polynomial(g.coefficients, x).value};
  }


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
    else if (g.kind == Segment::Kind::spline)
      {
        const Motion q     = motion_on(g, f);
        const double speed = norm(q.first);
        point.position     = q.position;
        point.tangent      = (1. / speed) * q.first;
        // (x' y'' - y' x'')/(x'^2 + y'^2)^(3/2)
        point.curvature = cross(q.first, q.second) / (speed * speed * speed);
      }
    else
      {
        const double          x    = abscissa(g, f);
        const PolynomialValue p    = evaluate_polynomial(g.coefficients, x);
        const double          sign = g.end.x > g.start.x ? 1. : -1.;
        const double          w    = std::sqrt(1. + p.slope * p.slope);
        point.position             = {x, p.value};
        point.tangent              = {sign / w, sign * p.slope / w};
        // y''/(1 + y'^2)^(3/2), with the sign of the direction in x
        point.curvature = sign * p.second / (w * w * w);
      }
    return point;
  }


  double
  speed_on(const Segment &g, const double f)
  {
    if (is_straight_or_round(g))
      return length_on(g, 0, 1);
    if (g.kind == Segment::Kind::spline)
      return norm(motion_on(g, f).first);
    const double slope = evaluate_polynomial(g.coefficients, abscissa(g, f)).slope;
    // ds/df, f from 0 to 1 over x
    return std::abs(g.end.x - g.start.x) * std::sqrt(1. + slope * slope);
  }


  double
  length_on(const Segment &g, const double f0, const double f1)
  {
    if (g.kind == Segment::Kind::line)
      return (f1 - f0) * norm(g.end - g.start);
    if (g.kind == Segment::Kind::arc)
      return (f1 - f0) * g.radius * std::abs(g.angle_end - g.angle_start);

    // Four panels of 20 points reach round-off on the longest zone of the standard wheels; a piece
    // of a spline is short.
    const auto speed = [&g](const double f) { return speed_on(g, f); };
    const int  n     = g.kind == Segment::Kind::spline ? 1 : 4;
    double     sum   = 0;
    for (int i = 0; i < n; ++i)
      sum += boost::math::quadrature::gauss<double, 20>::integrate(
        speed, f0 + (f1 - f0) * i / n, f0 + (f1 - f0) * (i + 1) / n);
    return sum;
  }


  double
  advance_on(const Segment &g, const double f0, const double distance)
  {
    if (distance == 0)
      return f0;
    const double length = length_on(g, 0, 1);
    double       f      = std::clamp(f0 + distance / length, 0., 1.);
    if (is_straight_or_round(g))
      return f;
    for (int i = 0; i < 20; ++i)
      {
        const double reached = f >= f0 ? length_on(g, f0, f) : -length_on(g, f, f0);
        // Newton's method for length(f0, f) = distance
        const double step = (distance - reached) / speed_on(g, f);
        f                 = std::clamp(f + step, 0., 1.);
        if (std::abs(step) < 1e-15)
          break;
      }
    return f;
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
        const double delta = std::remainder(std::atan2(p.y - g.centre.y, p.x - g.centre.x) - mid, 2. * M_PI);
        return std::clamp(0.5 * (1. + delta / half), 0., 1.);
      }
    return closest_by_samples(g, p);
  }


  int
  samples_on(const Segment &g, const int full)
  {
    return g.kind == Segment::Kind::spline ? std::max(1, full / 8) : full;
  }
} // namespace wheelrail
