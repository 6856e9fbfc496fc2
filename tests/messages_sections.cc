// label: fast

// What the program answers when the wanted cells do not fit on rail and wheel at their contact point,
// word by word.

#include "messages.h"

#include <wheelrail/mesh/curve_stretch.h>
#include <wheelrail/mesh/rail_section.h>
#include <wheelrail/mesh/wheel_section.h>
#include <wheelrail/model/model.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

using namespace wheelrail;
using test::message_of;
using test::same_text;

namespace
{
  void
  check_message(const std::function<void()> &work, const std::string &expected)
  {
    BOOST_TEST(same_text(message_of(work), expected, expected));
  }

  /// S1002 on 54E1 at a lateral shift [m].
  struct Pair
  {
    explicit Pair(const double shift = 0)
      : contact(find_contact(rail, wheel, track, {shift, RollMode::none}))
    {
    }

    FineStrip
    strip(const double approach, const double margin, const double block) const
    {
      return make_fine_strip(contact,
                             FrameProfile(wheel.tread, contact.wheel, contact.frame),
                             FrameProfile(rail.head, contact.rail, contact.frame),
                             approach,
                             margin,
                             block);
    }

    /// A rail section whose strip has these block boundaries [m].
    void
    rail_section(const std::vector<double> &s, const double block = 16e-3) const
    {
      make_rail_section(rail, contact.rail, {contact.frame, s}, block);
    }

    RailProfile     rail  = rail_profile("54E1");
    WheelProfile    wheel = wheel_profile("S1002");
    TrackDimensions track;
    ContactGeometry contact;
  };

  BOOST_AUTO_TEST_CASE(test_geometry)
  {
    const Pair   pair;
    ContactFrame far;
    far.origin.x = 0.2;
    check_message(
      [&]() { FrameProfile(pair.rail.head, pair.contact.rail, far); },
      "A profile does not pass over the contact point (lateral coordinate 200 mm in the track plane) with a "
      "slope below 1.2. Tread and rail head have to lie above each other: look at Track/Gauge, "
      "Wheelset/Flange back distance and Lateral shift.");
    TrackDimensions deep;
    deep.gauge_height = 60e-3;
    check_message(
      [&]() { place_rail(pair.rail, deep); },
      "The gauge is to be measured 60 mm below the top of the rail, but the head of rail '54E1' has no point "
      "at that height. Give a Track/Gauge height on the side of the head (14 mm is usual).");
  }

  BOOST_AUTO_TEST_CASE(test_strips)
  {
    const Pair pair;
    check_message([&]() { pair.strip(0, 3e-3, 16e-3); },
                  "The fine strip cannot be laid out with an approach = 0 mm: a positive length is needed.");
    check_message([&]() { pair.strip(1e-4, -1e-3, 16e-3); },
                  "The fine strip cannot be laid out with a margin = -1 mm: a positive length is needed.");
    check_message([&]() { pair.strip(1e-4, 3e-3, 0); },
                  "The fine strip cannot be laid out with a block size = 0 mm: a positive length is needed.");
    check_message(
      [&]() { pair.strip(1e-4, 3e-3, 1); },
      "Wheel and rail are too steep at the contact point for a strip of fine cells: only 62.377 mm are left "
      "of 1000 mm. Choose a lateral shift without contact on the flange face, or a smaller cell size.");
  }

  BOOST_AUTO_TEST_CASE(test_sections)
  {
    const Pair pair;
    check_message(
      [&]() {
        pair.rail_section({-8e-3, 8e-3}, 0);
      },
      "The rail section cannot be divided into blocks of 0 mm: a positive block size is needed, 16 mm is "
      "usual.");
    check_message(
      [&]() {
        pair.rail_section({8e-3, -8e-3});
      },
      "The fine strip needs two or more ascending block boundaries.");
    check_message(
      [&]() {
        pair.rail_section({-80e-3, 80e-3});
      },
      "The fine strip from -80 mm to 80 mm reaches beyond the part of the profile from -42.104 mm to 21.862 "
      "mm that can be seen from the contact point. Use a narrower strip.");
    check_message([&]() { make_wheel_section(pair.wheel, {}, {}, {}, 0); },
                  "The wheel section cannot be built: a positive block size is needed, 16 mm is usual.");
    const auto wheel_section = [&](const double end) {
      make_wheel_section(pair.wheel, {}, pair.contact.wheel, {pair.contact.frame, {end, 0}}, 16e-3);
    };
    check_message(
      [&]() { wheel_section(-68e-3); },
      "The fine strip ends 0.727 mm before the end of the running surface; 0.8 mm are needed between "
      "them. Use a narrower strip or another lateral shift.");
    check_message(
      [&]() { wheel_section(-70e-3); },
      "The fine strip ends 1.691 mm beyond the end of the running surface; 0.8 mm are needed between "
      "them. Use a narrower strip or another lateral shift.");
    check_message(
      [&]() {
        pair.rail_section({-10e-3, 10e-3}, 80e-3);
      },
      "The section mesh has a folded block in its part 'running layer' at (-18.47 mm, -51.559 mm). The fine "
      "strip or the dimensions leave too little room there: reduce the block size, narrow the strip, or "
      "check the dimensions of the section.");
  }

  BOOST_AUTO_TEST_CASE(test_places)
  {
    const Pair pair;
    // the middle of the tread is nowhere as steep as a wall
    const MirroredCurve tread{std::make_shared<const Curve>(pair.wheel.tread), -1, 0.46};
    const double        middle = tread.curve->closest({0, 0});
    check_message(
      [&]() { tread.find_tangent(1.5, middle - 0.1, middle + 0.1, "wall"); },
      "The profile has no wall: its tangent nowhere has the angle of 85.9 degrees that marks this "
      "place. A section needs the complete outline of a rail, or a tread from the field side over the "
      "flange to its back, without steps.");
  }

  BOOST_AUTO_TEST_CASE(test_rail_length)
  {
    Scene scene;
    scene.rail_length      = 0.15;
    scene.rolling_distance = 0.1;
    check_message(
      [&]() { sweep_plan(scene, make_geometry(scene)); },
      "Track/Rail length is too short: the rolled stretch with its fine cells reaches from -31.966 mm to "
      "127.866 mm, the rail from -25 mm to 125 mm; take a longer rail or a shorter Run/Rolling distance");
  }
} // namespace
