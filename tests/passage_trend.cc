// label: fast

// Where passages lead to, told from what each round adds; lists of wheels, and their messages.

#include "messages.h"

#include <wheelrail/input/motion_file.h>
#include <wheelrail/model/model.h>
#include <wheelrail/run/passage_list.h>
#include <wheelrail/run/passage_table.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

using namespace wheelrail;
using test::near;

namespace
{
  constexpr double least = 1e-5, change = 0.03;

  PassageTrend
  trend(const std::vector<RoundGrowth> &rounds)
  {
    return trend_of(rounds, least, change);
  }

  BOOST_AUTO_TEST_CASE(test_trend)
  {
    BOOST_TEST((trend({}) == PassageTrend::open), "nothing is known before the first");
    BOOST_TEST((trend({{0, 0}}) == PassageTrend::shakedown), "a rail that does not yield has shaken down");
    std::vector<RoundGrowth> rounds;
    for (int n = 0; n < 6; ++n)
      {
        rounds.push_back({1e-3 * std::pow(0.3, n), 5e-4 * std::pow(0.3, n)});
        const bool below = rounds.back().strain < least;
        BOOST_TEST((trend(rounds) == (below ? PassageTrend::shakedown : PassageTrend::open)),
                   "growth that falls to a third in each, round " + std::to_string(n + 1));
      }
    BOOST_TEST((trend({{1e-3, 5e-4}, {1e-3, 5e-4}}) == PassageTrend::open), "two alike are not enough");
    BOOST_TEST((trend({{1e-3, 5e-4}, {1.01e-3, 5e-4}, {1e-3, 4.9e-4}}) == PassageTrend::ratcheting),
               "ratcheting");
    BOOST_TEST((trend({{1e-3, -5e-4}, {1e-3, -5e-4}, {1e-3, -5e-4}}) == PassageTrend::ratcheting),
               "ratcheting against the way");
    BOOST_TEST((trend({{1e-3, 5e-4}, {1e-3, 4e-4}, {1e-3, 3e-4}}) == PassageTrend::open),
               "forward flow that still falls");
    BOOST_TEST((trend({{1e-3, 5e-4}, {0.96e-3, 5e-4}, {0.96e-3, 5e-4}}) == PassageTrend::open),
               "one change that is too large, of the last two");
    BOOST_TEST((trend({{1e-3, 5e-6}, {1e-3, -3e-6}, {1e-3, 2e-6}}) == PassageTrend::to_and_fro),
               "strain that grows without forward flow");
    BOOST_TEST(test::same_text(
      in_words(PassageTrend::ratcheting, {1.2e-3, 3e-4}),
      "the rail ratchets: the largest plastic strain grew by 0.0012, the forward shear of the plastic zone "
      "by 0.0003 in the last round",
      "in words"));
  }

  /// A list for the time of a check.
  class File
  {
  public:
    explicit File(const std::string &text)
      : path((std::filesystem::temp_directory_path() / ("passages_" + std::to_string(getpid()) + ".csv"))
               .string())
    {
      std::ofstream(path) << text;
    }
    ~File()
    {
      std::filesystem::remove(path);
    }
    const std::string path;
  };

  std::vector<PassingWheel>
  wheels_of(const Scene &scene)
  {
    return passing_wheels(scene, make_geometry(scene));
  }

  BOOST_AUTO_TEST_CASE(test_list)
  {
    Scene scene;
    scene.wheel_load           = 90e3;
    scene.traction_coefficient = 0.1;
    BOOST_TEST(wheels_of(scene).size() == 1, "without a list the scene is the round");
    const File file(
      "load [kN]; traction; velocity [km/h]\n100; 0.25; 140\n150; 0; 100  # heavy\n80; -25e-2; 140\n");
    scene.passage_list = file.path;
    const auto round   = wheels_of(scene);
    BOOST_TEST(round.size() == 3, "three wheels");
    BOOST_TEST(near(round[1].scene.wheel_load, 150e3, 1e-6, "the load of the second"));
    BOOST_TEST(near(round[2].scene.traction_coefficient, -0.25, 1e-12, "the third brakes"));
    BOOST_TEST(near(round[1].scene.velocity, 100 / 3.6, 1e-9, "the velocity of the second"));
    for (const PassingWheel &one : round)
      {
        BOOST_TEST(near(one.scene.planned_load, 150e3, 1e-6, "fine cells are for the largest load"));
        BOOST_TEST(one.scene.planned_strip.empty(), "and at one place, where all touch");
      }
    const File creepages("creepage [%]\n0.2\n");
    scene.passage_list = creepages.path;
    BOOST_TEST((wheels_of(scene)[0].scene.drive == Drive::rate), "a creepage is held");
    BOOST_TEST(near(wheels_of(scene)[0].scene.creepage, 2e-3, 1e-12, "of that size"));
  }

  /// Wheels at several places: each has its own contact, and all have the same fine cells, which are around
  /// each of the patches.
  BOOST_AUTO_TEST_CASE(test_shifts)
  {
    Scene      scene;
    const File file("lateral shift [mm]\n-2\n0\n2\n");
    scene.passage_list = file.path;
    const auto round   = wheels_of(scene);
    BOOST_TEST(round.size() == 3, "three shifts");
    const std::vector<double> strip = round[0].scene.planned_strip;
    BOOST_REQUIRE_MESSAGE(strip.size() == 2 && strip[0] < strip[1], "there is a planned strip");
    const SweepPlan first = sweep_plan(round[0].scene, round[0].geometry);
    for (const PassingWheel &one : round)
      {
        const std::string at = " at " + std::to_string(1e3 * one.scene.lateral_shift) + " mm";
        BOOST_TEST((one.scene.planned_strip == strip), "the same strip" + at);
        const double x = one.geometry.contact.rail_x;
        BOOST_TEST((x > strip[0] + 5e-3 && x < strip[1] - 5e-3), "it is around the contact point" + at);
        const SweepPlan plan = sweep_plan(one.scene, one.geometry);
        double          off  = plan.rail.corners.size() == first.rail.corners.size() ? 0 : HUGE_VAL;
        for (std::size_t k = 0; k < first.rail.corners.size() && std::isfinite(off); ++k)
          off = std::max(off,
                         std::hypot(plan.rail.corners[k].x - first.rail.corners[k].x,
                                    plan.rail.corners[k].y - first.rail.corners[k].y));
        BOOST_TEST(near(off, 0, 1e-12, "the section of the rail is divided alike [m]" + at));
        BOOST_TEST((plan.rail_stations == first.rail_stations), "and along" + at);
        // where the wheel touches, its surface and that of the rail meet in the common frame
        const ContactFrame &frame = plan.surfaces.frame;
        const double        s     = frame.to_frame(one.geometry.contact.frame.origin).x;
        BOOST_TEST(near(
          plan.surfaces.outline.at(s).n - plan.surfaces.rail.smooth(s).n, 0, 1e-9, "the wheel touches" + at));
        BOOST_TEST(near(plan.surfaces.outline.at(s).slope - plan.surfaces.rail.smooth(s).slope,
                        0,
                        1e-5,
                        "with one tangent" + at));
      }
    BOOST_TEST(std::abs(round[0].geometry.contact.rail_x - round[2].geometry.contact.rail_x) > 5e-3,
               "the places differ by more than a few cells");
  }

  /// Scenes in a list may not change the rail.
  BOOST_AUTO_TEST_CASE(test_scenes)
  {
    Scene             scene;
    const std::string folder =
      std::filesystem::temp_directory_path() / ("scenes_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    const std::string heavy = folder + "/heavy.prm", other = folder + "/other.prm",
                      lists = folder + "/list.prm";
    std::ofstream(heavy)
      << "subsection Wheelset\n  set Wheel load = 120 kN\n  set Lateral shift = 1 mm\nend\n"
         "subsection Contact\n  set Friction coefficient = 0.3\nend\n";
    std::ofstream(other) << "subsection Rail material\n  set Yield stress = 300 MPa\nend\n";
    std::ofstream(lists) << "subsection Run\n  set Passage list = wheels.csv\nend\n";
    scene.folder       = "output/family";
    scene.passage_list = heavy + ", " + heavy;
    const auto round   = wheels_of(scene);
    BOOST_TEST(round.size() == 2, "two files");
    BOOST_TEST(near(round[0].scene.wheel_load, 120e3, 1e-6, "the load of the file"));
    BOOST_TEST(near(round[0].scene.friction.at_rest, 0.3, 1e-12, "and its friction"));
    BOOST_TEST(test::same_text(round[0].scene.folder, "output/family", "the folder of the family"));
    scene.passage_list = other;
    BOOST_TEST(test::same_text(
      test::message_of([&]() { wheels_of(scene); }),
      other + ": Rail material/Yield stress = 300 MPa: that is another rail than that of the scene "
              "whose Run/Passage list has this file, where it is none; wheels, loads, shifts and "
              "friction may differ",
      "another steel"));
    scene.passage_list = lists;
    BOOST_TEST(test::same_text(
      test::message_of([&]() { wheels_of(scene); }),
      lists + ": Run/Passage list = wheels.csv: a scene of a list cannot have one of its own; write "
              "none",
      "a list in a list"));
    std::filesystem::remove_all(folder);
  }

  void
  refused(const std::string &text, const std::string &expected)
  {
    const File file(text);
    BOOST_TEST(
      test::same_text(test::message_of([&]() { read_passage_list(file.path); }), file.path + expected, text));
  }

  BOOST_AUTO_TEST_CASE(test_messages)
  {
    refused("shift [mm]\n1\n",
            ":1: column \"shift [mm]\" is not known; there are load, lateral shift, traction, velocity and "
            "creepage, each with its unit in brackets, such as \"load [N]\"");
    refused("traction [kN]\n1\n",
            ":1: column \"traction [kN]\": \"kN\" is no unit of a traction; %, or 1 is accepted");
    refused("load [kN]\n0\n",
            ":2: load = 0 is out of range; 1 kN to 500 kN is accepted, in the unit of the first line");
    refused("traction,creepage [%]\n0,1\n",
            ": traction and creepage; one follows from the other: leave one of the columns out");
    refused("load [kN]\n",
            ": no rows; such a table has a first line with names and units, and rows of numbers");
    BOOST_TEST(
      test::same_text(test::message_of([]() { read_passage_list("no_such.csv"); }),
                      "no_such.csv: no such file; Run/Passage list needs a table with a row for each wheel",
                      "no file"));
  }
} // namespace
