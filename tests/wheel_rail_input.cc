// label: fast

// The scene as input of the wheel-rail module of CONTACT: the lines of an input that CONTACT has read, and
// profiles that give the same contact when they are read back.
#include "messages.h"

#include <limits>
#include <wheelrail/contactfiles/wheel_rail_input.h>
#include <wheelrail/geometry/contact_geometry.h>
#include <wheelrail/profiles/measured_profiles.h>
#include <wheelrail/profiles/profile_file.h>

#include <algorithm>
#include <sstream>
#include <vector>

using namespace wheelrail;
using test::message_of;
using test::near;
using test::same_text;

namespace
{
  /// Lines without remarks; of each, what stands before the names.
  std::vector<std::string>
  lines_of(const std::string &text)
  {
    std::istringstream       stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
      if (!line.empty() && line[0] != '%')
        lines.push_back(line.substr(0, line.find("   ")));
    return lines;
  }

  /// The shift of 1.5 mm moves the flange off the rail, to the left in CONTACT.
  BOOST_AUTO_TEST_CASE(test_lines)
  {
    Scene scene;
    scene.velocity               = 10;
    scene.traction_coefficient   = 0.25;
    scene.lateral_shift          = 1.5e-3;
    scene.halfspace_element_size = 0.25e-3;
    const auto files             = wheel_rail_input(scene, make_geometry(scene), 100e3, "r.txt", "w.txt");
    const std::vector<std::string> expected = {" 1 MODULE",
                                               " 1203110",
                                               " 0022033",
                                               " 0001221",
                                               " 999 200 50 1 1e-05",
                                               " 0.5 0.5",
                                               " 0.3 0.3 80769.23077 80769.23077",
                                               " 0.25 0.25 1",
                                               " 14 0 1435 0.02499479362",
                                               " 'r.txt' 0 1.0 0.0",
                                               " 0 0 0 0 0 0",
                                               " 1360 -70 460",
                                               " 'w.txt' 0 1.0 0.0",
                                               " 0 -1.5 100000 0 0 0",
                                               " 10000 0 0 0 0 -25000",
                                               " 0 MODULE"};
    const auto                     lines    = lines_of(files.input);
    BOOST_TEST(near(double(lines.size()), double(expected.size()), 0, "lines"));
    for (std::size_t k = 0; k < std::min(lines.size(), expected.size()); ++k)
      BOOST_TEST(same_text(lines[k], expected[k], "line " + std::to_string(k + 1)));

    scene.drive         = Drive::rate;
    scene.creepage      = 0.002;
    scene.lateral_shift = 0;
    const auto held = lines_of(wheel_rail_input(scene, make_geometry(scene), 100e3, "r.txt", "w.txt").input);
    BOOST_TEST(same_text(held[1], " 1203100", "control digits with a held rate"));
    std::istringstream words(held[14]);
    double             value = 0;
    for (int k = 0; k < 6; ++k)
      words >> value;
    // local radius 460.429 mm
    BOOST_TEST(near(value, -10 / 0.460429 * 1.002, 5e-5, "pitch rate [rad/s]"));
  }

  BOOST_AUTO_TEST_CASE(test_profiles)
  {
    const Scene        scene;
    const auto         files = wheel_rail_input(scene, make_geometry(scene), 100e3, "r.txt", "w.txt");
    ProfileFileOptions exact;
    exact.noise                      = 0;
    ProfileFileOptions wheel_options = exact;
    wheel_options.kind               = ProfileKind::wheel;
    std::vector<std::string> notes;
    const auto rail = measured_rail(read_profile_text(files.rail, "r.txt", exact), "54E1", notes);
    const auto wheel =
      measured_wheel(read_profile_text(files.wheel, "w.txt", wheel_options), scene.wheel.rim_width, notes);
    const auto read = find_contact(rail, wheel, scene.track, {0, scene.roll}),
               own = find_contact(rail_profile("54E1"), wheel_profile("S1002"), scene.track, {0, scene.roll});
    BOOST_TEST(
      near(read.rolling_radius, own.rolling_radius, 2e-6, "rolling radius of the profiles read back [m]"));
    BOOST_TEST(near(read.angle, own.angle, 1e-3, "contact angle of the profiles read back"));
    // CONTACT wants the rail from the gauge side to the field side and the wheel the other way, z down
    const auto number = [](const std::string &text, const int which) {
      std::istringstream words(text);
      double             value = 0;
      for (int k = 0; k <= which; ++k)
        words >> value;
      return value;
    };
    BOOST_TEST((number(files.rail, 0) < -30 && number(files.rail, 1) > 10),
               "the rail begins low on its gauge side");
    BOOST_TEST((number(files.wheel, 0) > 50 && number(files.wheel, 1) < 0),
               "the wheel begins on the field side");
  }

  BOOST_AUTO_TEST_CASE(test_refused)
  {
    Scene scene;
    scene.friction.kind = FrictionKind::rational;
    BOOST_TEST(same_text(
      message_of([&]() { wheel_rail_input(scene, make_geometry(scene), 1e5, "r", "w"); }),
      "--contact-wheel-rail-input writes constant friction only: set Contact/Friction law = constant",
      "friction over speed"));
    scene.friction.kind = FrictionKind::constant;
    scene.roll          = RollMode::from_contact;
    BOOST_TEST(
      same_text(message_of([&]() { wheel_rail_input(scene, make_geometry(scene), 1e5, "r", "w"); }),
                "--contact-wheel-rail-input writes wheelsets without roll only: set Wheelset/Roll = none",
                "roll"));
    scene.roll = RollMode::none;
    scene.yaw  = 1e-3;
    BOOST_TEST(same_text(
      message_of([&]() { wheel_rail_input(scene, make_geometry(scene), 1e5, "r", "w"); }),
      "--contact-wheel-rail-input writes wheelsets that roll straight on only: set Wheelset/Yaw = 0 mrad, "
      "Wheelset/Lateral creepage = 0 and Half-space/Given spin = auto",
      "yaw"));
    scene.yaw          = 0;
    scene.track_radius = 300;
    BOOST_TEST(
      same_text(message_of([&]() { wheel_rail_input(scene, make_geometry(scene), 1e5, "r", "w"); }),
                "--contact-wheel-rail-input writes straight tracks only: set Track/Radius = straight",
                "a curve"));
    scene.track_radius       = std::numeric_limits<double>::infinity();
    scene.halfspace_distance = "hertz";
    BOOST_TEST(same_text(
      message_of([&]() { wheel_rail_input(scene, make_geometry(scene), 1e5, "r", "w"); }),
      "--contact-wheel-rail-input writes profiles only: set Half-space/Undeformed distance = profiles",
      "no profiles"));
  }
} // namespace
