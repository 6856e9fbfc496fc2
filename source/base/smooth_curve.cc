#include <wheelrail/base/smooth_curve.h>

#include <gsl/gsl_interp.h>

#include <algorithm>

namespace wheelrail
{
  namespace
  {
    const gsl_interp *
    of(const std::shared_ptr<const void> &interpolation)
    {
      return static_cast<const gsl_interp *>(interpolation.get());
    }
  } // namespace


  SmoothCurve::SmoothCurve(const double constant)
    : x_{0}
    , y_{constant}
  {
  }


  SmoothCurve::SmoothCurve(const std::vector<double> &coordinates, const std::vector<double> &values)
    : x_(coordinates)
    , y_(values)
  {
    if (x_.size() < 2)
      return;
    gsl_interp *const made =
      gsl_interp_alloc(x_.size() == 2 ? gsl_interp_linear : gsl_interp_steffen, x_.size());
    interpolation_ = std::shared_ptr<const void>(static_cast<const void *>(made),
                                                 [made](const void *) { gsl_interp_free(made); });
    gsl_interp_init(made, x_.data(), y_.data(), x_.size());
  }


  SmoothCurve
  SmoothCurve::mirrored() const
  {
    std::vector<double> values;
    for (const double y : y_)
      values.push_back(-y);
    return interpolation_ ? SmoothCurve(x_, values) : SmoothCurve(values.front());
  }


  double
  SmoothCurve::at(const double x) const
  {
    if (!interpolation_)
      return y_.front();
    return gsl_interp_eval(
      of(interpolation_), x_.data(), y_.data(), std::clamp(x, x_.front(), x_.back()), nullptr);
  }


  double
  SmoothCurve::slope(const double x) const
  {
    if (!interpolation_ || x < x_.front() || x > x_.back())
      return 0;
    return gsl_interp_eval_deriv(of(interpolation_), x_.data(), y_.data(), x, nullptr);
  }
} // namespace wheelrail
