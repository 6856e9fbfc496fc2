// label: fast

// Outliers of measured profiles are judged against their neighbours, whatever their size; kinks of worn
// profiles stay.

#include "near.h"
#include "profile_samples.h"

#include <wheelrail/profiles/profile_file.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace wheelrail;
using test::columns;
using test::near;
using test::sampled;

namespace
{
  using Points = std::vector<Point2>;

  MeasuredProfile
  read(const ProfileKind kind, const Points &points)
  {
    ProfileFileOptions options;
    options.kind = kind;
    return read_profile_text(columns(points), "p.txt", options);
  }

  bool
  tells(const MeasuredProfile &profile, const std::string &part)
  {
    return std::any_of(profile.notes.begin(), profile.notes.end(), [&](const std::string &note) {
      return note.find(part) != std::string::npos;
    });
  }

  double
  distance(const Curve &curve, const Point2 &p)
  {
    return norm(curve.at(curve.closest(p)).position - p);
  }

  double
  largest_distance(const Curve &curve, const Curve &from)
  {
    double worst = 0;
    for (double t = 0; t < curve.parameter_end(); t += 0.25)
      worst = std::max(worst, distance(from, curve.at(t).position));
    return worst;
  }

  Points
  tread(const double noise)
  {
    return sampled(wheel_profile("S1002").tread, 0.5e-3, noise, 5);
  }

  /// One bad point, or two side by side, of every size, at many places.
  BOOST_AUTO_TEST_CASE(test_bad_points)
  {
    for (const ProfileKind kind : {ProfileKind::rail, ProfileKind::wheel})
      {
        const Points base =
          kind == ProfileKind::rail ? test::sampled_head("54E1", 28e-3, 0.5e-3, 5e-6, 6) : tread(5e-6);
        const std::string name  = kind == ProfileKind::rail ? "rail" : "wheel";
        const Curve       clean = read(kind, base).curve;
        for (const double size : {0.2e-3, 0.7e-3, 3e-3, -3e-3, 20e-3})
          {
            double       worst  = 0;
            unsigned int missed = 0;
            for (std::size_t i = 20; i + 20 < base.size(); i += 23)
              {
                Points points = base;
                points[i].y += size;
                if (i % 2 == 0 && std::abs(size) > 2.5e-3)
                  points[i + 1].y += 1.1 * size;
                const MeasuredProfile profile = read(kind, points);
                missed +=
                  !tells(profile, "outlier") && std::abs(size) > 0.5e-3; // less may lie along the outline
                worst = std::max(worst, largest_distance(profile.curve, clean));
              }
            const std::string what = name + " with bad points of " + std::to_string(1e3 * size) + " mm";
            BOOST_TEST(near(missed, 0, 0, what + ": places where they are kept"));
            BOOST_TEST(near(worst, 0, 20e-6, what + ": distance from the curve without them [m]"));
          }
      }
  }

  /// The curve passes through the kink, and no point is dropped.
  void
  check_kink(const Points &points, const Point2 &kink, const double noise, const std::string &what)
  {
    const MeasuredProfile profile = read(ProfileKind::wheel, points);
    BOOST_TEST(!tells(profile, "outlier"), what + ": no point dropped");
    BOOST_TEST(tells(profile, "kept"), what + ": kept");
    BOOST_TEST(near(
      distance(profile.curve, kink), 0, 0.03e-3 + 5 * noise, what + ": distance of the curve from it [m]"));
  }

  BOOST_AUTO_TEST_CASE(test_kinks)
  {
    for (const double noise : {0., 5e-6})
      {
        const std::string with = noise > 0 ? " with noise" : "";
        // a flange worn vertically: an edge of some 70 degrees where the worn face meets the tip
        Points worn;
        for (const Point2 &p : tread(noise))
          worn.push_back(p.y < -8e-3 && p.x > -50e-3 ? Point2{std::min(p.x, -42e-3), p.y} : p);
        const auto edge =
          std::find_if(worn.begin(), worn.end(), [](const Point2 &p) { return p.x == -42e-3; });
        check_kink(worn, *edge, noise, "worn flange" + with);
        // a hollow tread, 2 mm deep up to its edge: the false flange stands on the field side with a wall of
        // 60 degrees
        Points hollow;
        Point2 top;
        for (const Point2 &p : tread(noise))
          {
            const double in = 30e-3 - p.x, deep = std::clamp(std::tan(M_PI / 3) * in, 0., 2e-3);
            hollow.push_back(
              p.x < 30e-3 && p.x > -30e-3 ? p + Point2{0, deep * std::min(1., (p.x + 30e-3) / 20e-3)} : p);
            if (in < 0)
              top = p;
          }
        check_kink(hollow, top, noise, "false flange" + with);
      }
  }
} // namespace
