#pragma once

#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/curve.h>

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>
#include <string>

namespace test
{
  using namespace wheelrail;

  /// Section properties of a closed outline [SI].
  struct SectionProperties
  {
    double area = 0; ///< [m2]
    Point2 centroid; ///< [m]
    double Ix = 0;   ///< second moment about the horizontal axis through the centroid [m4]
    double Iy = 0;   ///< about the vertical axis through the centroid [m4]
  };

  /// Integral over the curve of f(position, dx/dt, dy/dt) dt.
  template <typename Function>
  double
  integrate(const Curve &curve, const Function &f)
  {
    double sum = 0;
    for (std::size_t i = 0; i < curve.segments().size(); ++i)
      {
        const Segment &g = curve.segments()[i];
        sum += boost::math::quadrature::gauss<double, 20>::integrate(
          [&](const double fraction) {
            const CurvePoint p     = point_on(g, fraction);
            const double     speed = speed_on(g, fraction);
            return f(p.position, speed * p.tangent.x, speed * p.tangent.y);
          },
          0.,
          1.);
      }
    return sum;
  }

  /// Properties by Green's theorem over the exact segments (Gauss quadrature to round-off); the
  /// outline may run in either sense. Throws InputError when the outline is not closed to 1e-6 m.
  inline SectionProperties
  section_properties(const Curve &closed_outline)
  {
    const double gap = norm(closed_outline.at(0).position - closed_outline.segments().back().end);
    if (gap > 1e-6)
      throw InputError("A section outline is open: its end lies " + std::to_string(1e3 * gap) +
                       " mm from its start. Close it to compute area and second moments.");

    const auto   over = [&](const auto &f) { return integrate(closed_outline, f); };
    const double signed_area =
      0.5 * over([](const Point2 &p, double dx, double dy) { return p.x * dy - p.y * dx; });
    const double turn = signed_area > 0 ? 1. : -1.;

    SectionProperties s;
    s.area = turn * signed_area;
    s.centroid.x =
      turn * over([](const Point2 &p, double, double dy) { return 0.5 * p.x * p.x * dy; }) / s.area;
    s.centroid.y =
      -turn * over([](const Point2 &p, double dx, double) { return 0.5 * p.y * p.y * dx; }) / s.area;
    // Moments are taken about the centroid at once: no cancellation.
    const Point2 c = s.centroid;
    s.Ix = -turn * over([&](const Point2 &p, double dx, double) { return std::pow(p.y - c.y, 3) / 3. * dx; });
    s.Iy = turn * over([&](const Point2 &p, double, double dy) { return std::pow(p.x - c.x, 3) / 3. * dy; });
    return s;
  }
} // namespace test
