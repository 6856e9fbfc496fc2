// needs: track

// What the program answers to unsuitable supports of the rail, word by word.

#include "messages.h"

#include <wheelrail/input/subject_checks.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/scene/rail_bending.h>

#include <string>
#include <vector>

using namespace wheelrail;
using test::message_of;
using test::near;
using test::same_text;

namespace
{
  void
  check_sets(const std::vector<std::string> &sets, const std::string &expected)
  {
    BOOST_TEST(same_text(
      message_of([&]() { require_computable(scene_from_text("", "x.prm", sets)); }), expected, sets.back()));
  }

  std::string
  warning(const std::vector<std::string> &sets)
  {
    Findings found;
    check_support(scene_from_text("", "x.prm", sets).scene, found);
    return found.warnings.empty() ? "none" : found.warnings.front();
  }
} // namespace


BOOST_AUTO_TEST_CASE(messages_track)
{
  BOOST_TEST(same_text(warning({"Track/Pad stiffness = 100 MN/m"}),
                       "Track/Pad stiffness = 100 MN/m: without effect, since Track/Support = clamped foot",
                       "pads below a clamped foot"));
  BOOST_TEST(same_text(warning({"Track/Sleeper spacing = 700 mm"}),
                       "Track/Sleeper spacing = 700 mm: without effect, since Track/Support = clamped foot",
                       "sleepers below it"));
  BOOST_TEST(
    same_text(warning({"Track/Support = continuous pads", "Track/Sleeper mass = 200 kg"}),
              "Track/Sleeper mass = 200 kg: without effect, since Track/Support = continuous pads rests on "
              "rigid ground",
              "sleepers below continuous pads"));
  BOOST_TEST(same_text(
    warning({"Track/Support = continuous pads", "Track/Pad stiffness = 0.3 MN/m"}),
    "Track/Pad stiffness = 0.3 MN/m: soft with what lies below; under 100 kN the rail sinks by about "
    "39 mm, where a usual track sinks by 1 mm or 2",
    "very soft pads"));
  const std::string sleepers = "Track/Support = sleepers", rail = "Track/Rail length = 5 m";
  check_sets(
    {"Track/Support = ballast"},
    "--set: Track/Support = ballast: not known here; clamped foot, continuous pads or sleepers is accepted");
  check_sets({sleepers, rail, "Track/Pad length = 700 mm"},
             "--set: Track/Pad length = 700 mm: not shorter than Track/Sleeper spacing = 600 mm; take "
             "shorter pads, or "
             "Track/Support = continuous pads");
  check_sets(
    {sleepers, "Track/Sleeper spacing = 2.5 m"},
    "--set: Track/Sleeper spacing = 2500 mm: with Track/First sleeper = 300 mm there is one sleeper below "
    "Track/Rail length = 1.8 m, and a rail needs two at least; take a longer rail or a shorter spacing");
  check_sets(
    {sleepers, "Track/Sleeper spacing = 5 m", "Track/First sleeper = 2 m"},
    "--set: Track/Sleeper spacing = 5000 mm: with Track/First sleeper = 2000 mm there is no sleeper below "
    "Track/Rail length = 1.8 m, and a rail needs two at least; take a longer rail or a shorter spacing");
  check_sets({sleepers, rail, "Track/Pad damping = constant", "Track/Pad loss factor = 0.6"},
             "--set: Track/Pad loss factor = 0.6: with Track/Pad damping = constant at most 0.5 is possible, "
             "which three "
             "branches keep to 4 %; take less, or damper");
  check_sets(
    {"Track/Damped ends = 1 m"},
    "--set: Track/Damped ends = 1 m: two of them and the rolled stretch of 60 mm are longer than Track/Rail "
    "length = 1.8 m; take shorter ones or a longer rail");
  BOOST_TEST(
    same_text(warning({sleepers}),
              "Track/Rail length = 1.8 m: short for this support, on which a rail bends over some 0.74 m to "
              "either side "
              "of the wheel; its free ends make it sink and tilt more than a long one: take 3.1 m",
              "a short rail"));
  BOOST_TEST(same_text(warning({sleepers, rail}), "none", "a long one"));
  SupportData support;
  support.kind          = RailSupport::continuous_pads;
  support.pad_stiffness = 30e6;
  BOOST_TEST(near(rail_bending(support).deflection, 1.22e-8, 0.01e-8, "Winkler's deflection [m/N]"));
}
