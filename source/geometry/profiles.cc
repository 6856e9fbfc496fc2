#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/profiles.h>
#include <wheelrail/geometry/standard_rails.h>
#include <wheelrail/geometry/standard_wheels.h>

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>
#include <map>

namespace wheelrail
{
  namespace
  {
    const std::map<std::string, RailProfile (*)()>  rails  = {{"54E1", &rail_54E1}, {"60E1", &rail_60E1}};
    const std::map<std::string, WheelProfile (*)()> wheels = {{"S1002", &wheel_S1002},
                                                              {"cone 1:20", []() { return wheel_cone(20); }},
                                                              {"cone 1:40", []() { return wheel_cone(40); }}};

    template <typename Map>
    std::vector<std::string>
    names_of(const Map &map)
    {
      std::vector<std::string> names;
      for (const auto &entry : map)
        names.push_back(entry.first);
      return names;
    }

    template <typename Map>
    auto
    make(const Map &map, const std::string &kind, const std::string &name)
    {
      const auto found = map.find(name);
      if (found != map.end())
        return found->second();
      std::string known;
      for (const auto &entry : map)
        known += (known.empty() ? "" : ", ") + entry.first;
      throw InputError("There is no standard " + kind + " profile named '" + name + "'. Known are: " + known +
                       ".");
    }

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
  } // namespace


  SectionProperties
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


  std::vector<std::string>
  standard_rails()
  {
    return names_of(rails);
  }


  std::vector<std::string>
  standard_wheels()
  {
    return names_of(wheels);
  }


  RailProfile
  rail_profile(const std::string &name)
  {
    return make(rails, "rail", name);
  }


  WheelProfile
  wheel_profile(const std::string &name)
  {
    return make(wheels, "wheel", name);
  }
} // namespace wheelrail
