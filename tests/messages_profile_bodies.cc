// label: fast

// What the program answers to profiles of another kind and to those that fit on no rail or wheel, word
// by word.

#include "messages.h"
#include "profile_samples.h"

#include <wheelrail/profiles/measured_profiles.h>

#include <string>
#include <vector>

using namespace wheelrail;
using test::columns;
using test::message_of;
using test::same_text;
using test::sampled;
using test::sampled_head;

namespace
{
  ProfileFileOptions
  options(const ProfileKind kind)
  {
    ProfileFileOptions result;
    result.kind = kind;
    return result;
  }

  void
  check_refused(const std::string        &text,
                const ProfileFileOptions &how,
                const std::string        &expected,
                const std::string        &what)
  {
    BOOST_TEST(same_text(message_of([&]() { read_profile_text(text, "p.txt", how); }), expected, what));
  }

  BOOST_AUTO_TEST_CASE(test_kinds)
  {
    const auto rail = options(ProfileKind::rail), wheel = options(ProfileKind::wheel);
    check_refused(columns(sampled_head()),
                  wheel,
                  "p.txt: no wheel profile: both of its ends hang down, the one without the flange to 0 mm "
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
    for (const Point2 &p : sampled_head())
      if (p.x < 0)
        points.push_back(p);
    check_refused(
      columns(points), rail, "p.txt: no rail head: 35.3 mm wide; 40 mm to 95 mm is accepted", "half a head");
    points.clear();
    for (const Point2 &p : sampled_head())
      if (p.y > -3e-3)
        points.push_back(p);
    check_refused(columns(points),
                  rail,
                  "p.txt: not enough of a rail head: its ends lie 2.9 mm and 2.9 mm below its top; the gauge "
                  "side down to the gauge height (14 mm) is needed, and the crown",
                  "a crown");
  }

  // The messages of joining heads and treads to the rest of rail and wheel.
  BOOST_AUTO_TEST_CASE(test_bodies)
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
    for (const Point2 &p : sampled_head())
      if (p.y > -9e-3)
        points.push_back(p);
    BOOST_TEST(
      same_text(message_of([&]() { joined_rail(points); }),
                "p.txt: neither side of the head reaches 14 mm below the top, where the gauge is measured; a "
                "profile that goes deeper is needed, or Profiles/Rail origin (for half-spaces)",
                "no side of the head"));
    points.clear();
    for (const Point2 &p : sampled_head())
      if (p.x > 0 || p.y > -9e-3)
        points.push_back(p);
    BOOST_TEST(
      same_text(message_of([&]() { joined_rail(points); }),
                "p.txt: only the field side of the head reaches 14 mm below the top, where the gauge is "
                "measured; a profile that goes deeper on the gauge side is needed (when the sides are "
                "exchanged, set Profiles/Rail mirror)",
                "no gauge side"));
    points.clear();
    for (const Point2 &p : sampled_head())
      points.push_back({0.6 * p.x, p.y});
    BOOST_TEST(same_text(
      message_of([&]() { joined_rail(points); }),
      "p.txt: the gauge-side end of the head, 19.8 mm below the top of 54E1, lies 28.1 mm off the "
      "side of that rail, to which it is joined (up to 20 mm); check the orientation of the file, or "
      "set Profiles/Rail body to another one",
      "a head that is too narrow"));
    points.clear();
    for (const Point2 &p : tread)
      if (p.x > -60e-3)
        points.push_back(p + Point2{20e-3, 0});
    BOOST_TEST(same_text(
      message_of([&]() { joined_wheel(points); }),
      "p.txt: the running circle cannot be found: the flange tip lies at x = -35 mm, where -63 mm "
      "to -47 mm is expected with the origin on the running circle, 14 mm to 22 mm with the origin on "
      "the flange back, and the flange back was not measured; shift the lateral coordinates so that "
      "the running circle has 0, or set Profiles/Wheel origin",
      "no running circle"));
    points.clear();
    for (const Point2 &p : tread)
      if (p.x < -1e-3)
        points.push_back({p.x, 1.3 * p.y});
    BOOST_TEST(same_text(
      message_of([&]() { joined_wheel(points); }),
      "p.txt: the profile does not reach the running circle, 70 mm from the flange back; a tread on "
      "both sides of it is needed",
      "a tread that ends before the running circle"));
    points.clear();
    for (const Point2 &p : tread)
      if (p.x > -48e-3)
        points.push_back({p.x, 1.5 * p.y});
    BOOST_TEST(same_text(
      message_of([&]() { joined_wheel(points); }),
      "p.txt: the profile ends at x = -47.6 mm, y = -38.4 mm before the top of the flange, and an arc "
      "from there to the flange back makes no flange 20 mm to 40 mm high; more of the flange front is "
      "needed",
      "half a flange"));
  }
} // namespace
