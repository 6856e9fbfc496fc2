#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/mesh/curve_stretch.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace wheelrail
{
  namespace
  {

    // Difference of two directions in (-pi, pi].
    double
    turn(const double from, const double to)
    {
      return std::remainder(to - from, 2 * M_PI);
    }

    double
    direction(const Point2 &p)
    {
      return std::atan2(p.y, p.x);
    }
  } // namespace


  Point2
  MirroredCurve::position(const double t) const
  {
    const Point2 p = curve->at(t).position;
    return {-p.x, y_offset + y_factor * p.y};
  }


  Point2
  MirroredCurve::tangent(const double t) const
  {
    const Point2 p = curve->at(t).tangent;
    return {-p.x, y_factor * p.y};
  }


  Point2
  MirroredCurve::normal(const double t) const
  {
    const Point2 p = tangent(t);
    return {-p.y, p.x};
  }


  double
  MirroredCurve::find_tangent(const double angle, const double t0, const double t1, const char *what) const
  {
    // 32 samples per segment separate neighbouring arcs; a pass is a change of sign by less than
    // half a turn, so that the jump from -pi to pi on the far side does not count
    const unsigned int n = std::max(1u, static_cast<unsigned int>(32 * std::abs(t1 - t0)));

    double a = t0, fa = turn(angle, direction(tangent(t0)));
    for (unsigned int i = 1; i <= n; ++i)
      {
        double b = t0 + (t1 - t0) * i / n, fb = turn(angle, direction(tangent(b)));
        if (fa == 0)
          return a;
        if (fa * fb <= 0 && std::abs(fa - fb) < M_PI)
          {
            for (unsigned int step = 0; step < 60; ++step)
              {
                const double m = 0.5 * (a + b), fm = turn(angle, direction(tangent(m)));
                (fa * fm <= 0 ? b : a) = m;
              }
            return b;
          }
        a  = b;
        fa = fb;
      }
    throw InputError("The profile has no " + std::string(what) + ": its tangent nowhere has the angle of " +
                     format_number(std::round(angle * 1800 / M_PI) / 10) +
                     " degrees that marks this place. A section needs the complete outline of a rail, or a "
                     "tread from the field side over the flange to its back, without steps.");
  }


  CurveStretch::CurveStretch(MirroredCurve curve, const double t0, const double t1)
    : curve_(std::move(curve))
    , parameters_{t0}
    , distances_{0}
  {
    const double sign = t1 < t0 ? -1 : 1;
    const double low = std::min(t0, t1), high = std::max(t0, t1);
    for (double joint = std::floor(low) + 1; joint < high; ++joint)
      parameters_.push_back(joint);
    if (sign < 0)
      std::sort(parameters_.begin() + 1, parameters_.end(), std::greater<double>());
    parameters_.push_back(t1);

    for (unsigned int i = 1; i < parameters_.size(); ++i)
      distances_.push_back(distances_.back() +
                           curve_.curve->length(std::min(parameters_[i - 1], parameters_[i]),
                                                std::max(parameters_[i - 1], parameters_[i])));
  }


  double
  CurveStretch::parameter(const double u) const
  {
    if (u <= 0)
      return parameters_.front();
    if (u >= 1)
      return parameters_.back();
    const double       distance = u * length();
    const unsigned int i        = std::min<std::ptrdiff_t>(
      std::upper_bound(distances_.begin() + 1, distances_.end(), distance) - distances_.begin(),
      distances_.size() - 1);
    const double fraction = (distance - distances_[i - 1]) / (distances_[i] - distances_[i - 1]);
    return parameters_[i - 1] + fraction * (parameters_[i] - parameters_[i - 1]);
  }


  Point2
  CurveStretch::operator()(const double u) const
  {
    return curve_.position(parameter(u));
  }
} // namespace wheelrail
