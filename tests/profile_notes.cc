// label: fast

// What a run tells about profile files: everything that is done to the points and to the curve, word by
// word and nothing else.

#include "near.h"
#include "profile_samples.h"

#include <wheelrail/profiles/measured_profiles.h>

#include <algorithm>
#include <cctype>
#include <random>
#include <string>
#include <vector>

using namespace wheelrail;
using test::columns;
using test::same_text;
using test::sampled;
using test::sampled_head;

namespace
{
  using Points = std::vector<Point2>;

  /// The notes in lines. What smoothing finds is the solution of an equation in floating point numbers:
  /// the numbers of its note are left out.
  std::string
  lines(const std::vector<std::string> &notes)
  {
    std::string text;
    for (std::string note : notes)
      {
        if (note.find(" smoothed; ") != std::string::npos)
          note.erase(
            std::remove_if(note.begin(),
                           note.end(),
                           [](const unsigned char c) { return std::isdigit(c) || c == '.' || c == '-'; }),
            note.end());
        text += note + "\n";
      }
    return text;
  }

  const std::string smoothed =
    "noise of  um found in the points smoothed; the curve lies at most  um off "
    "the points\n";

  /// What is told about a rail file whose head is joined to a body.
  void
  check_rail(const std::string &text,
             const std::string &expected,
             const std::string &what,
             ProfileFileOptions options = {},
             const std::string &body    = "auto")
  {
    options.kind            = ProfileKind::rail;
    MeasuredProfile profile = read_profile_text(text, "r.txt", options);
    measured_rail(profile, body, profile.notes);
    BOOST_TEST(same_text(lines(profile.notes), expected, what));
  }

  void
  check_wheel(const std::string &text,
              const std::string &expected,
              const std::string &what,
              ProfileFileOptions options = {})
  {
    options.kind            = ProfileKind::wheel;
    MeasuredProfile profile = read_profile_text(text, "w.txt", options);
    measured_wheel(profile, 0.135, profile.notes);
    BOOST_TEST(same_text(lines(profile.notes), expected, what));
  }

  Points
  tread()
  {
    return sampled(wheel_profile("S1002").tread, 0.5e-3, 0, 1);
  }

  std::string
  simpack(const std::string &orders, const std::string &points)
  {
    return "header.begin\nversion = 1\nheader.end\nspline.begin\n" + orders + "point.begin\n" + points +
           "point.end\nspline.end\n";
  }

  // What is told of every rail, or of those that show nothing special.
  const std::string in_order =
    "not mirrored: x taken as positive to the field side; Profiles/Rail mirror changes it\n";
  const std::string as_54E1 =
    "body of the rail: 54E1, whose head is as wide; Profiles/Rail body changes it\n";
  const std::string in_place =
    "origin of the file kept: top at y = 0 mm of 54E1\n"
    "joined to the sides of 54E1 29.9 mm (field side) and 29.9 mm (gauge side) below its top; below that it "
    "is the body\n";
  const std::string rest = smoothed + as_54E1 + in_place;

  BOOST_AUTO_TEST_CASE(test_units)
  {
    check_rail(columns(sampled_head()),
               "two columns, 231 points\n"
               "unit taken as mm, since the profile then is 71.6 mm wide; Profiles/Rail unit changes it\n" +
                 in_order + rest,
               "a rail in two columns");
    check_rail("x (mm) y\n" + columns(sampled_head()),
               "two columns, 231 points\nunit mm as the file states\n" + in_order + rest,
               "a unit in the heading");
    ProfileFileOptions metres;
    metres.unit = ProfileUnit::metre;
    check_rail("x (mm) y\n" + columns(sampled_head(), 1, 1),
               "two columns, 231 points\nunit m by Profiles/Rail unit, though the file states mm\n" +
                 in_order + rest,
               "a heading that is wrong",
               metres);
    const double inch = 1 / 0.0254;
    check_rail(simpack("units.len.f = 39.37007874\n", columns(sampled_head(), inch, inch)),
               "SIMPACK, 231 points\nunit 25.4 mm as the file states\n" + in_order + rest,
               "inches by units.len.f");
    ProfileFileOptions all;
    all.mirror = ProfileMirror::yes;
    all.unit   = ProfileUnit::millimetre;
    all.noise  = 5e-6;
    check_rail(columns(sampled_head()),
               "two columns, 231 points\nunit mm by Profiles/Rail unit\n"
               "mirrored: Profiles/Rail mirror = yes\norder of the points reversed\n"
               "noise of  um by Profiles/Smoothing smoothed; the curve lies at most  um off the points\n" +
                 in_place,
               "all entries set",
               all,
               "54E1");
  }

  std::string
  with_third_column(const Points &points, const std::string &value)
  {
    std::string text;
    for (const Point2 &p : points)
      {
        text += columns({p});
        text.insert(text.size() - 1, " " + value);
      }
    return text;
  }

  BOOST_AUTO_TEST_CASE(test_formats)
  {
    check_rail(with_third_column(sampled_head(), "7"),
               "two columns, 231 points\nthird column of the file left out\n"
               "unit taken as mm, since the profile then is 71.6 mm wide; Profiles/Rail unit changes it\n" +
                 in_order + rest,
               "a third column");
    check_rail(simpack("units.len.f = 1000\n", "0 0 0\n" + with_third_column(sampled_head(), "1")),
               "SIMPACK, 232 points\n1 point of weight 0 dropped\nunit mm as the file states\n" + in_order +
                 rest,
               "a point of weight 0");
    check_rail(
      simpack("units.len.f = 1000\n", with_third_column(sampled_head(), "0.5")),
      "SIMPACK, 231 points\n231 weights other than 0 and 1 taken as 1\nunit mm as the file states\n" +
        in_order + rest,
      "weights of one half");
    check_rail(
      "ProgramName=x\nXOffset=1\nTilt=0.1\nYOffset=2\nColumnDef=X,Y\n\n" + columns(sampled_head()),
      "MiniProf, 231 points\nXOffset of the file is taken as applied already\n"
      "YOffset of the file is taken as applied already\nTilt of the file is taken as applied already\n"
      "unit mm as the file states\n"
      "mirrored: files of this format have the gauge side on the right; Profiles/Rail mirror changes "
      "it\norder of the points reversed\n" +
        rest,
      "a MiniProf rail");
  }

  // A symmetric head that was moved, turned over and mirrored comes back to its place by what the header
  // orders.
  BOOST_AUTO_TEST_CASE(test_simpack_orders)
  {
    Points points = sampled_head();
    points.insert(points.begin() + 1, points.front() + Point2{0, 3e-6});
    check_rail(
      simpack("units.len.f = 1000\npoint.dist.min = 0.01\nshift.y = 2\nshift.z = 1\n"
              "mirror.y = 1\nmirror.z = 1\ninversion = 1\n",
              columns(points)),
      "SIMPACK, 232 points\n1 point nearer than point.dist.min of the file dropped\n"
      "moved by shift.y = 2 and shift.z = 1 of the file\nmirrored by mirror.y and mirror.z of the file\n"
      "order of the points reversed by inversion of the file\nunit mm as the file states\n"
      "turned upside down: the vertical coordinate of the file points down\n" +
        in_order + smoothed + as_54E1 +
        "moved by 2 mm and -1 mm: top to y = 0, field side of the head to that of 54E1\n"
        "joined to the sides of 54E1 29.9 mm (field side) and 29.9 mm (gauge side) below its top; "
        "below that it is the body\n",
      "moved and mirrored by the header");
    check_rail(
      simpack("units.len.f = 1000\nrotate = 0.001\nbound.y.min = -50\nbound.y.max = 30\n"
              "bound.z.min = -29\nbound.z.max = 5\n",
              columns(sampled_head())),
      "SIMPACK, 231 points\nturned by rotate = 0.001 of the file\n54 points outside bound.y.min and "
      ".max of the file dropped\n"
      "2 points outside bound.z.min and .max of the file dropped\nunit mm as the file states\n" +
        in_order + smoothed +
        "body of the rail: 54E1, whose outline lies 0.02 mm off the points on average, the nearest one; "
        "Profiles/Rail body changes it\norigin of the file kept: top at y = 0 mm of 54E1\n"
        "joined to the sides of 54E1 4.4 mm (field side) and 28.9 mm (gauge side) below its top; "
        "below that it is the body\n",
      "turned and cut by the header");
  }

  BOOST_AUTO_TEST_CASE(test_order_and_place)
  {
    Points       points = sampled_head();
    std::mt19937 random(1);
    for (std::size_t i = points.size() - 1; i > 0; --i)
      std::swap(points[i], points[random() % (i + 1)]);
    const std::string begin =
      "two columns, 231 points\n"
      "unit taken as mm, since the profile then is 71.6 mm wide; Profiles/Rail unit changes it\n";
    check_rail(columns(points),
               begin +
                 "the points, listed in no order along the outline, sorted by the lateral coordinate\n" +
                 in_order + "order of the points reversed\n" + rest,
               "points in no order");
    points = sampled_head();
    for (Point2 &p : points)
      p = p + Point2{0.1, 0.02};
    check_rail(columns(points),
               begin + in_order + smoothed + as_54E1 +
                 "moved by -100 mm and -20 mm: top to y = 0, field side of the head to that of 54E1\n"
                 "joined to the sides of 54E1 29.9 mm (field side) and 29.9 mm (gauge side) below its top; "
                 "below that it is the body\n",
               "an origin elsewhere");
    check_rail(columns(sampled(rail_profile("54E1").outline, 0.5e-3, 0, 1)),
               "two columns, 1264 points\n"
               "unit taken as mm, since the profile then is 140 mm wide; Profiles/Rail unit changes it\n"
               "1012 points more than 35 mm below the top left out\n" +
                 in_order + "order of the points reversed\n" + smoothed + as_54E1 +
                 "origin of the file kept: top at y = 0 mm of 54E1\n"
                 "joined to the sides of 54E1 31.7 mm (field side) and 31.7 mm (gauge side) below its top; "
                 "below that it is the body\n",
               "a whole rail");
    check_rail(columns(sampled_head("54E1", 30e-3, 0.03e-3)),
               "two columns, 3855 points\n"
               "unit taken as mm, since the profile then is 71.6 mm wide; Profiles/Rail unit changes it\n"
               "points closer than 0.1 mm averaged: 964 of 3855 left\n" +
                 in_order + smoothed + as_54E1 +
                 "origin of the file kept: top at y = 0 mm of 54E1\n"
                 "joined to the sides of 54E1 29.9 mm (field side) and 30 mm (gauge side) below its top; "
                 "below that it is the body\n",
               "a dense laser profile");
  }

  BOOST_AUTO_TEST_CASE(test_wheels)
  {
    const std::string chamfer = "kink at x = 60 mm, y = 2.7 mm kept\n";
    const std::string begin =
      "two columns, 321 points\n"
      "unit taken as mm, since the profile then is 135 mm wide; Profiles/Wheel unit changes it\n";
    const std::string kept = "lateral origin of the file kept: running circle at x = 0\n";
    check_wheel(columns(tread()), begin + smoothed + chamfer + kept, "a wheel in two columns");
    check_wheel(columns(tread(), -1e3),
                begin + "mirrored: the flange of the file lies at positive lateral coordinates\n" + smoothed +
                  chamfer + kept,
                "a wheel with its flange on the right");
    Points points = tread();
    for (Point2 &p : points)
      p = p + Point2{-0.07, 0.46};
    check_wheel(columns(points),
                begin + smoothed +
                  "kink at x = -10 mm, y = 462.7 mm kept\n"
                  "moved laterally by 70 mm: flange back 70 mm off the running circle\n"
                  "moved vertically by -460 mm: the running circle has the nominal rolling "
                  "radius\ncut at the rim face, 0.35 mm before it\n",
                "a wheel whose origin lies elsewhere");
    points.clear();
    for (const Point2 &p : tread())
      if (p.x < 40e-3 && (p.x > -60e-3 || p.y < -20e-3))
        points.push_back(p);
    check_wheel(
      columns(points),
      "two columns, 244 points\n"
      "unit taken as mm, since the profile then is 106.6 mm wide; Profiles/Wheel unit changes it\n" +
        smoothed + kept +
        "tread continued straight by 20.46 mm on the field side\n"
        "flange continued by an arc of 20.5 mm into the flange back\n",
      "a tread with its flange and no more");
  }
} // namespace
