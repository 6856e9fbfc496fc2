#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/curve.h>

#include <algorithm>
#include <limits>
#include <string>

// A row of segments, t = segment + fraction: points, lengths, closest points and places at a level
// (doc/theory/geometry.md, Curves).

namespace wheelrail
{
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
        // between two samples a curve is no farther from them than its own length
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
        // the box of a segment lies farther than the best point so far
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
    bool                first = true, positive_before = false;
    for (int i = 0; i < static_cast<int>(segments_.size()); ++i)
      {
        const double f0 = std::clamp(t0 - i, 0., 1.), f1 = std::clamp(t1 - i, 0., 1.);
        if (f1 <= f0)
          continue;
        const int intervals = samples_on(segments_[i], 64);
        double    fa        = f0;
        bool      pa        = level(position_on(segments_[i], fa)) >= 0;
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
