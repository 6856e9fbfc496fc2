// Profile files: formats, cleaning, smoothing, and the message of every refusal.

#include "check.h"
#include "profile_samples.h"

#include <wheelrail/base/errors.h>
#include <wheelrail/geometry/contact_geometry.h>
#include <wheelrail/geometry/measured_profiles.h>
#include <wheelrail/geometry/profile_cleaning.h>
#include <wheelrail/geometry/profile_file.h>
#include <wheelrail/geometry/smoothing_spline.h>

#include <algorithm>
#include <functional>

using namespace wheelrail;
using test::check;
using test::check_near;
using test::check_text;
using test::columns;
using test::sampled;

namespace
{
  const std::string folder = std::string(WHEELRAIL_TEST_DIR) + "/profiles/";

  ProfileFileOptions
  options(const ProfileKind kind)
  {
    ProfileFileOptions result;
    result.kind = kind;
    return result;
  }

  std::string
  message_of(const std::function<void()> &action)
  {
    try
      {
        action();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "no message";
  }

  void
  check_refused(const std::string        &text,
                const ProfileFileOptions &how,
                const std::string        &expected,
                const std::string        &what)
  {
    check_text(message_of([&]() { read_profile_text(text, "p.txt", how); }), expected, what);
  }

  bool
  has_note(const MeasuredProfile &profile, const std::string &note)
  {
    return std::find(profile.notes.begin(), profile.notes.end(), note) != profile.notes.end();
  }

  // Points of the head of 54E1 down to 30 mm, at steps of half a millimetre; `odd`: those in the
  // middle between them.
  std::vector<Point2>
  head(const bool odd = false)
  {
    std::vector<Point2> points;
    unsigned int        count = 0;
    for (const Point2 &p : sampled(rail_profile("54E1").head, 0.25e-3, 0, 1))
      if (p.y > -30e-3 && (++count % 2 == 1) != odd)
        points.push_back(p);
    return points;
  }

  void
  test_samples()
  {
    const MeasuredProfile prr = read_profile_file(folder + "worn_54E1.prr", options(ProfileKind::rail));
    const MeasuredProfile ban = read_profile_file(folder + "worn_54E1.ban", options(ProfileKind::rail));
    check(has_note(prr, "unit mm as the file states") &&
            has_note(prr, "turned upside down: the vertical coordinate of the file points down"),
          "SIMPACK rail: unit and direction of z told");
    check(
      has_note(
        ban,
        "mirrored: files of this format have the gauge side on the right; Profiles/Rail mirror changes it"),
      "MiniProf rail: mirrored");
    check_near(prr.noise, 4e-6, 1e-6, "noise found in the points, made with 4 micrometres [m]");
    double worst = 0;
    for (double t = 0; t < prr.curve.parameter_end(); t += 0.3)
      {
        const Point2 p = prr.curve.at(t).position, q = p + Point2{-1.5e-3, 4e-3};
        worst = std::max(worst, norm(ban.curve.at(ban.curve.closest(q)).position - q));
      }
    check_near(worst, 0, 1e-6, "the same rail as SIMPACK and as MiniProf file: the same curve, moved [m]");

    const MeasuredProfile prw = read_profile_file(folder + "worn_S1002.prw", options(ProfileKind::wheel));
    const MeasuredProfile txt =
      read_profile_file(folder + "worn_S1002_metres.txt", options(ProfileKind::wheel));
    check(
      has_note(txt, "mirrored: the flange of the file lies at positive lateral coordinates") &&
        has_note(txt,
                 "unit taken as m, since the profile then is 129.5 mm wide; Profiles/Wheel unit changes it"),
      "two columns in metres, flange on the right: told");
    worst = 0;
    for (double t = 0; t < prw.curve.parameter_end(); t += 0.3)
      {
        const Point2 p = prw.curve.at(t).position, q = p + Point2{-31.5e-3, 0};
        worst = std::max(worst, norm(txt.curve.at(txt.curve.closest(q)).position - q));
      }
    check_near(worst, 0, 1e-6, "the same wheel as SIMPACK and as mirrored two-column file in metres [m]");
    for (const MeasuredProfile *p : {&prr, &ban, &prw, &txt})
      check(p->curve.at(0).position.x > p->curve.at(p->curve.parameter_end()).position.x,
            p->file.substr(folder.size()) + " runs from the field side");
  }

  // The smoothed curve against the exact one where wheels and rails touch.
  void
  test_smoothing()
  {
    struct Case
    {
      double      noise, distance, curvature;
      const char *what;
    };
    // distances: largest [m]; curvatures: largest mean error over 5 mm [1/m]; the relative curvature
    // of the pair at shift 0 is 6 / m, and the jumps of the rail's are 9 and 64 / m
    for (const Case &c :
         {Case{0, 1e-6, 0.2, "without noise"}, Case{5e-6, 8e-6, 1, "with 5 micrometres of noise"}})
      for (const ProfileKind kind : {ProfileKind::rail, ProfileKind::wheel})
        {
          const Curve exact =
            kind == ProfileKind::rail ? rail_profile("54E1").head : wheel_profile("S1002").tread;
          const double          reach    = kind == ProfileKind::rail ? 24e-3 : 34e-3;
          const auto            text     = columns(sampled(exact, 0.5e-3, c.noise, 3));
          const MeasuredProfile measured = read_profile_text(text, "p.txt", options(kind));
          double                distance = 0, curvature = 0, sum = 0, begin = reach;
          int                   n = 0;
          for (double t = 0; t < measured.curve.parameter_end(); t += 0.1)
            {
              const CurvePoint p = measured.curve.at(t);
              if (std::abs(p.position.x) > reach)
                continue;
              const CurvePoint q = exact.at(exact.closest(p.position));
              distance           = std::max(distance, norm(p.position - q.position));
              sum += p.curvature - q.curvature;
              ++n;
              if (begin - p.position.x > 5e-3)
                {
                  curvature = std::max(curvature, std::abs(sum / n));
                  begin     = p.position.x;
                  sum = n = 0;
                }
            }
          const std::string name =
            (kind == ProfileKind::rail ? "54E1 sampled " : "S1002 sampled ") + std::string(c.what);
          check_near(distance, 0, c.distance, name + ": largest distance from the exact profile [m]");
          check_near(
            curvature, 0, c.curvature, name + ": largest error of the mean curvature over 5 mm [1/m]");
        }
  }

  void
  test_kinks()
  {
    std::vector<Point2> points;
    for (int i = 0; i <= 80; ++i)
      points.push_back({5e-4 * i, i < 40 ? 0. : 5e-4 * (i - 40)});
    const auto kinks = find_kinks(points, 0);
    check(kinks.size() == 1 && kinks[0] == 40, "one kink of 45 degrees found where it is");
    const Curve curve(smoothing_spline(points, kinks, 1e-5));
    check_near(norm(curve.at(curve.closest(points[40])).position - points[40]), 0, 1e-8, "and kept [m]");

    points.clear();
    for (int i = 0; i <= 60; ++i)
      points.push_back({3e-3 * std::cos(0.05 * i), 3e-3 * std::sin(0.05 * i)});
    check(find_kinks(points, 0).empty(), "an arc of 3 mm has no kinks");
  }

  // A defect, what is done about it, and how little it moves the curve.
  void
  test_mending()
  {
    const auto  base         = head();
    const Curve clean        = read_profile_text(columns(base), "p.txt", options(ProfileKind::rail)).curve;
    const auto  check_mended = [&](const std::vector<Point2> &points,
                                  const std::string         &note,
                                  const std::string         &what) {
      const MeasuredProfile mended = read_profile_text(columns(points), "p.txt", options(ProfileKind::rail));
      double                worst  = 0;
      for (double t = 0; t < mended.curve.parameter_end(); t += 0.5)
        {
          const Point2 p = mended.curve.at(t).position;
          worst          = std::max(worst, norm(clean.at(clean.closest(p)).position - p));
        }
      if (!check(has_note(mended, note), what + ": told"))
        for (const std::string &n : mended.notes)
          std::cout << "  note: " << n << "\n";
      check_near(worst, 0, 2e-6, what + ": distance from the curve without it [m]");
    };
    auto points = base;
    points.insert(points.begin() + 50, points[50]);
    points.insert(points.begin() + 90, points[90]);
    check_mended(points, "2 repeated points dropped", "repeated points");
    points = base;
    points[100].y += 0.4e-3;
    check_mended(points, "1 outlier dropped, the largest 0.4 mm off in line 101", "an outlier");
    points = base;
    std::reverse(points.begin(), points.end());
    check_mended(points, "order of the points reversed", "points in reversed order");
    points             = base;
    const auto between = head(true);
    points.insert(points.begin() + 100, between.begin() + 89, between.begin() + 100);
    check_mended(
      points,
      "two pieces that overlap by 4.756 mm at lines 100 and 101 merged (20 points, at most 0 mm apart)",
      "an overlap");
    points.clear();
    for (std::size_t i = 0; i < base.size(); ++i)
      if (i < 100 || i > 105)
        points.push_back(base[i]);
    check_mended(points, "1 gap bridged, the largest 3.504 mm between lines 100 and 101", "a gap");
  }

  /// Text of a SIMPACK file with these points (z down) and further header lines.
  std::string
  simpack(const std::vector<Point2> &points, const std::string &header = "type = 0\nunits.len.f = 1000\n")
  {
    return "spline.begin\n" + header + "point.begin\n" + columns(points, 1e3, -1e3) +
           "point.end\nspline.end\n";
  }

  void
  test_text_messages()
  {
    const auto        rail    = options(ProfileKind::rail);
    const std::string formats = "a profile file (.prr, .prw, .ban, .whl or two columns) is needed";
    const std::string two     = "a line of points holds two: lateral and vertical coordinate";
    check_text(
      message_of([&]() { read_profile_file("nowhere.prr", rail); }),
      "nowhere.prr: no such file; a profile file is sought from the folder where the command is given",
      "no such file");
    check_text(message_of([&]() { read_profile_file(".", rail); }), ".: not a file; " + formats, "a folder");
    check_refused(
      "",
      rail,
      "p.txt: no points found; a SIMPACK (.prr, .prw), MiniProf (.ban, .whl) or two-column file with "
      "lateral and vertical coordinates is needed",
      "an empty file");
    check_refused(std::string("1 2\0 3", 6), rail, "p.txt: not a text file; " + formats, "a binary file");
    check_refused(std::string(largest_profile_file + 1, ' '),
                  rail,
                  "p.txt: larger than 10 MB; " + formats,
                  "a huge file");
    check_refused("1 2\n3 4x\n", rail, "p.txt:2: \"4x\" is not a number; " + two, "no number");
    check_refused("1 2\n3 nan\n", rail, "p.txt:2: \"nan\" is not a number; " + two, "not finite");
    check_refused("1 2\n3\n", rail, "p.txt:2: \"3\" holds 1 number; " + two, "one column");
    check_refused("1 2\n3 2e9\n",
                  rail,
                  "p.txt:2: a coordinate above 1e9; a profile is some 0.1 m wide",
                  "a coordinate beyond all units");
    check_refused(
      "12,5;3,7\n",
      rail,
      "p.txt:1: \"12,5;3,7\" holds 4 columns; two are accepted, lateral and vertical coordinate, with a "
      "point as decimal mark (a third one is left out)",
      "decimal commas");
    check_refused("1 2\n3 4 5\n",
                  rail,
                  "p.txt:2: \"3 4 5\" holds 3 columns, the lines before 2; write two in every line",
                  "columns that change");
    std::string many;
    for (std::size_t i = 0; i <= largest_profile_points; ++i)
      many += "1 2\n";
    check_refused(many,
                  rail,
                  "p.txt:50001: more than 50000 points; a profile needs some hundred: keep every tenth",
                  "too many points");
  }

  void
  test_header_messages()
  {
    const auto rail = options(ProfileKind::rail);
    check_refused(
      "header.begin\ntype = 0\nheader.end\n",
      rail,
      "p.txt: a SIMPACK profile without \"point.begin\"; its points stand between point.begin and point.end",
      "SIMPACK without points");
    check_refused(
      "point.begin\n1 2\npoint.begin\n",
      rail,
      "p.txt:3: a second point.begin, the first is in line 1; one profile per file is read: split the file",
      "two blocks of points");
    check_refused("point.begin\n1 2\n",
                  rail,
                  "p.txt:1: point.begin without \"point.end\"; the file may be cut off",
                  "a file that is cut off");
    check_refused(simpack(head(), "type = 2\n"),
                  rail,
                  "p.txt:2: type = \"2\": 0 (rail) or 1 (wheel) is accepted",
                  "an unknown type");
    check_refused(simpack(head(), "type = 1\n"),
                  rail,
                  "p.txt:2: type = 1, a wheel; Profiles/Rail needs a rail profile",
                  "a wheel as rail");
    check_refused(simpack(head()),
                  options(ProfileKind::wheel),
                  "p.txt:2: type = 0, a rail; Profiles/Wheel needs a wheel profile",
                  "a rail as wheel");
    check_refused(simpack(head(), "units.len.f = 0\n"),
                  rail,
                  "p.txt:2: units.len.f = \"0\": file units per metre are needed, 1000 for mm",
                  "a unit of nothing");
    check_refused(simpack(head(), "shift.y = left\n"),
                  rail,
                  "p.txt:2: shift.y = \"left\": a number is needed",
                  "a header without number");
    check_refused("ColumnDef=A,B\n\n1 2\n",
                  rail,
                  "p.txt:1: ColumnDef=\"A,B\": columns X and Y are needed, such as ColumnDef=X,Y",
                  "MiniProf columns");
    check_refused(
      "XYPoints=300\n\n1 2\n",
      rail,
      "p.txt:1: XYPoints=\"300\", but the file holds 1 points; it may be cut off, export it again",
      "MiniProf with points missing");
  }

  void
  test_shape_messages()
  {
    const auto          rail = options(ProfileKind::rail);
    const auto          base = head();
    std::vector<Point2> few;
    for (std::size_t i = 0; i < base.size(); i += 15)
      few.push_back(base[i]);
    check_refused(columns(few),
                  rail,
                  "p.txt: 16 different points; a profile needs at least 20, some 200 are usual",
                  "too few points");
    check_refused(
      columns(base, 1e2, 1e2),
      rail,
      "p.txt: the profile is 7.1564 units wide and the file states none; as mm or m it is not a rail (30 mm "
      "to 300 mm): set Profiles/Rail unit to mm, m or inch, or scale the file",
      "centimetres");
    auto metres = rail;
    metres.unit = ProfileUnit::metre;
    check_refused(columns(base),
                  metres,
                  "p.txt: the profile is 77547.4468 mm across; 5 mm to 500 mm is accepted; multiplied by "
                  "0.001 it would be "
                  "77.5 mm, so the unit may be wrong. Set Profiles/Wheel unit or Profiles/Rail unit",
                  "a wrong unit");
    std::vector<Point2> points = base;
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i].y += i % 2 == 0 ? 2e-3 : -2e-3;
    check_refused(columns(points),
                  rail,
                  "p.txt: the line of points is 923.5 mm long and the profile only 79 mm across; write the "
                  "points in their order along the outline, without loops",
                  "a saw");
    points = base;
    for (std::size_t i = 20; i + 20 < points.size(); i += 9)
      points[i].y += 1e-3;
    check_refused(
      columns(points),
      rail,
      "p.txt: more than 11 points lie off the line of their neighbours, the worst by 1.001 mm in line 138; "
      "single outliers are dropped, a profile of them cannot be mended: measure again or smooth the file",
      "too many outliers");
    points = base;
    points.insert(points.begin() + 150, base.begin() + 60, base.begin() + 150);
    check_refused(columns(points),
                  rail,
                  "p.txt: between lines 150 and 151 the line of points turns back by 44.301 mm; pieces that "
                  "overlap by at most 30 mm are merged, write each place once",
                  "an overlap of 45 mm");
    points = base;
    points.insert(points.begin() + 100, base.begin() + 89, base.begin() + 100);
    for (int i = 100; i < 111; ++i)
      points[i].y += 1e-3;
    check_refused(columns(points),
                  rail,
                  "p.txt: the pieces that overlap at lines 100 and 101 are 1 mm apart; up to 0.5 mm is "
                  "merged: align or cut them",
                  "an overlap of pieces that disagree");
    check_text(
      message_of([&]() { read_profile_file(folder + "broken_gap.prr", rail); }).substr(folder.size()),
      "broken_gap.prr: a gap of 20.96 mm between lines 93 and 94; up to 10 mm is bridged: measure again or "
      "add "
      "points",
      "a large gap");
    check_text(
      message_of([&]() { read_profile_file(folder + "broken_loop.txt", rail); }).substr(folder.size()),
      "broken_loop.txt: the line of points crosses itself between line 101 and line 110; a profile without "
      "loops is needed: remove the points of the loop",
      "a loop");
    points.clear();
    for (const Point2 &p : sampled(rail_profile("54E1").head, 2e-3, 5e-4, 5))
      points.push_back(p);
    check_refused(columns(points),
                  rail,
                  "p.txt: the points scatter by 0.335 mm about a smooth line, which is no measured profile "
                  "(up to 0.3 mm is smoothed): measure again, or set Profiles/Smoothing",
                  "noise of half a millimetre");
  }

  void
  test_kind_messages()
  {
    const auto rail = options(ProfileKind::rail), wheel = options(ProfileKind::wheel);
    check_refused(columns(head()),
                  wheel,
                  "p.txt: no wheel profile: both of its ends hang down, the one without the flange to 0.2 mm "
                  "above the lowest point; a tread with its flange on one side is needed (this may be a "
                  "rail: Profiles/Rail takes those)",
                  "a rail head as wheel");
    check_refused(columns(sampled(wheel_profile("S1002").tread, 0.5e-3, 0, 1)),
                  rail,
                  "p.txt: no rail head: 115.7 mm wide; 40 mm to 95 mm is accepted (this may be a wheel: "
                  "Profiles/Wheel takes those)",
                  "a wheel as rail head");
    auto unmirrored   = wheel;
    unmirrored.mirror = ProfileMirror::no;
    check_refused(
      columns(sampled(wheel_profile("S1002").tread, 0.5e-3, 0, 1), -1e3),
      unmirrored,
      "p.txt: with Profiles/Wheel mirror = no the flange lies on the field side; write auto or yes",
      "a flange on the field side");
    std::vector<Point2> points;
    for (const Point2 &p : head())
      if (p.x < 0)
        points.push_back(p);
    check_refused(
      columns(points), rail, "p.txt: no rail head: 35.4 mm wide; 40 mm to 95 mm is accepted", "half a head");
    points.clear();
    for (const Point2 &p : head())
      if (p.y > -3e-3)
        points.push_back(p);
    check_refused(columns(points),
                  rail,
                  "p.txt: not enough of a rail head: its ends lie 2.9 mm and 2.8 mm below its top; the gauge "
                  "side down to the gauge height (14 mm) is needed, and the crown",
                  "a crown");
  }

  // The messages of joining heads and treads to the rest of rail and wheel.
  void
  test_body_messages()
  {
    const auto joined_rail = [](const std::vector<Point2> &points) {
      std::vector<std::string> notes;
      measured_rail(read_profile_text(columns(points), "p.txt", options(ProfileKind::rail)), "auto", notes);
    };
    const auto joined_wheel = [](const std::vector<Point2> &points) {
      std::vector<std::string> notes;
      measured_wheel(read_profile_text(columns(points), "p.txt", options(ProfileKind::wheel)), 0.135, notes);
    };
    const auto          tread = sampled(wheel_profile("S1002").tread, 0.5e-3, 0, 1);
    std::vector<Point2> points;
    for (const Point2 &p : head())
      if (p.y > -9e-3)
        points.push_back(p);
    check_text(message_of([&]() { joined_rail(points); }),
               "p.txt: neither side of the head reaches 14 mm below the top, where the gauge is measured; a "
               "profile that goes deeper is needed",
               "no side of the head");
    points.clear();
    for (const Point2 &p : tread)
      if (p.x > -60e-3)
        points.push_back(p + Point2{20e-3, 0});
    check_text(message_of([&]() { joined_wheel(points); }),
               "p.txt: the running circle cannot be found: the flange tip lies at x = -35 mm, where -63 mm "
               "to -47 mm is expected with the origin on the running circle, and the flange back was not "
               "measured; shift the lateral coordinates so that the running circle has 0",
               "no running circle");
    points.clear();
    for (const Point2 &p : tread)
      if (p.x < -1e-3)
        points.push_back({p.x, 1.3 * p.y});
    check_text(message_of([&]() { joined_wheel(points); }),
               "p.txt: the profile does not reach the running circle, 70 mm from the flange back; a tread on "
               "both sides of it is needed",
               "a tread that ends before the running circle");
    points.clear();
    for (const Point2 &p : tread)
      if (p.x > -48e-3)
        points.push_back(p);
    check_text(message_of([&]() { joined_wheel(points); }),
               "p.txt: the profile ends at x = -47.6 mm, y = -25.6 mm before the top of the flange; the "
               "whole flange front and its tip are needed",
               "half a flange");
  }

  // Without loss: profiles from points in place of the standard ones give the same contact.
  void
  test_contact()
  {
    const RailProfile  rail  = rail_profile("60E1");
    const WheelProfile wheel = wheel_profile("S1002");
    struct Case
    {
      double      noise, place, distance, radius;
      const char *what;
    };
    for (const Case &c : {Case{0, 1e-6, 1e-7, 0.01, "without noise"},
                          Case{5e-6, 3e-4, 5e-6, 0.3, "with 5 micrometres of noise"}})
      for (const double shift : {-2e-3, 0., 3e-3})
        {
          std::vector<std::string> notes;
          std::vector<Point2>      head_points;
          for (const Point2 &p : sampled(rail.head, 0.5e-3, c.noise, 7))
            if (p.y > -28e-3)
              head_points.push_back(p);
          const RailProfile measured_r = measured_rail(
            read_profile_text(columns(head_points), "p.txt", options(ProfileKind::rail)), "auto", notes);
          const WheelProfile measured_w = measured_wheel(
            read_profile_text(
              columns(sampled(wheel.tread, 0.5e-3, c.noise, 8)), "p.txt", options(ProfileKind::wheel)),
            0.135,
            notes);
          check(std::any_of(notes.begin(),
                            notes.end(),
                            [](const std::string &n) { return n.find("body of the rail: 60E1") == 0; }),
                "the head is known as that of a 60E1");
          const ContactGeometry exact = find_contact(rail, wheel, TrackDimensions(), shift, RollMode::none);
          const ContactGeometry ours =
            find_contact(measured_r, measured_w, TrackDimensions(), shift, RollMode::none);
          const std::string name = std::string(c.what) + ", shift " + std::to_string(1e3 * shift) + " mm: ";
          check_near(ours.rail_x, exact.rail_x, c.place, name + "contact point on the rail [m]");
          check_near(ours.wheel_x, exact.wheel_x, c.place, name + "contact point on the wheel [m]");
          const FrameProfile w(measured_w.tread, ours.wheel, ours.frame),
            r(measured_r.head, ours.rail, ours.frame), w0(wheel.tread, exact.wheel, exact.frame),
            r0(rail.head, exact.rail, exact.frame);
          double worst = 0;
          for (double s = -6e-3; s <= 6e-3; s += 1e-4)
            {
              // the same places: the frames differ by the difference of the contact points
              const double there = exact.frame.to_frame(ours.frame.to_track({s, 0})).x;
              worst =
                std::max(worst, std::abs(undeformed_distance(w, r, s) - undeformed_distance(w0, r0, there)));
            }
          check_near(worst, 0, c.distance, name + "undeformed distance within 6 mm [m]");
          const double relative =
            (ours.rail_curvature + ours.wheel_curvature) / (exact.rail_curvature + exact.wheel_curvature);
          check_near(relative, 1, c.radius, name + "relative lateral curvature, measured over exact");
        }
  }
} // namespace

int
main()
{
  test_samples();
  test_smoothing();
  test_kinks();
  test_mending();
  test_contact();
  test_text_messages();
  test_header_messages();
  test_shape_messages();
  test_kind_messages();
  test_body_messages();
  return test::report();
}
