// Where passages lead to, told from what each round adds; lists of wheels, and their messages.

#include "messages.h"

#include <wheelrail/reference/motion_file.h>
#include <wheelrail/run/passage_list.h>
#include <wheelrail/run/passage_trend.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

using namespace wheelrail;
using test::check;
using test::check_near;

namespace
{
  constexpr double least = 1e-5, change = 0.03;

  PassageTrend
  trend(const std::vector<RoundGrowth> &rounds)
  {
    return trend_of(rounds, least, change);
  }

  void
  test_trend()
  {
    check(trend({}) == PassageTrend::open, "nothing is known before the first");
    check(trend({{0, 0}}) == PassageTrend::shakedown, "a rail that does not yield has shaken down");
    std::vector<RoundGrowth> rounds;
    for (int n = 0; n < 6; ++n)
      {
        rounds.push_back({1e-3 * std::pow(0.3, n), 5e-4 * std::pow(0.3, n)});
        const bool below = rounds.back().strain < least;
        check(trend(rounds) == (below ? PassageTrend::shakedown : PassageTrend::open),
              "growth that falls to a third in each, round " + std::to_string(n + 1));
      }
    check(trend({{1e-3, 5e-4}, {1e-3, 5e-4}}) == PassageTrend::open, "two alike are not enough");
    check(trend({{1e-3, 5e-4}, {1.01e-3, 5e-4}, {1e-3, 4.9e-4}}) == PassageTrend::ratcheting, "ratcheting");
    check(trend({{1e-3, -5e-4}, {1e-3, -5e-4}, {1e-3, -5e-4}}) == PassageTrend::ratcheting,
          "ratcheting against the way");
    check(trend({{1e-3, 5e-4}, {1e-3, 4e-4}, {1e-3, 3e-4}}) == PassageTrend::open,
          "forward flow that still falls");
    check(trend({{1e-3, 5e-4}, {0.96e-3, 5e-4}, {0.96e-3, 5e-4}}) == PassageTrend::open,
          "one change that is too large, of the last two");
    check(trend({{1e-3, 5e-6}, {1e-3, -3e-6}, {1e-3, 2e-6}}) == PassageTrend::to_and_fro,
          "strain that grows without forward flow");
    test::check_text(
      in_words(PassageTrend::ratcheting, {1.2e-3, 3e-4}),
      "the rail ratchets: the largest plastic strain grew by 0.0012, the forward shear of the band "
      "by 0.0003 in the last round",
      "in words");
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

  void
  test_list()
  {
    Scene scene;
    scene.wheel_load           = 90e3;
    scene.traction_coefficient = 0.1;
    check(passage_scenes(scene).size() == 1, "without a list the scene is the round");
    const File file(
      "load [kN]; traction; velocity [km/h]\n100; 0.25; 140\n150; 0; 100  # heavy\n80; -25e-2; 140\n");
    scene.passage_list = file.path;
    const auto round   = passage_scenes(scene);
    check(round.size() == 3, "three wheels");
    check_near(round[1].wheel_load, 150e3, 1e-6, "the load of the second");
    check_near(round[2].traction_coefficient, -0.25, 1e-12, "the third brakes");
    check_near(round[1].velocity, 100 / 3.6, 1e-9, "the velocity of the second");
    for (const Scene &one : round)
      check_near(one.planned_load, 150e3, 1e-6, "fine cells are for the largest load");
    const File creepages("creepage [%]\n0.2\n");
    scene.passage_list = creepages.path;
    check(passage_scenes(scene)[0].drive == Drive::rate, "a creepage is held");
    check_near(passage_scenes(scene)[0].creepage, 2e-3, 1e-12, "of that size");
  }

  void
  refused(const std::string &text, const std::string &expected)
  {
    const File file(text);
    test::check_text(test::message_of([&]() { read_passage_list(file.path); }), file.path + expected, text);
  }

  void
  test_messages()
  {
    refused(
      "shift [mm]\n1\n",
      ":1: column \"shift [mm]\" is not known; there are load, traction, velocity and creepage, each with "
      "its unit in brackets, such as \"load [kN]\"");
    refused("traction [kN]\n1\n",
            ":1: column \"traction [kN]\": \"kN\" is no unit of a traction; %, or 1 is accepted");
    refused("load [kN]\n0\n",
            ":2: load = 0 is out of range; 1 kN to 500 kN is accepted, in the unit of the first line");
    refused("traction,creepage [%]\n0,1\n",
            ": traction and creepage; one follows from the other: leave one of the columns out");
    refused("load [kN]\n",
            ": no rows; such a table has a first line with names and units, and rows of numbers");
    test::check_text(test::message_of([]() { read_passage_list("no_such.csv"); }),
                     "no_such.csv: no such file; Run/Passage list needs a table with a row for each wheel",
                     "no file");
  }
} // namespace

int
main()
{
  test_trend();
  test_list();
  test_messages();
  return test::report();
}
