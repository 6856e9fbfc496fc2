// label: fast

// Profile files as measuring devices and multibody programs leave them: each kind of oddity is read, told,
// and gives the profile that was measured.

#include "error_of.h"
#include "read_profiles.h"

#include <wheelrail/base/errors.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

using namespace wheelrail;
using test::columns;
using test::near;
using test::sampled;
using namespace test::profile_files;

namespace
{
  BOOST_AUTO_TEST_CASE(test_simpack)
  {
    const Read wheel = read(
      ProfileKind::wheel,
      "header.begin\n  version = 1\n  type = 1  ! wheel\nheader.end\nspline.begin\n  file = 'tread.txt'\n"
      "  type = 0 ! Original data file type\n  rotate =\n  units.len.f = 1000\n  point.begin\n!999 999\n" +
        columns(sampled(S1002(), 0.5e-3, 0, 1)) + "  point.end\nspline.end\n");
    check_tells(wheel,
                "type = 0 in line 7 left out: in the spline block it is the kind of the original data",
                "a second type in the spline block");
    check_on(wheel, S1002(), -69e-3, 59e-3, 1e-6, "a second type in the spline block");
  }

  BOOST_AUTO_TEST_CASE(test_miniprof_headers)
  {
    const Read free =
      read(ProfileKind::wheel,
           "#MINIWHEELPROF\nCar1_0001.whl\nMINIPROF 2020\nStock.......:\n28.00 32.50 10.79\n(Sh/Sd/qR)\n\n" +
             columns(miniprof_tread()));
    check_tells(free, "6 lines without \"=\" before the points left out", "free header lines");
    check_tells(free, "1 line of numbers before line 8 taken as heading", "numbers in the header");
    check_on(free, S1002(), -69e-3, 59e-3, 1e-6, "free header lines");

    // numbers alone: an empty line tells that they are no point
    for (const std::string heading : {"135 460 1\n\n", "135\t460\n\n\n"})
      {
        const Read bare = read(ProfileKind::wheel, heading + columns(sampled(S1002(), 0.5e-3, 0, 1)));
        check_tells(bare, "1 line of numbers before line ", "a line of numbers before an empty line");
        check_on(bare, S1002(), -69e-3, 59e-3, 1e-6, "a line of numbers before an empty line");
      }
    std::string spaced;
    for (const Point2 &p : sampled(S1002(), 0.5e-3, 0, 1))
      spaced += columns({p}) + "\n";
    const Read apart = read(ProfileKind::wheel, spaced);
    BOOST_TEST(!apart.tells("heading"), "points with empty lines between them are all points");
    check_on(apart, S1002(), -69e-3, 59e-3, 1e-6, "points with empty lines between them");

    Points rail = test::sampled_head("60E1", 28e-3);
    for (Point2 &p : rail) // the gauge side on the right
      p.x = -p.x;
    std::string four, count = std::to_string(rail.size());
    for (const Point2 &p : rail)
      four += columns({p}).substr(0, columns({p}).size() - 1) + " 0.0933 -0.034\n";
    const auto with_count = [&](const std::string &n) {
      return "Filename=x\nProgramName=\nXYPoints=" + n +
             "\nTilt=\nAreaRef=\n\"RefPoint1=\"\n\"ColumnDef=X,Y,A\"\nUOF1=#title\nColumnDef=X,Y,A,C\n\n" +
             four;
    };
    const Read empty = read(ProfileKind::rail, with_count(count));
    check_tells(empty, "MiniProf, " + count + " points", "keys without a value, four columns");
    check_on(empty, rail_profile("60E1").head, -35e-3, 35e-3, 1e-6, "keys without a value, four columns");
    const std::string one_more = std::to_string(rail.size() + 1);
    check_tells(read(ProfileKind::rail, with_count(one_more)),
                "XYPoints=\"" + one_more + "\", but the file holds " + count +
                  " points, one less: read as they are",
                "a count that is one off");
    BOOST_TEST(
      (read(ProfileKind::rail, with_count(std::to_string(rail.size() + 9))).error.find("it may be cut off") !=
       std::string::npos),
      "a count that is nine off is refused");
  }

  BOOST_AUTO_TEST_CASE(test_columns)
  {
    std::string  text;
    unsigned int line = 0;
    for (const Point2 &p : test::sampled_head("60E1", 28e-3))
      {
        std::string row = columns({p});
        row.pop_back();
        ++line;
        text += line == 50 ? row + " worn here\n" : line == 60 ? row + " % remark 7\n" : row + "\n";
        if (line == 70 || line == 80)
          text += "\"" + std::to_string(9999) + " 12\n";
      }
    const Read odd = read(ProfileKind::rail, text);
    check_tells(odd, "words behind the numbers of 1 line left out, the first is line 50", "words");
    check_tells(odd,
                "2 lines switched off by a leading quotation mark left out, the first is line 71",
                "quotation marks");
    check_on(odd, rail_profile("60E1").head, -35e-3, 35e-3, 1e-6, "words and switched-off lines");

    std::string five;
    for (const Point2 &p : test::sampled_head("60E1", 28e-3))
      five += columns({p}).substr(0, columns({p}).size() - 1) + " 0.1 0.2 0.3\n";
    check_tells(read(ProfileKind::rail, five), "columns 3 to 5 of the file left out", "five columns");
  }

  /// Line ends of CR alone: a comment ends with its line, not with the file.
  BOOST_AUTO_TEST_CASE(test_line_ends)
  {
    std::string text = "# measured on track 2\nx [mm]  y [mm]\n" + columns(test::sampled_head("60E1", 28e-3));
    const Read  unix = read(ProfileKind::rail, text);
    std::replace(text.begin(), text.end(), '\n', '\r');
    const Read mac = read(ProfileKind::rail, text);
    BOOST_TEST((mac.error.empty() && unix.error.empty() && mac.notes == unix.notes),
               "line ends of CR alone: told the same");
    check_on(mac, rail_profile("60E1").head, -35e-3, 35e-3, 1e-6, "line ends of CR alone");
  }

  /// Decimal commas between blanks: the same curve as with points, and it is told.
  BOOST_AUTO_TEST_CASE(test_decimal_commas)
  {
    std::string commas = columns(test::sampled_head("60E1", 28e-3));
    std::replace(commas.begin(), commas.end(), '.', ',');
    const Read read_commas = read(ProfileKind::rail, commas);
    check_tells(read_commas, "decimal commas read as points", "decimal commas");
    check_on(read_commas, rail_profile("60E1").head, -35e-3, 35e-3, 1e-6, "decimal commas");
  }

  BOOST_AUTO_TEST_CASE(test_origins)
  {
    const std::string header = "ProgramName=x\n\n";
    const Read        back   = read(ProfileKind::wheel, header + columns(miniprof_tread()));
    check_tells(back,
                "moved laterally by -70 mm: the origin of the file lies on the flange back, since the back "
                "is at x = 0 mm",
                "measured back");
    const Read tip = read(ProfileKind::wheel, header + columns(without_back()));
    check_tells(tip,
                "the origin of the file lies on the flange back, since the tip is at x = 15",
                "tip 15 mm off the origin");
    check_on(tip, S1002(), -69e-3, 59e-3, 2e-6, "tip 15 mm off the origin");
    check_on(read(ProfileKind::wheel, header + columns(without_back(), -1e3)),
             S1002(),
             -69e-3,
             59e-3,
             2e-6,
             "origin on the flange back, flange on the right");

    Points elsewhere = without_back();
    for (Point2 &p : elsewhere)
      p.x += 200e-3;
    const Read lost = read(ProfileKind::wheel, header + columns(elsewhere));
    BOOST_TEST((lost.error.find("set Profiles/Wheel origin") != std::string::npos),
               "an origin that cannot be found: refused");
    const Read wrong = read(ProfileKind::wheel, header + columns(elsewhere), WheelOrigin::flange_back);
    BOOST_TEST(
      (wrong.error.find("with Profiles/Wheel origin = flange back the flange tip lies at x = 145 mm, the "
                        "running circle being 0; "
                        "-70 mm to -35 mm is possible: write another origin, or auto") != std::string::npos),
      "a given origin where no flange can be: refused");

    // a flange back 2 mm off its place: as given, not as found
    Points thin = miniprof_tread();
    for (Point2 &p : thin)
      p.x += 2e-3;
    const Read given = read(ProfileKind::wheel, header + columns(thin), WheelOrigin::flange_back);
    check_tells(given, "moved laterally by -70 mm: Profiles/Wheel origin = flange back", "an origin given");
    const double x = given.error.empty() ? given.curve.at(given.curve.parameter_end()).position.x : 0;
    BOOST_TEST(near(x, -68e-3, 1e-5, "an origin given: place of the flange back [m]"));
    for (Point2 &p : thin)
      p.x -= 70e-3;
    check_tells(read(ProfileKind::wheel, header + columns(thin), WheelOrigin::running_circle),
                "lateral origin of the file kept: Profiles/Wheel origin = running circle",
                "the running circle given");
  }

  // Faces by their ends; a hole where wheel and rail touch is no face.
  BOOST_AUTO_TEST_CASE(test_long_steps)
  {
    Points points = miniprof_tread(), faces = {{-0.02e-3, -12e-3}, {0, 0}};
    for (const Point2 &p : points)
      if (p.y > 12.5e-3 || p.x > 20e-3)
        faces.push_back(p);
    for (const double step : {5e-3, 12e-3}) // the second one ends more than 15 mm above the tread
      faces.push_back(faces.back() + Point2{0, -step});
    const Read wheel = read(ProfileKind::wheel, "ProgramName=x\n\n" + columns(faces));
    check_tells(wheel, "taken as a straight face", "steps of 12 mm on the faces");
    check_tells(
      wheel, "face of the rim left out, more than 8 mm above the running circle", "the face of the rim");
    check_tells(wheel, "1 point more than 15 mm above the tread left out", "the high part of that face");
    check_on(wheel, S1002(), -60e-3, 55e-3, 1e-5, "steps of 12 mm on the faces");

    Points hole;
    for (const Point2 &p : test::sampled_head("60E1", 28e-3))
      if (std::abs(p.x) > 6e-3)
        hole.push_back(p);
    BOOST_TEST((read(ProfileKind::rail, columns(hole)).error.find("a gap of 12") != std::string::npos),
               "a gap of 12 mm on the crown is refused");

    // the roller of a test rig: crown, roundings, and upright faces by their ends
    for (const double face : {12e-3, 18e-3})
      {
        Points       roller;
        const double crown = 0.3, corner = 3e-3, half = 35e-3;
        const double middle = half - corner, low = std::sqrt(std::pow(crown - corner, 2) - middle * middle),
                     turn = std::atan2(middle, low);
        for (int k = 0; k <= 12; ++k)
          {
            const double angle = turn + (0.5 * M_PI - turn) * (12 - k) / 12;
            roller.push_back({-middle - corner * std::sin(angle), low - crown + corner * std::cos(angle)});
          }
        for (double x = -30e-3; x < 30.2e-3; x += 0.5e-3)
          roller.push_back({x, std::sqrt(crown * crown - x * x) - crown});
        for (int k = 12; k >= 0; --k)
          roller.push_back({-roller[k].x, roller[k].y});
        roller.insert(roller.begin(), roller.front() - Point2{0, face});
        roller.push_back(roller.back() - Point2{0, face});
        const Read rail = read(ProfileKind::rail, columns(roller));
        check_tells(rail, "taken as a straight face", "upright faces of a roller");
        double worst = 0;
        for (double x = -25e-3; rail.error.empty() && x < 25e-3; x += 1e-3)
          {
            const Point2 p{x, std::sqrt(crown * crown - x * x) - crown};
            worst = std::max(worst, norm(rail.curve.at(rail.curve.closest(p)).position - p));
          }
        BOOST_TEST(near(worst, 0, 2e-6, "crown of the roller [m]"));
        for (const ProfileKind kind : {ProfileKind::rail, ProfileKind::wheel})
          {
            ProfileFileOptions options;
            options.kind                  = kind;
            options.roller                = true;
            const MeasuredProfile profile = read_profile_text(columns(roller), "p.txt", options);
            BOOST_TEST(profile.points.size() > 100, "the same as the crown of a roller");
          }
      }
  }

  /// What decides on the shape is the line of points, not how densely its parts were measured, and what is
  /// left out may have gaps.
  BOOST_AUTO_TEST_CASE(test_spacing)
  {
    for (const double depth : {25e-3, 32e-3})
      for (const double step : {0.1e-3, 1e-3, 12e-3})
        for (const double sign : {1., -1.})
          {
            const Points tread = sampled(S1002(), 0.5e-3, 0, 1);
            Points       wheel;
            for (double y = depth; y > 0.5 * step; y -= step)
              wheel.push_back(tread.front() + Point2{1e-3 * y, y});
            wheel.insert(wheel.end(), tread.begin(), tread.end());
            for (Point2 &p : wheel)
              p.y *= sign;
            const std::string what =
              "a rim measured " + std::to_string(depth) + " m up every " + std::to_string(step);
            const Read rim = read(ProfileKind::wheel, columns(wheel));
            check_tells(rim, "more than 15 mm above the tread left out", what);
            BOOST_TEST((rim.tells("turned upside down") == (sign < 0)), what + ": which way is up");
            check_on(rim, S1002(), -69e-3, 55e-3, 1e-5, what);
          }

    Points whole = {
      {75e-3, -172e-3}, {75e-3, -160.5e-3}, {9e-3, -145e-3}, {8.25e-3, -120e-3}, {8.25e-3, -60e-3}};
    for (std::size_t k = whole.size(); k-- > 0;)
      whole.push_back({-whole[k].x, whole[k].y});
    const Points top = test::sampled_head("60E1", 28e-3);
    whole.insert(whole.begin() + 5, top.begin(), top.end());
    if (top.front().x < top.back().x)
      std::reverse(whole.begin() + 5, whole.begin() + 5 + top.size());
    check_on(read(ProfileKind::rail, columns(whole)),
             rail_profile("60E1").head,
             -35e-3,
             35e-3,
             1e-5,
             "a whole rail, of whose web and foot only corners are given");

    ProfileFileOptions options;
    options.kind            = ProfileKind::wheel;
    options.turn            = ProfileMirror::yes;
    Points     turned       = sampled(S1002(), 0.5e-3, 0, 1);
    const auto read_turned  = [&]() { return read_profile_text(columns(turned), "p.txt", options).notes; };
    const std::string fault = test::error_of<InputError>([&]() { read_turned(); });
    BOOST_TEST((fault.find("no wheel profile") != std::string::npos),
               "a wheel turned over by hand that hangs right");
    for (Point2 &p : turned)
      p.y = -p.y;
    const auto notes = read_turned();
    BOOST_TEST(
      (std::find(notes.begin(), notes.end(), "turned upside down: Profiles/Wheel upside down = yes") !=
       notes.end()),
      "a wheel turned over by hand");
  }

  BOOST_AUTO_TEST_CASE(test_other_bodies)
  {
    Points narrow;
    for (const Point2 &p : test::sampled_head("54E1", 28e-3))
      narrow.push_back({p.x - std::copysign(std::min(8e-3, 0.4 * std::abs(p.x)), p.x), p.y});
    const Read other = read(ProfileKind::rail, columns(narrow));
    check_tells(other, "joined to it by a straight line of", "a head 16 mm narrower");

    Points part;
    for (const Point2 &p : test::sampled_head("60E1", 28e-3))
      if (p.x < 20e-3)
        part.push_back(p);
    const Read one_side = read(ProfileKind::rail, columns(part));
    check_tells(
      one_side, "body of the rail: 60E1, whose outline lies 0 mm off the points", "one side of a 60E1");
    check_on(one_side, rail_profile("60E1").head, -35e-3, 35e-3, 5e-6, "one side of a 60E1");
  }

  BOOST_AUTO_TEST_CASE(test_cut_flange)
  {
    Points points;
    for (const Point2 &p : sampled(S1002(), 0.5e-3, 0, 1))
      if (p.x > -50e-3 && p.y > -21e-3)
        points.push_back(p);
    const Read cut = read(ProfileKind::wheel, columns(points));
    check_tells(cut,
                " now), its tip and its back are made up, and contact beyond the cut cannot be trusted",
                "a flange cut off");
    check_on(cut, S1002(), -40e-3, 59e-3, 1e-6, "a flange cut off: what was measured");
    double lowest = 0;
    for (double t = 0; t < cut.curve.parameter_end(); t += 0.05)
      lowest = std::min(lowest, cut.curve.at(t).position.y);
    BOOST_TEST(near(lowest, -28e-3, 3e-3, "a flange cut off: height of the continued one [m]"));
    BOOST_TEST(near(cut.curve.at(cut.curve.parameter_end()).position.x, -70e-3, 1e-6, "its back [m]"));

    points.clear();
    for (const Point2 &p : sampled(S1002(), 0.5e-3, 0, 1))
      if (p.x > -50e-3 && p.y > -10e-3)
        points.push_back(p);
    BOOST_TEST(!read(ProfileKind::wheel, columns(points)).error.empty(),
               "a tread without a flange is refused");
  }
} // namespace
