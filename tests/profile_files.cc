// label: fast

// Profile files: formats, cleaning, smoothing, and the contact of profiles from files.

#include "near.h"
#include "profile_samples.h"

#include <wheelrail/geometry/contact_geometry.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/profiles/measured_profiles.h>
#include <wheelrail/profiles/measurement_noise.h>
#include <wheelrail/profiles/profile_file.h>
#include <wheelrail/profiles/smoothing_spline.h>
#include <wheelrail/wheel/halfspace_case.h>
#include <wheelrail/wheel/noise_effect.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using namespace wheelrail;
using test::columns;
using test::near;
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

  BOOST_AUTO_TEST_CASE(test_samples)
  {
    const MeasuredProfile prr = read_profile_file(folder + "worn_54E1.prr", options(ProfileKind::rail));
    const MeasuredProfile ban = read_profile_file(folder + "worn_54E1.ban", options(ProfileKind::rail));
    BOOST_TEST((has_note(prr, "unit mm as the file states") &&
                has_note(prr, "turned upside down: the vertical coordinate of the file points down")),
               "SIMPACK rail: unit and direction of z told");
    BOOST_TEST(
      has_note(
        ban,
        "mirrored: files of this format have the gauge side on the right; Profiles/Rail mirror changes it"),
      "MiniProf rail: mirrored");
    BOOST_TEST(near(prr.noise, 4e-6, 1e-6, "noise found in the points, made with 4 micrometres [m]"));
    double worst = 0;
    for (double t = 0; t < prr.curve.parameter_end(); t += 0.3)
      {
        const Point2 p = prr.curve.at(t).position, q = p + Point2{-1.5e-3, 4e-3};
        worst = std::max(worst, norm(ban.curve.at(ban.curve.closest(q)).position - q));
      }
    BOOST_TEST(
      near(worst, 0, 1e-6, "the same rail as SIMPACK and as MiniProf file: the same curve, moved [m]"));

    const MeasuredProfile prw = read_profile_file(folder + "worn_S1002.prw", options(ProfileKind::wheel));
    const MeasuredProfile txt =
      read_profile_file(folder + "worn_S1002_metres.txt", options(ProfileKind::wheel));
    BOOST_TEST(
      (has_note(txt, "mirrored: the flange of the file lies at positive lateral coordinates") &&
       has_note(txt,
                "unit taken as m, since the profile then is 129.5 mm wide; Profiles/Wheel unit changes it")),
      "two columns in metres, flange on the right: told");
    worst = 0;
    for (double t = 0; t < prw.curve.parameter_end(); t += 0.3)
      {
        const Point2 p = prw.curve.at(t).position, q = p + Point2{-31.5e-3, 0};
        worst = std::max(worst, norm(txt.curve.at(txt.curve.closest(q)).position - q));
      }
    BOOST_TEST(
      near(worst, 0, 1e-6, "the same wheel as SIMPACK and as mirrored two-column file in metres [m]"));
    for (const MeasuredProfile *p : {&prr, &ban, &prw, &txt})
      BOOST_TEST(p->curve.at(0).position.x > p->curve.at(p->curve.parameter_end()).position.x,
                 p->file.substr(folder.size()) + " runs from the field side");
  }

  // The smoothed curve against the exact one where wheels and rails touch.
  BOOST_AUTO_TEST_CASE(test_smoothing)
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
          BOOST_TEST(near(distance, 0, c.distance, name + ": largest distance from the exact profile [m]"));
          BOOST_TEST(
            near(curvature, 0, c.curvature, name + ": largest error of the mean curvature over 5 mm [1/m]"));
        }
  }

  BOOST_AUTO_TEST_CASE(test_kinks)
  {
    std::vector<Point2> points;
    for (int i = 0; i <= 80; ++i)
      points.push_back({5e-4 * i, i < 40 ? 0. : 5e-4 * (i - 40)});
    const std::vector<double> exact(points.size(), 0);
    const auto                kinks = find_kinks(points, exact);
    BOOST_TEST((kinks.size() == 1 && kinks[0] == 40), "one kink of 45 degrees found where it is");
    const Curve curve(smoothing_spline(points, kinks, std::vector<double>(points.size(), 1e-5)));
    BOOST_TEST(
      near(norm(curve.at(curve.closest(points[40])).position - points[40]), 0, 1e-8, "and kept [m]"));

    points.clear();
    for (int i = 0; i <= 60; ++i)
      points.push_back({3e-3 * std::cos(0.05 * i), 3e-3 * std::sin(0.05 * i)});
    BOOST_TEST(find_kinks(points, std::vector<double>(points.size(), 0)).empty(),
               "an arc of 3 mm has no kinks");
  }

  // A defect, what is done about it, and how little it moves the curve.
  BOOST_AUTO_TEST_CASE(test_mending)
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
      BOOST_TEST(has_note(mended, note), what + ": told");
      for (const std::string &n : mended.notes)
        BOOST_TEST_MESSAGE("  note: " + n);
      BOOST_TEST(near(worst, 0, 2e-6, what + ": distance from the curve without it [m]"));
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

  // Without loss: profiles from points in place of the standard ones give the same contact.
  BOOST_AUTO_TEST_CASE(test_contact)
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
          BOOST_TEST(std::any_of(notes.begin(),
                                 notes.end(),
                                 [](const std::string &n) { return n.find("body of the rail: 60E1") == 0; }),
                     "the head is known as that of a 60E1");
          const ContactGeometry exact = find_contact(rail, wheel, TrackDimensions(), {shift, RollMode::none});
          const ContactGeometry ours =
            find_contact(measured_r, measured_w, TrackDimensions(), {shift, RollMode::none});
          const std::string name = std::string(c.what) + ", shift " + std::to_string(1e3 * shift) + " mm: ";
          BOOST_TEST(near(ours.rail_x, exact.rail_x, c.place, name + "contact point on the rail [m]"));
          BOOST_TEST(near(ours.wheel_x, exact.wheel_x, c.place, name + "contact point on the wheel [m]"));
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
          BOOST_TEST(near(worst, 0, c.distance, name + "undeformed distance within 6 mm [m]"));
          const double relative =
            (ours.rail_curvature + ours.wheel_curvature) / (exact.rail_curvature + exact.wheel_curvature);
          BOOST_TEST(near(relative, 1, c.radius, name + "relative lateral curvature, measured over exact"));
        }
  }

  // Peak pressure of half-spaces [Pa] with a profile of these points, and by what share noise may move it.
  std::pair<double, double>
  peak_and_noise_effect(const ProfileKind kind, const std::string &text)
  {
    std::ofstream("noise.txt") << text;
    SceneInput input = scene_from_text(
      "",
      "noise",
      {std::string("Profiles/") + (kind == ProfileKind::rail ? "Rail" : "Wheel") + " = noise.txt"});
    input.scene.halfspace_bodies       = ContactBodies::half_spaces;
    input.scene.halfspace_element_size = 0.8e-3;
    const SceneGeometry geometry       = require_touching(input);
    return {halfspace_pressure(input.scene, geometry, 100e3, scene_offsets(input.scene)).peak,
            noise_effect(input.scene, geometry, 100e3).peak};
  }

  // A gap below the contact hides where the crown of 300 mm goes over to 80 mm: what the bridge leaves open
  // is said. One beside the contact leaves nothing open.
  BOOST_AUTO_TEST_CASE(test_gaps)
  {
    const auto with = [](const double from, const double to) {
      std::vector<Point2> points;
      for (const Point2 &p : head())
        if (p.x < from || p.x > to)
          points.push_back(p);
      return peak_and_noise_effect(ProfileKind::rail, columns(points));
    };
    const double exact = with(0, 0).first;
    for (const double to : {-6e-3, -10e-3})
      {
        const auto [peak, effect] = with(-14e-3, to);
        const std::string name = "gap from -14 to " + std::to_string(1e3 * to) + " mm, below the contact: ";
        BOOST_TEST(effect > 0.05, name + "moves the peak pressure by " + std::to_string(100 * effect) + " %");
        BOOST_TEST(near(peak / exact, 1, std::min(effect, 0.05), name + "peak pressure over the exact one"));
      }
    const auto [peak, effect] = with(14e-3, 20e-3);
    BOOST_TEST(near(effect, 0, 0.01, "a gap beside the contact: what it moves the peak pressure by"));
    BOOST_TEST(near(peak / exact, 1, 0.005, "a gap beside the contact: peak pressure over the exact one"));
  }

  // The peak with noisy points differs from the exact one by less than is said of them, of 19 in 20.
  BOOST_AUTO_TEST_CASE(test_coverage)
  {
    unsigned int beyond = 0;
    for (const ProfileKind kind : {ProfileKind::rail, ProfileKind::wheel})
      {
        const Curve curve =
          kind == ProfileKind::rail ? rail_profile("60E1").head : wheel_profile("S1002").tread;
        const auto with = [&](const double noise, const unsigned int seed) {
          std::vector<Point2> points;
          for (const Point2 &p : sampled(curve, 0.5e-3, noise, seed))
            if (kind == ProfileKind::wheel || p.y > -28e-3)
              points.push_back(p);
          return peak_and_noise_effect(kind, columns(points));
        };
        const double exact = with(0, 1).first;
        for (unsigned int seed = 100; seed < 105; ++seed)
          {
            const auto [peak, effect] = with(1e-5, seed);
            beyond += std::abs(peak / exact - 1) > effect;
            BOOST_TEST(effect < 0.4,
                       "noise of 10 micrometres moves the peak by " + std::to_string(100 * effect) + " %");
          }
      }
    BOOST_TEST(beyond <= 1,
               std::to_string(beyond) + " of 10 noisy profiles move the peak farther than is said");
  }

  // Noise and rounding of a rail are found, are no kinks, and are counted by what they do to the pressure.
  BOOST_AUTO_TEST_CASE(test_noise)
  {
    const Curve head = rail_profile("60E1").head;
    struct Case
    {
      double      noise, rounding, least, most;
      const char *what;
    };
    for (const Case &c : {Case{0, 0, 0, 0.01, "exact rail"},
                          Case{1e-5, 0, 0, 1, "rail with 10 micrometres of noise"},
                          Case{5e-5, 0, 0.05, INFINITY, "rail with 50 micrometres of noise"},
                          Case{0, 1e-4, 0.05, INFINITY, "rail in tenths of a millimetre"}})
      {
        const std::string   name = c.what;
        std::vector<Point2> points;
        for (const Point2 &p : sampled(head, 0.5e-3, c.noise, 11))
          if (p.y > -28e-3)
            points.push_back(
              c.rounding > 0 ? c.rounding * Point2{std::round(p.x / c.rounding), std::round(p.y / c.rounding)}
                             : p);
        const std::string text = columns(points);
        if (c.noise > 0)
          BOOST_TEST(near(read_profile_text(text, "p.txt", options(ProfileKind::rail)).noise / c.noise,
                          1,
                          0.3,
                          name + ": found, over the real one"));
        const Point2 rounding = rounding_of(points);
        BOOST_TEST(near(rounding.x, c.rounding, 1e-9, name + ": rounding of x [m]"));
        BOOST_TEST(near(rounding.y, c.rounding, 1e-9, name + ": rounding of y [m]"));
        const double effect = peak_and_noise_effect(ProfileKind::rail, text).second;
        BOOST_TEST((effect >= c.least && effect <= c.most),
                   name + ": moves the peak pressure by " + std::to_string(100 * effect) + " %");
      }
  }
} // namespace
