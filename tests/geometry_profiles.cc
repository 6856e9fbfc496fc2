// label: fast

// Curves and standard profiles: elements against the tables of the standards, joints, section
// properties against the catalogue, curve operations against each other.

#include "error_of.h"
#include "near.h"
#include "reference_table.h"
#include "section_properties.h"

#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/profiles.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  const double pi = M_PI;

  double
  degrees_between(const Point2 &a, const Point2 &b)
  {
    return std::atan2(cross(a, b), dot(a, b)) * 180 / pi;
  }

  /// Largest position and tangent jump over the joints of a curve [m, degrees].
  std::pair<double, double>
  worst_joint(const Curve &curve, const bool closed)
  {
    double    jump = 0, kink = 0;
    const int n = curve.segments().size();
    for (int i = closed ? 0 : 1; i < n; ++i)
      {
        const int        before = (i + n - 1) % n;
        const CurvePoint a = curve.at(before + 1 - 1e-13), b = curve.at(i);
        jump = std::max(jump, norm(curve.segments()[before].end - curve.segments()[i].start));
        kink = std::max(kink, std::abs(degrees_between(a.tangent, b.tangent)));
      }
    return {jump, kink};
  }

  void
  test_rail(const std::string &name)
  {
    const RailProfile rail  = rail_profile(name);
    const auto        table = read_table(name + "_elements.csv");
    const auto       &s     = rail.outline.segments();
    BOOST_TEST((s.size() == 2 * table.size()), name + " outline has twice the segments of the table");
    BOOST_TEST(rail.head.segments().size() == 10, name + " head has ten segments");

    double worst_point = 0, worst_centre = 0, worst_radius = 0;
    for (std::size_t i = 0; i < table.size(); ++i)
      {
        const auto number = [&](const int column) { return 1e-3 * std::stod(table[i][column]); };
        BOOST_TEST((s[i].name == table[i][2]), name + " segment '" + s[i].name + "' has its name");
        worst_point = std::max({worst_point,
                                norm(s[i].start - Point2{number(3), number(4)}),
                                norm(s[i].end - Point2{number(5), number(6)})});
        if (s[i].kind == Segment::Kind::arc)
          {
            worst_centre = std::max(worst_centre, norm(s[i].centre - Point2{number(7), number(8)}));
            worst_radius = std::max(worst_radius, std::abs(s[i].radius - number(9)));
          }
      }
    BOOST_TEST(near(worst_point, 0, 1e-12, name + " joints against the table [m]"));
    BOOST_TEST(near(worst_centre, 0, 1e-12, name + " centres against the table [m]"));
    BOOST_TEST(near(worst_radius, 0, 1e-15, name + " radii against the table [m]"));

    const auto outline_joint = worst_joint(rail.outline, true), head_joint = worst_joint(rail.head, false);
    BOOST_TEST(near(std::max(outline_joint.first, head_joint.first), 0, 1e-15, name + " jump at joints [m]"));
    BOOST_TEST(near(outline_joint.second, 0, 1e-9, name + " kink at joints [degrees]"));
    BOOST_TEST(near(head_joint.second, 0, 1e-9, name + " kink at joints of the head [degrees]"));
    BOOST_TEST((rail.head.at(0).position.x > 0 && rail.head.at(5).curvature > 0),
               name + " head runs to the gauge side");
    BOOST_TEST(near(norm(rail.head.at(5).position), 0, 1e-15, name + " head passes over the crown [m]"));
  }

  void
  test_sections()
  {
    const test::SectionProperties a = test::section_properties(rail_profile("54E1").outline);
    BOOST_TEST(near(a.area * 1e6, 6977.4416, 1e-4, "54E1 area [mm2]"));
    BOOST_TEST(near(a.area * 1e6, 6977, 6.977, "54E1 area against the catalogue [mm2]"));
    BOOST_TEST(near((a.centroid.y + 0.159) * 1e3, 75.1279, 1e-4, "54E1 centroid above the base [mm]"));
    BOOST_TEST(near(a.centroid.x, 0, 1e-15, "54E1 centroid on the axis [m]"));
    BOOST_TEST(near(a.Ix * 1e8, 2337.9, 2.3, "54E1 Ix against the catalogue [cm4]"));
    BOOST_TEST(near(a.Ix * 1e8, 2337.8691, 1e-4, "54E1 Ix [cm4]"));
    BOOST_TEST(near(a.Iy * 1e8, 419.0617, 1e-4, "54E1 Iy [cm4]"));

    const test::SectionProperties b = test::section_properties(rail_profile("60E1").outline);
    BOOST_TEST(near(b.area * 1e6, 7670.0002, 1e-4, "60E1 area [mm2]"));
    BOOST_TEST(near((b.centroid.y + 0.172) * 1e3, 80.9235, 1e-4, "60E1 centroid above the base [mm]"));
    BOOST_TEST(near(b.Ix * 1e8, 3038.3127, 1e-4, "60E1 Ix [cm4]"));
    BOOST_TEST(near(b.Iy * 1e8, 512.3049, 1e-4, "60E1 Iy [cm4]"));

    Segment circle;
    circle.kind      = Segment::Kind::arc;
    circle.radius    = 2;
    circle.centre    = {1, 3};
    circle.start     = {3, 3};
    circle.end       = {-1, 3};
    circle.angle_end = pi;
    Segment back     = circle;
    std::swap(back.start, back.end);
    back.angle_start                = pi;
    back.angle_end                  = 2 * pi;
    const test::SectionProperties c = test::section_properties(Curve({circle, back}));
    BOOST_TEST(near(c.area, 4 * pi, 1e-13, "circle: area"));
    BOOST_TEST(near(c.Ix, 4 * pi, 1e-13, "circle: second moment"));
    BOOST_TEST(near(c.centroid.y, 3, 1e-14, "circle: centroid"));
  }

  void
  test_wheel()
  {
    const Curve tread = wheel_profile("S1002").tread;
    const auto &s     = tread.segments();
    const auto  table = read_table("S1002_elements.csv");
    BOOST_TEST((s.size() == table.size() + 1), "S1002 has its eight zones and the chamfer");
    BOOST_TEST(near(
      norm(s[0].start - Point2{0.065, 7.635676380e-3}), 0, 1e-12, "chamfer starts at (65, 7.6357) mm [m]"));
    double worst = 0;
    for (std::size_t i = 1; i < s.size(); ++i)
      {
        const auto &row    = table[table.size() - i];
        const auto  number = [&](const int column) { return 1e-3 * std::stod(row[column]); };
        BOOST_TEST((s[i].name == row[0]), "S1002 zone " + row[0]);
        worst = std::max({worst,
                          norm(s[i].start - Point2{number(3), -number(18)}),
                          norm(s[i].end - Point2{number(2), -number(17)})});
        if (i > 1) // the joint with the zone at the larger x
          {
            const Point2 a = tread.at(i - 1e-13).tangent, b = tread.at(i).tangent;
            BOOST_TEST(near(1e3 * (s[i].start.y - s[i - 1].end.y),
                            1e3 * number(19),
                            1e-9 + std::abs(number(19)), // four digits in the table
                            "joint " + row[0] + "|" + s[i - 1].name + ": jump [mm]"));
            BOOST_TEST(near(degrees_between(a, b),
                            1e3 * number(20),
                            1e-9 + std::abs(number(20)),
                            "joint " + row[0] + "|" + s[i - 1].name + ": kink [deg]"));
          }
      }
    BOOST_TEST(near(worst, 0, 1e-12, "S1002 zone ends against the table [m]"));

    const auto at_height = [&](const double F) {
      return tread.at(tread.roots([F](const Point2 &p) { return p.y + F; }, 4, 7.5).front()).position.x;
    };
    const auto tip = tread.roots([](const Point2 &p) { return p.x + 0.055; }, 1, 9);
    BOOST_TEST(near(-tread.at(tip.at(0)).position.y * 1e3, 28, 1e-9, "flange height [mm]"));
    BOOST_TEST(near((at_height(0.010) + 0.070) * 1e3, 32.5, 5e-4, "flange thickness [mm]"));
    BOOST_TEST(near((at_height(0.010) - at_height(0.026)) * 1e3, 10.794, 5e-4, "flange qR [mm]"));
    const Point2 flank = tread.at(5.5).tangent;
    BOOST_TEST(near(std::atan2(-flank.y, -flank.x) * 180 / pi, 70, 1e-6, "flange angle [deg]"));
  }

  void
  test_curve(const Curve &curve, const std::string &name)
  {
    const double h       = 1e-5;
    double tangent_error = 0, curvature_error = 0, closest_error = 0, advance_error = 0, length_error = 0;
    const double total = curve.length(0, curve.parameter_end());
    for (int i = 0; i < 400; ++i)
      {
        const double t = curve.parameter_end() * (i + 0.5) / 400;
        if (t - std::floor(t) < 2 * h || t - std::floor(t) > 1 - 2 * h)
          continue;
        const CurvePoint p = curve.at(t);
        const CurvePoint a = curve.at(t - h), b = curve.at(t + h);
        tangent_error =
          std::max(tangent_error, std::abs(degrees_between(b.position - a.position, p.tangent)) * pi / 180);
        const double ds = curve.length(t - h, t + h);
        curvature_error = std::max(curvature_error,
                                   std::abs(std::asin(cross(a.tangent, b.tangent)) / ds - p.curvature) /
                                     (1 + std::abs(p.curvature)));
        if (curve.segments()[p.segment].name.find("chamfer") == 0 ||
            norm(p.position - Point2{0.06, 0.0026}) < 1e-3)
          continue; // the kink of the chamfer is nearer to a point beside it
        const double side  = (i % 2 ? 1. : -1.) * 5e-4;
        const Point2 off   = p.position + side * Point2{-p.tangent.y, p.tangent.x};
        const Point2 found = curve.at(curve.closest(off)).position;
        closest_error      = std::max(closest_error, norm(found - p.position));
        const double t2    = curve.advance(t, 0.3 * (total - curve.length(0, t)));
        advance_error =
          std::max(advance_error, std::abs(curve.length(t, t2) - 0.3 * (total - curve.length(0, t))) / total);
        length_error =
          std::max(length_error, std::abs(curve.length(0, t) + curve.length(t, 1e9) - total) / total);
        advance_error = std::max(advance_error, std::abs(curve.advance(t, -curve.length(t / 3, t)) - t / 3));
      }
    BOOST_TEST(near(tangent_error, 0, 1e-6, name + ": tangent against difference quotient [rad]"));
    BOOST_TEST(near(curvature_error, 0, 1e-6, name + ": curvature against turning of the tangent, relative"));
    BOOST_TEST(
      near(closest_error, 0, 1e-13, name + ": closest point to a point 0.5 mm beside the curve [m]"));
    BOOST_TEST(near(advance_error, 0, 1e-12, name + ": advance against length"));
    // round-off of some hundred sums
    BOOST_TEST(near(length_error, 0, 1e-13, name + ": length is additive [m]"));
  }

  void
  test_length()
  {
    const Curve tread = wheel_profile("S1002").tread;
    // Arc length of zone B by Richardson extrapolation of inscribed polygons, as an independent way.
    double a = 0, b = 0;
    for (const int n : {1000, 2000})
      {
        double sum  = 0;
        Point2 last = tread.segments()[2].start;
        for (int i = 1; i <= n; ++i)
          {
            const Point2 next = i == n ? tread.segments()[2].end : tread.at(2. + double(i) / n).position;
            sum += norm(next - last);
            last = next;
          }
        a = b;
        b = sum;
      }
    BOOST_TEST(
      near(tread.length(2, 3) / (b + (b - a) / 3), 1, 1e-12, "length of zone B against polygons, ratio"));
  }

  /// A cone's radius is linear, and its root and flank join without a kink.
  void
  test_cones()
  {
    for (const unsigned int ratio : {20, 40})
      {
        const std::string name  = "cone 1:" + std::to_string(ratio);
        const Curve       tread = wheel_profile(name).tread;
        for (const double x : {0.05, 0., -0.02})
          {
            const double t = tread.roots([x](const Point2 &p) { return p.x - x; }, 1, 2).front();
            BOOST_TEST(near(tread.at(t).position.y, x / ratio, 1e-12, name + " falls to the field side [m]"));
          }
        double jump = 0, kink = 0;
        for (std::size_t i = 2; i < tread.segments().size(); ++i)
          {
            jump = std::max(jump, norm(tread.segments()[i].start - tread.segments()[i - 1].end));
            kink =
              std::max(kink, std::abs(degrees_between(tread.at(i - 1e-13).tangent, tread.at(i).tangent)));
          }
        BOOST_TEST(near(jump, 0, 1e-9, name + ": largest jump of its joints [m]"));
        BOOST_TEST(near(kink, 0, 1e-3, name + ": largest kink [degrees]"));
      }
  }

  void
  test_errors()
  {
    const std::string text = test::error_of<InputError>([&]() { rail_profile("55E1"); });
    BOOST_TEST((text.find("55E1") != std::string::npos && text.find("54E1, 60E1") != std::string::npos),
               "an unknown rail is refused with the known names: " + text);
    Segment a, b;
    a.end                   = {1, 0};
    b.start                 = {1, 0.1};
    b.end                   = {2, 0};
    const std::string apart = test::error_of<InputError>([&]() { Curve curve({a, b}); });
    BOOST_TEST(!apart.empty(), "segments that do not join are refused: " + apart);
  }
} // namespace


BOOST_AUTO_TEST_CASE(geometry_profiles)
{
  test_rail("54E1");
  test_rail("60E1");
  test_sections();
  test_wheel();
  test_curve(rail_profile("54E1").outline, "54E1 outline");
  test_curve(rail_profile("60E1").head, "60E1 head");
  test_curve(wheel_profile("S1002").tread, "S1002");
  test_length();
  test_cones();
  test_errors();
}
