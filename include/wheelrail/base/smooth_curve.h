#pragma once

#include <memory>
#include <vector>

namespace wheelrail
{
  /// A number over a coordinate: a constant, a line through two points, or Steffen's (1990) monotone cubics
  /// through three and more, whose slope is continuous and which never leave the range of neighbouring
  /// values. Before the first point and after the last one the value stays.
  class SmoothCurve
  {
  public:
    explicit SmoothCurve(double constant = 0);

    /// Coordinates ascend; as many values.
    SmoothCurve(const std::vector<double> &coordinates, const std::vector<double> &values);

    /// The same values with the other sign.
    SmoothCurve
    mirrored() const;

    double
    at(double x) const;
    double
    slope(double x) const;

  private:
    std::vector<double>         x_, y_;
    std::shared_ptr<const void> interpolation_; ///< of GSL, from two points on
  };
} // namespace wheelrail
