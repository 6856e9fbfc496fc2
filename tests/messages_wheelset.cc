// label: fast

// What the program answers to curves, cants, wheelsets and laws of wear that cannot be: word by word.

#include "messages.h"

#include <wheelrail/input/cross_checks.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/vehicle/wheelset_contact.h>

#include <string>
#include <vector>

using namespace wheelrail;
using test::message_of;
using test::same_text;


BOOST_AUTO_TEST_CASE(messages_wheelset)
{
  const auto answer = [](const std::vector<std::string> &sets) {
    return message_of([&]() { require_computable(scene_from_text("", "x.prm", sets)); });
  };
  BOOST_TEST(
    same_text(answer({"Track/Radius = 300 m"}),
              "--set: Track/Radius = 300 m: a run rolls straight on; write straight, or compute half-spaces "
              "(halfspace, vehicle), which take curves",
              "a run in a curve"));
  BOOST_TEST(
    same_text(answer({"Track/Radius = 3 m"}),
              "--set: Track/Radius = 3 m: too narrow for a track; 20 m is the least, to either side, or "
              "straight",
              "a curve that is no track"));
  BOOST_TEST(same_text(
    answer({"Wear/Damage peak at = 200 N"}),
    "--set: Wear/Damage peak at = 200 N: must lie between Wear/Damage begins at = 15 N and Wear/Damage "
    "ends at = 175 N",
    "a damage function without order"));
  BOOST_TEST(same_text(
    answer({"Wheelset/Wheels = both"}),
    "--set: Wheelset/Wheels = both: a run has one wheel; run --wheelset rolls the modelled one as it "
    "rolls on the wheelset, Wheels = one by itself",
    "a run of two wheels"));
  BOOST_TEST(
    same_text(answer({"Wheelset/Pose = equilibrium"}),
              "--set: Wheelset/Pose = equilibrium: forces balance on a whole wheelset; set Wheelset/Wheels = "
              "both, or write given",
              "the balance of one wheel"));
  BOOST_TEST(same_text(
    answer({"Track/Cant = 100 mm"}),
    "--set: Track/Cant = 100 mm: shares the load of an axle between two wheels; set Wheelset/Wheels "
    "= both, or write none",
    "cant with one wheel"));
  const auto findings = [](std::vector<std::string> sets) {
    sets.push_back("Wheelset/Wheels = both");
    const Findings found = contact_checks(scene_from_text("", "x.prm", sets).scene);
    return found.errors.empty() ? found.warnings.at(0) : found.errors.at(0);
  };
  BOOST_TEST(same_text(
    findings({"Wheelset/Pose = equilibrium", "Wheelset/Axle = independent"}),
    "Wheelset/Pose = equilibrium: wheels that turn by themselves do not steer, so that no yaw follows "
    "from forces; write given, or set Wheelset/Axle = rigid",
    "the balance of independent wheels"));
  BOOST_TEST(same_text(
    findings({"Half-space/Undeformed distance = hertz"}),
    "Half-space/Undeformed distance = hertz: Wheelset/Wheels = both needs profiles on both rails; set "
    "it to profiles, or Wheels to one",
    "two wheels without profiles"));
  BOOST_TEST(same_text(
    findings({"Track/Cant = -100 mm", "Track/Radius = 1000 m", "Wheelset/Velocity = 40 km/h"}),
    "Track/Cant = -100 mm: the inner rail of the curve is the higher one; in Track/Radius = 1000 m a "
    "cant of the other sign leans inwards",
    "a cant that leans outwards"));
  BOOST_TEST(same_text(
    findings({"Track/Cant = 0 mm", "Track/Radius = 300 m", "Wheelset/Velocity = 140 km/h"}),
    "Wheelset/Velocity = 140 km/h: 5.0 m/s2 beyond what the cant balances lift the left-hand wheel; "
    "look at radius, cant and velocity",
    "a curve that is too fast"));
  BOOST_TEST(same_text(
    findings({"Track/Cant = 0 mm", "Track/Radius = 500 m", "Wheelset/Velocity = 140 km/h"}),
    "Wheelset/Velocity = 140 km/h: leaves 3.0 m/s2 across the track unbalanced, where 1 m/s2 is much; "
    "look at radius, cant and velocity",
    "a fast curve"));
  Scene fast = scene_from_text("",
                               "x.prm",
                               {"Wheelset/Wheels = both",
                                "Wheelset/Pose = equilibrium",
                                "Track/Cant = 0 mm",
                                "Track/Radius = 300 m",
                                "Wheelset/Velocity = 500 km/h"})
                 .scene;
  fast.wheel_load = 100e3;
  BOOST_TEST(same_text(
    test::message_of([&]() {
      solve_wheelset(
        wheel_of_wheelset(fast, false), wheel_of_wheelset(fast, true), read_wheelset_profiles(fast), {}, 1);
    }),
    "Wheelset/Velocity = 500 km/h: 64.3 m/s2 beyond what the cant balances lift the left-hand wheel: "
    "the vehicle tips over, and no Wheelset/Pose = equilibrium exists; write given, or change radius, "
    "cant or velocity",
    "a curve in which nothing balances"));
}
