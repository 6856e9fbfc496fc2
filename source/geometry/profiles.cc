#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/profiles.h>
#include <wheelrail/geometry/standard_rails.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace wheelrail
{
  namespace
  {
    // Dimensions in this file are those of the standard, in millimetres: F(x) is the radius
    // increment, positive downwards, x is positive to the field side.

    /// Zone F(x) = sum c_i x^i, run from the field side to the flange; a line when only c_0, c_1.
    Segment
    polynomial_zone(const char *name, const double x_start, const double x_end, const std::vector<double> &c)
    {
      Segment g;
      g.name       = name;
      g.kind       = c.size() > 2 ? Segment::Kind::polynomial : Segment::Kind::line;
      double scale = 1e-3; // y[m] = -1e-3 F(1e3 x[m])
      for (const double ci : c)
        {
          g.coefficients.push_back(-scale * ci);
          scale *= 1e3;
        }
      g.start = {1e-3 * x_start, evaluate_polynomial(g.coefficients, 1e-3 * x_start).value};
      g.end   = {1e-3 * x_end, evaluate_polynomial(g.coefficients, 1e-3 * x_end).value};
      if (g.kind == Segment::Kind::line)
        g.coefficients.clear();
      return g;
    }

    /// Zone F(x) = zc + sign sqrt(R^2 - (x - xc)^2): sign +1 is the convex lower half of a circle
    /// in the y-up frame, -1 the concave upper half.
    Segment
    arc_zone(const char  *name,
             const double x_start,
             const double x_end,
             const double xc,
             const double zc,
             const double R,
             const int    sign)
    {
      Segment g;
      g.name           = name;
      g.kind           = Segment::Kind::arc;
      g.centre         = {1e-3 * xc, -1e-3 * zc};
      g.radius         = 1e-3 * R;
      const auto polar = [&](const double x) { return -sign * std::acos(std::clamp((x - xc) / R, -1., 1.)); };
      g.angle_start    = polar(x_start);
      g.angle_end      = polar(x_end);
      const auto point = [&g](const double a) {
        return g.centre + g.radius * Point2{std::cos(a), std::sin(a)};
      };
      g.start = point(g.angle_start);
      g.end   = point(g.angle_end);
      return g;
    }

    // Ends of the zones of S1002, from the field side of the tread to the flange back, and the flank.
    constexpr double x_A = 60, x_B = 32.15796, x_C = -26, x_D = -35, x_E = -38.426669071, x_F = -39.764473993,
                     x_G = -49.662510381, x_H = -62.764705882, x_back = -70;
    constexpr double flank = -93.576667419, flank_slope = -2.747477419;

    Segment
    chamfer_before(const Segment &tread)
    {
      Segment chamfer;
      chamfer.name  = "chamfer 5 x 5";
      chamfer.start = tread.start + Point2{5e-3, 5e-3};
      chamfer.end   = tread.start;
      return chamfer;
    }

    Segment
    zone_F()
    {
      return arc_zone("F", x_F, x_G, -58.558326413, 8.834924130, 20, 1);
    }
    Segment
    zone_G()
    {
      return arc_zone("G", x_G, x_H, -55, 16, 12, 1);
    }
    Segment
    zone_H()
    {
      return arc_zone("H", x_H, x_back, -49.5, 9.519259302, 20.5, 1);
    }

    /// Wheel profile S1002 with flange height 28 mm and flange thickness 32.5 mm, for a rim 135 mm
    /// wide: zones A to H and the 5 mm x 5 mm chamfer at the field side (EN 13715, UIC 510-2). The
    /// published coefficients leave a jump of 0.12 micrometres and 0.00024 degrees between zones D
    /// and C; it is kept.
    WheelProfile
    wheel_S1002()
    {
      const Segment tread_end = polynomial_zone("A", x_A, x_B, {1.364323640, -0.066666667});

      WheelProfile wheel;
      wheel.name  = "S1002";
      wheel.tread = Curve({chamfer_before(tread_end),
                           tread_end,
                           polynomial_zone("B",
                                           x_B,
                                           x_C,
                                           {0,
                                            -0.03358537058,
                                            0.001565681624,
                                            -2.810427944e-5,
                                            5.844240864e-8,
                                            -1.562379023e-8,
                                            5.309217349e-15,
                                            -5.957839843e-12,
                                            2.646656573e-13}),
                           polynomial_zone("C",
                                           x_C,
                                           x_D,
                                           {-4320.221063,
                                            -1038.384026,
                                            -106.5501873,
                                            -6.051367875,
                                            -0.2054332446,
                                            -0.004169739389,
                                            -4.687195829e-5,
                                            -2.25275554e-7}),
                           arc_zone("D", x_D, x_E, -26.210665, 16.446, 13, -1),
                           polynomial_zone("E", x_E, x_F, {flank, flank_slope}),
                           zone_F(),
                           zone_G(),
                           zone_H()});
      return wheel;
    }

    /// A cone 1:`ratio` through the running circle with the flank, the tip and the back of the flange of
    /// S1002, which a root of 13 mm radius joins: no profile of a standard, but the wheel of textbooks, whose
    /// rolling radius is known in closed form.
    WheelProfile
    wheel_cone(const unsigned int ratio)
    {
      // The circle of the root touches the tread F = -m x and the flank F = a + b x of S1002, so that its
      // centre lies R off both.
      constexpr double R = 13, a = flank, b = flank_slope;
      const double     m = 1. / ratio, tread = std::sqrt(1 + m * m), side = std::sqrt(1 + b * b);
      const double     xc = (R * tread - a - R * side) / (m + b), zc = R * tread - m * xc;
      const double     x_tread = xc - R * m / tread, x_flank = xc + R * b / side;

      const Segment cone = polynomial_zone("tread", x_A, x_tread, {0, -m});
      WheelProfile  wheel;
      wheel.name  = "cone 1:" + std::to_string(ratio);
      wheel.tread = Curve({chamfer_before(cone),
                           cone,
                           arc_zone("root R13", x_tread, x_flank, xc, zc, R, -1),
                           polynomial_zone("E", x_flank, x_F, {a, b}),
                           zone_F(),
                           zone_G(),
                           zone_H()});
      return wheel;
    }

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
  } // namespace


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
