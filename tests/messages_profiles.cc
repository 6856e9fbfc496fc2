// label: fast

// What the program answers to faulty profile files, word by word.

#include "messages.h"

#include <wheelrail/base/quantity.h>
#include <wheelrail/profiles/profile_file.h>
#include <wheelrail/profiles/smoothing_spline.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <vector>

using namespace wheelrail;
using test::message_of;
using test::same_text;

namespace
{
  std::string
  point(const double x, const double y)
  {
    char text[60];
    std::snprintf(text, sizeof text, "%.4f %.4f\n", x, y);
    return text;
  }

  /// Point of a rail head [mm], u from 0 (left side) to 1 (right side): 70 mm wide and 20 mm
  /// deep.
  Point2
  head(const double u)
  {
    const double angle = M_PI * (1 - u), c = std::cos(angle), s = std::sin(angle);
    // a superellipse: flat on top, steep at its ends, without joints
    return {35 * std::copysign(std::pow(std::abs(c), 0.5), c), 20 * (std::pow(s, 0.5) - 1)};
  }

  std::string
  head_points(const double first = 0, const double last = 1, const int n = 200, const double scale = 1)
  {
    std::string text;
    for (int i = 0; i <= n; ++i)
      {
        const Point2 p = head(first + (last - first) * i / n);
        text += point(scale * p.x, scale * p.y);
      }
    return text;
  }

  /// A flatter head with even steps of 0.35 mm, its points from `first` to `last` (0 to 200) shifted up
  /// by what a function of their number gives [mm].
  template <typename Function>
  std::string
  changed_head(const Function &up, const int first = 0, const int last = 200)
  {
    std::string text;
    for (int i = first; i <= last; ++i)
      {
        const double x = -35 + 0.35 * i;
        text += point(x, -16 * std::pow(x / 35, 4) + up(i));
      }
    return text;
  }

  std::string
  simpack(const std::string &head_lines, const std::string &points)
  {
    return "header.begin\nversion = 1\n" + head_lines + "header.end\nspline.begin\npoint.begin\n" + points +
           "point.end\nspline.end\n";
  }

  void
  check_profile(const std::string        &text,
                const std::string        &expected,
                const ProfileFileOptions &options = {},
                const std::string        &file    = "r.txt")
  {
    BOOST_TEST(same_text(message_of([&]() { read_profile_text(text, file, options); }), expected, expected));
  }

  ProfileFileOptions
  wheel_options(const ProfileMirror mirror = ProfileMirror::automatic)
  {
    ProfileFileOptions options;
    options.kind   = ProfileKind::wheel;
    options.mirror = mirror;
    return options;
  }

  BOOST_AUTO_TEST_CASE(test_files)
  {
    const auto check_file = [](const std::string &path, const std::string &expected) {
      BOOST_TEST(same_text(message_of([&]() { read_profile_file(path, {}); }), expected, expected));
    };
    check_file(
      "nowhere.prr",
      "nowhere.prr: no such file; profiles are looked for where the command is given, then beside the scene");
    check_file(".", ".: not a file; a profile file (.prr, .prw, .ban, .whl or two columns) is needed");
    std::ofstream("large.txt") << std::string(largest_profile_file + 1, ' ');
    check_file(
      "large.txt",
      "large.txt: larger than 10 MB; a profile file (.prr, .prw, .ban, .whl or two columns) is needed");
    std::filesystem::remove("large.txt");
    test::check_unreadable([](const std::string &path) { read_profile_file(path, {}); });

    const std::string profiles = std::string(WHEELRAIL_TEST_DIR) + "/profiles/";
    check_file(profiles + "broken_gap.prr",
               profiles +
                 "broken_gap.prr: a gap of 20.96 mm between lines 93 and 94; up to 10 mm is bridged, "
                 "on a straight face up to 30 mm: measure again or add points");
    check_file(profiles + "broken_loop.txt",
               profiles +
                 "broken_loop.txt: the line of points crosses itself between line 101 and line 110; a "
                 "profile without loops is needed: remove the points of the loop");
  }

  BOOST_AUTO_TEST_CASE(test_formats)
  {
    check_profile("",
                  "r.txt: no points found; a SIMPACK (.prr, .prw), MiniProf (.ban, .whl) or two-column file "
                  "with lateral and vertical coordinates is needed");
    check_profile(std::string("1 2\0 3", 6),
                  "r.txt: not a text file; a profile file (.prr, .prw, .ban, .whl or two columns) is needed");
    check_profile(
      "1 2\n3 4x\n",
      "r.txt:2: \"4x\" is not a number; a line of points holds two: lateral and vertical coordinate");
    check_profile(
      "1 2\n3 nan\n",
      "r.txt:2: \"nan\" is not a number; a line of points holds two: lateral and vertical coordinate");
    check_profile(
      "nan 2\n1 2\n3 4\n",
      "r.txt:1: \"nan\" is not a number; a line of points holds two: lateral and vertical coordinate");
    check_profile(
      "1 2\n3\n",
      "r.txt:2: \"3\" holds 1 number; a line of points holds two: lateral and vertical coordinate");
    check_profile("12,5;3,7\n13.5;3,7\n",
                  "r.txt:2: \"13.5;3,7\" has another decimal mark than other rows; write numbers with one "
                  "decimal mark and without separators of thousands");
    check_profile("12,500\t3,700\n13,500\t3,800\n",
                  "r.txt:1: \"12,500?3,700\" has commas between digits that may be decimal marks or part "
                  "thousands; write numbers with one decimal mark and without separators of thousands");
    check_profile(
      std::string(largest_profile_file + 1, ' '),
      "r.txt: larger than 10 MB; a profile file (.prr, .prw, .ban, .whl or two columns) is needed");
    check_profile(
      "1 2 3 4 5 6\n",
      "r.txt:1: \"1 2 3 4 5 6\" holds 6 columns; two to five are accepted, the first ones are the "
      "lateral and the vertical coordinate");
    check_profile(
      "\"1 2\"\n\"3 4\"\n",
      "r.txt: 2 lines switched off by a leading quotation mark, and no points found; a SIMPACK (.prr, "
      ".prw), MiniProf (.ban, .whl) or two-column file with lateral and vertical coordinates is needed");
    check_profile("1 2\n1 2 3\n",
                  "r.txt:2: \"1 2 3\" holds 3 columns, the lines before 2; write two in every line");
    check_profile("1 2e9\n", "r.txt:1: a coordinate above 1e9; a profile is some 0.1 m wide");
    std::string many;
    for (std::size_t i = 0; i <= largest_profile_points; ++i)
      many += "1 2\n";
    check_profile(many,
                  "r.txt:50001: more than 50000 points; a profile needs some hundred: keep every tenth");
    check_profile("ProgramName=x\nColumnDef=Y,N\n1 2\n",
                  "r.txt:2: ColumnDef=\"Y,N\": columns X and Y are needed, such as ColumnDef=X,Y");
    check_profile("ProgramName=x\nXYPoints=3\nColumnDef=X,Y\n1 2\n",
                  "r.txt:2: XYPoints=\"3\", but the file holds 1 point; it may be cut off, export it again");
    check_profile(
      "header.begin\nheader.end\n",
      "r.txt: a SIMPACK profile without \"point.begin\"; its points are between point.begin and point.end");
    check_profile("header.begin\nheader.end\npoint.begin\n1 2\n",
                  "r.txt:3: point.begin without \"point.end\"; the file may be cut off");
    check_profile(
      "header.begin\nheader.end\npoint.begin\n1 2\npoint.begin\n",
      "r.txt:5: a second point.begin, the first is in line 3; one profile per file is read: split the file");
    check_profile(simpack("type = 2\n", head_points()),
                  "r.txt:3: type = \"2\": 0 (rail) or 1 (wheel) is accepted");
    check_profile(simpack("type = 1\n", head_points()),
                  "r.txt:3: type = 1, a wheel; Profiles/Rail needs a rail profile");
    check_profile(simpack("type = 0\n", head_points()),
                  "r.txt:3: type = 0, a rail; Profiles/Wheel needs a wheel profile",
                  wheel_options());
    check_profile(simpack("units.len.f = 0\n", head_points()),
                  "r.txt:3: units.len.f = \"0\": file units per metre are needed, 1000 for mm");
    check_profile(simpack("units.len.f = many\n", head_points()),
                  "r.txt:3: units.len.f = \"many\": a number is needed");
  }

  BOOST_AUTO_TEST_CASE(test_points)
  {
    check_profile(head_points(0, 1, 10),
                  "r.txt: 11 different points; a profile needs at least 20, some 200 are usual");
    check_profile(head_points(0, 1, 200, 25),
                  "r.txt: the profile is 1750 units wide and the file states none; as mm or m it is not a "
                  "rail (30 mm to 300 mm): set Profiles/Rail unit to mm, m or inch, or scale the file");
    ProfileFileOptions inches;
    inches.unit = ProfileUnit::inch;
    check_profile(head_points(),
                  "r.txt: the profile is 1849.1479 mm across; 5 mm to 500 mm is accepted. Set Profiles/Wheel "
                  "unit or Profiles/Rail unit",
                  inches);
    check_profile(head_points(0, 0.45) + head_points(0.7, 1),
                  "r.txt: a gap of 40.72 mm between lines 201 and 202; up to 10 mm is bridged, on a straight "
                  "face up to 30 mm: measure again or add points");
    const auto none = [](int) { return 0; };
    check_profile(changed_head(none, 0, 150) + changed_head(none, 40, 200),
                  "r.txt: between lines 151 and 152 the line of points turns back by 38.515 mm; pieces that "
                  "overlap by at most 30 mm are merged, write each place once");
    check_profile(changed_head(none, 0, 120) + changed_head([](int) { return 1; }, 80, 200),
                  "r.txt: the pieces that overlap at lines 121 and 122 are 1 mm apart; up to 0.5 mm is "
                  "merged: align or cut them");
    std::string pieces = head_points(0, 0.2);
    for (int i = 0; i < 8; ++i)
      pieces += head_points(0.2 + 0.07 * i, 0.3 + 0.07 * i, 20);
    check_profile(pieces,
                  "r.txt: the line of points turns back more than 5 times; write the points in their order "
                  "along the outline");
    check_profile(changed_head([](const int i) { return i % 2 == 0 ? 0 : 3; }),
                  "r.txt: the line of points is 604.7 mm long and the profile only 72.5 mm across; write the "
                  "points in their order along the outline, without loops");
    check_profile(
      changed_head([](const int i) { return i % 14 == 7 ? 1 : 0; }),
      "r.txt: more than 10 points lie off the line of their neighbours, the worst by 1 mm in line 92; single "
      "outliers are dropped, a profile of them cannot be mended: measure again or smooth the file");
    std::mt19937 random(1);
    std::string  rough; // even steps of 1.4 mm
    for (int i = 0; i <= 200; i += 4)
      rough += changed_head([&](int) { return 1e-3 * (random() % 1300); }, i, i);
    check_profile(rough,
                  "r.txt: the points scatter by 0.569 mm about a smooth line, which is no measured profile "
                  "(up to 0.3 mm is smoothed): measure again, or set Profiles/Smoothing");
    // a loop above the middle of the head
    std::string loop = head_points(0, 0.45);
    for (int i = 1; i < 100; ++i)
      loop += point(-13.8 + 0.276 * i + 8 * std::sin(M_PI * i / 50), 3 - 3 * std::cos(M_PI * i / 50));
    check_profile(loop + head_points(0.55, 1),
                  "r.txt: the line of points crosses itself between line 223 and line 280; a profile without "
                  "loops is needed: remove the points of the loop");
    std::vector<Point2> kinked;
    for (int i = 0; i < 20; ++i)
      kinked.push_back({5e-4 * i, 0});
    BOOST_TEST(same_text(message_of([&]() {
                           smoothing_spline(kinked, {8, 10}, std::vector<double>(kinked.size(), 1e-5));
                         }),
                         "between two kinks of the profile lie fewer than four points: measure denser",
                         "kinks too close"));
    ProfileFileOptions metres;
    metres.unit = ProfileUnit::metre;
    check_profile(head_points(),
                  "r.txt: the profile is 72801.0989 mm across; 5 mm to 500 mm is accepted; multiplied by "
                  "0.001 it would be 72.8 mm, so the unit may be wrong. Set Profiles/Wheel unit or "
                  "Profiles/Rail unit",
                  metres);
    ProfileFileOptions smooth;
    smooth.noise = 1;
    check_profile(changed_head(none),
                  "r.txt: the smoothing of the profile failed, since its points are too uneven: give points "
                  "at steps of 0.2 mm to 1 mm, or set Profiles/Smoothing to another length",
                  smooth);
    smooth.noise = 20e-3;
    // the length is that of an equation solved in floating point numbers: its digits are taken over
    const std::string message = message_of([&]() { read_profile_text(head_points(), "r.txt", smooth); });
    const std::string before  = "r.txt: the smoothed profile lies up to ";
    const double      length = message.rfind(before, 0) == 0 ? std::atof(message.c_str() + before.size()) : 0;
    BOOST_TEST((length > 1 && length < 20), "20 mm of smoothing lie more than 1 mm off the points of a head");
    BOOST_TEST(
      same_text(message,
                before + format_number(length) +
                  " mm off the points; up to 1 mm is accepted: set Profiles/Smoothing to a smaller length",
                "a smoothed profile that misses its points"));
  }

  BOOST_AUTO_TEST_CASE(test_shapes)
  {
    std::string block;
    for (int y = -78; y <= -6; y += 6)
      block += point(-35, y);
    for (double x = -30; x <= 30; x += 7.5)
      block += point(x, 0);
    for (int y = -6; y >= -78; y -= 6)
      block += point(35, y);
    check_profile(block, "r.txt: only 19 points of a rail head; at least 20 are needed");
    check_profile(head_points(0.25, 0.75),
                  "r.txt: not enough of a rail head: its ends lie 3.2 mm and 3.2 mm below its top; the gauge "
                  "side down to the gauge height (14 mm) is needed, and the crown");
    check_profile(head_points(0, 1, 200, 1.8),
                  "r.txt: no rail head: 126 mm wide; 40 mm to 95 mm is accepted (this may be a wheel: "
                  "Profiles/Wheel takes those)");
    check_profile(
      head_points(0, 1, 200, 0.8),
      "r.txt: no wheel profile: 56 mm wide, its lowest part 15.7 mm below the tread; a tread with its "
      "flange is needed, at least 60 mm wide and 15 mm deep (this may be a rail: Profiles/Rail takes those)",
      wheel_options());
    check_profile(head_points(0, 1, 900, 3),
                  "r.txt: no wheel profile: 210 mm wide, its lowest part 59 mm below the tread; up to "
                  "200 mm and 45 mm are accepted",
                  wheel_options());
    std::string tread;
    for (int i = -70; i <= 60; ++i)
      tread += point(i, i < -30 ? -14 * (1 - std::cos(2 * M_PI * (i + 30) / 40)) : -0.02 * i);
    check_profile(
      tread,
      "r.txt: with Profiles/Wheel mirror = yes the flange lies on the field side; write auto or no",
      wheel_options(ProfileMirror::yes));
  }
} // namespace
