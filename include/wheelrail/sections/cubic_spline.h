#pragma once

#include <cstddef>
#include <vector>

namespace wheelrail
{
  /// What a spline does at its ends: its second derivative is 0, or its third does not jump at the second and
  /// the last but one point, which takes four or more (de Boor 1978).
  enum class SplineEnds
  {
    natural,
    not_a_knot
  };

  /// Second derivatives at the places of the interpolating cubic spline through values; places ascend.
  std::vector<double>
  second_derivatives(const std::vector<double> &places, const std::vector<double> &values, SplineEnds ends);

  /// Values at the places of the natural cubic spline f that makes sum(weight (value - f)^2) + lambda times
  /// the integral of f''^2 least (Reinsch 1967); places ascend.
  std::vector<double>
  smoothed_values(const std::vector<double> &places,
                  const std::vector<double> &values,
                  const std::vector<double> &weights,
                  double                     lambda);

  /// An interpolating cubic spline through four or more points, with SplineEnds::not_a_knot.
  class CubicSpline
  {
  public:
    CubicSpline() = default;

    /// Places ascend; as many values.
    CubicSpline(std::vector<double> places, std::vector<double> values);

    struct Value
    {
      double value = 0, slope = 0;
    };
    /// Beyond the ends the outermost cubics go on.
    Value
    at(double place) const;

    const std::vector<double> &
    places() const
    {
      return places_;
    }

  private:
    std::vector<double> places_, values_, second_;
  };

  /// Value and slope of such a spline at a place as sums of the values at its places times these weights;
  /// those of far places, below 1e-10, are left out.
  struct SplineWeights
  {
    std::size_t         first = 0; ///< place of the first weight
    std::vector<double> value, slope;
  };
  SplineWeights
  spline_weights(const std::vector<double> &places, double place);
} // namespace wheelrail
