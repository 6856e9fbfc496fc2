#pragma once

#include <wheelrail/geometry/curve.h>

#include <memory>
#include <vector>

namespace wheelrail
{
  /// A profile curve seen in the frame in which a section is built: x turned to the other side and,
  /// for the wheel, heights turned into radii. A curve that runs to descending profile x then runs
  /// from left to right with the material below it.
  struct MirroredCurve
  {
    std::shared_ptr<const Curve> curve;
    double                       y_factor = 1; ///< 1 rail, -1 wheel
    double                       y_offset = 0; ///< 0 rail, nominal radius of the wheel [m]

    Point2
    position(double t) const;

    /// Unit vector in the running direction.
    Point2
    tangent(double t) const;

    /// Unit vector to the left of the running direction: out of the material for rail heads and
    /// wheel treads.
    Point2
    normal(double t) const;

    /// First parameter in [t0, t1] (t1 < t0: searched backwards) at which the angle of the tangent
    /// [rad, in (-pi, pi]] passes through `angle`; a kink counts as passing through all angles
    /// between its two tangents. Throws InputError that names `what` when there is none.
    double
    find_tangent(double angle, double t0, double t1, const char *what) const;
  };

  /// A stretch of a curve that is walked at constant speed: u from 0 to 1 gives points at equal
  /// spacing on lines and arcs, nearly equal on polynomials (which are walked evenly in x). The
  /// joints of the curve are kept exactly, so that every point lies on the profile.
  class CurveStretch
  {
  public:
    /// From parameter t0 to t1, backwards when t1 < t0.
    CurveStretch(MirroredCurve curve, double t0, double t1);

    double
    parameter(double u) const;

    Point2
    operator()(double u) const;

    double
    length() const
    {
      return distances_.back();
    }

  private:
    MirroredCurve       curve_;
    std::vector<double> parameters_, distances_;
  };
} // namespace wheelrail
