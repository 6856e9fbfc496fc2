// label: fast

// Studies: what their axes accept, the cases that they make, and how cases are told apart.

#include "messages.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/input/study_cases.h>
#include <wheelrail/run/simulation.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <vector>

using namespace wheelrail;
using test::message_of;
using test::same_text;

namespace
{
  const std::string friction = "Contact/Friction coefficient: 0.1, 0.2, 0.3",
                    shift    = "Wheelset/Lateral shift: -1 mm, 2 mm";

  Scene
  scene_of(const std::string &axes, const std::vector<std::string> &more = {})
  {
    std::vector<std::string> sets = {"Study/Axes = " + axes, "Output/Folder = out"};
    sets.insert(sets.end(), more.begin(), more.end());
    return scene_from_text("", "x.prm", sets).scene;
  }

  std::vector<StudyCase>
  cases_of(const std::string &axes, const std::vector<std::string> &more = {})
  {
    return study_cases(scene_of(axes, more), "1.0");
  }

  BOOST_AUTO_TEST_CASE(test_cases)
  {
    const std::vector<StudyCase> grid = cases_of(friction + "; " + shift);
    BOOST_TEST(grid.size() == 6, "a grid of three and two values has six cases");
    BOOST_TEST((grid[0].scene.friction.at_rest == 0.1 && grid[0].scene.lateral_shift == -1e-3 &&
                grid[1].scene.friction.at_rest == 0.1 && grid[1].scene.lateral_shift == 2e-3 &&
                grid[5].scene.friction.at_rest == 0.3 && grid[5].scene.lateral_shift == 2e-3),
               "the last axis changes fastest");
    BOOST_TEST((grid[3].values == std::vector<std::string>({"0.2", "2 mm"})),
               "values as the listing writes them");
    BOOST_TEST(grid[3].name.rfind("friction_coefficient_0.2-lateral_shift_2_mm-", 0) == 0, grid[3].name);
    BOOST_TEST(
      same_text(grid[3].scene.folder, "out/" + grid[3].name, "a case has a folder below that of the study"));
    BOOST_TEST(
      same_text(grid[3].scene.title, "Friction coefficient 0.2, Lateral shift 2 mm", "title of a case"));
    BOOST_TEST(grid[3].scene.study.axes.empty(), "a case is no study");
    std::set<std::string> names;
    for (const StudyCase &one : grid)
      names.insert(one.name);
    BOOST_TEST(names.size() == 6, "six names");

    const std::string yield =
      "Rail material/Yield stress: none, 480 MPa; "
      "Wheel material/Yield stress: none, 480 MPa";
    const std::vector<StudyCase> pairs = cases_of(yield, {"Study/Combine = pairs"});
    BOOST_TEST((pairs.size() == 2 && std::isinf(pairs[0].scene.rail_material.yield_stress) &&
                pairs[1].scene.rail_material.yield_stress == 480e6 &&
                pairs[1].scene.wheel_material.yield_stress == 480e6),
               "pairs take the first values together, the second ones, ...");
    BOOST_TEST((pairs[1].name.rfind("yield_stress_480_mpa-", 0) == 0 && pairs[1].name.size() == 29),
               pairs[1].name);

    const Scene back =
      scene_from_text(print_parameters(scene_of(friction + "; " + shift)), "listing", {}).scene;
    BOOST_TEST(study_cases(back, "1.0").size() == 6, "the listing reads back");
    BOOST_TEST((study_cases(back, "1.0")[4].name == grid[4].name), "to the same cases");
  }

  /// The name of the case with friction 0.2.
  std::string
  name_of(const std::string &values, const std::vector<std::string> &more, const std::string &version = "1.0")
  {
    for (const StudyCase &one :
         study_cases(scene_of("Contact/Friction coefficient: " + values, more), version))
      if (one.values[0] == "0.2")
        return one.name;
    return "";
  }

  BOOST_AUTO_TEST_CASE(test_identity)
  {
    const std::string name = name_of("0.1, 0.2", {});
    BOOST_TEST(same_text(name_of("0.2, 0.5, 0.7", {}), name, "the place in the list does not matter"));
    BOOST_TEST(
      same_text(name_of("0.2", {"Contact/Friction coefficient = 0.7"}), name, "nor what the axis replaces"));
    BOOST_TEST(same_text(name_of("0.2", {"Title = another"}), name, "nor a title"));
    BOOST_TEST(
      same_text(name_of("0.2", {"Output/Checkpoint interval = 5 s"}), name, "nor how often a run is saved"));
    BOOST_TEST(same_text(name_of("0.2", {"Wheelset/Velocity = 38.888888888888886 m/s"}),
                         name_of("0.2", {"Wheelset/Velocity = 140 km/h"}),
                         "nor the unit of a value"));
    BOOST_TEST((name_of("0.2", {"Wheelset/Velocity = 141 km/h"}) != name), "another value is another case");
    BOOST_TEST((name_of("0.2", {"Mesh/Solution cell size = 2 mm"}) != name), "so are other cells");
    BOOST_TEST((name_of("0.2", {}, "1.1") != name), "so is another version of the program");

    const std::string file    = "Half-space/Undeformed distance = distance.txt";
    const auto        written = [&](const char *text) {
      std::ofstream("distance.txt") << text;
      return name_of("0.2", {file});
    };
    const std::string first = written("0 0 0"), other = written("0 0 1");
    BOOST_TEST((first != other && first == written("0 0 0")), "the content of a file counts");
    std::remove("distance.txt");

    // files that a scene names by way of others: the rail of an earlier run, a listed scene and what that
    // includes
    std::filesystem::create_directories("study_rail");
    const auto write = [](const char *path, const std::string &text) { std::ofstream(path) << text; };
    const auto named = [&] {
      return name_of("0.2",
                     {"Run/Rail = study_rail",
                      "Rail material/Yield stress = 480 MPa",
                      "Run/Passage list = study_listed.prm"});
    };
    write("study_rail/rail.h5", "a rail");
    write("study_listed.prm", "include study_included.prm\n# a remark\n");
    write("study_included.prm", "subsection Wheelset\n  set Lateral shift = 1 mm\nend\n");
    std::set<std::string> names{named()};
    BOOST_TEST(names.count(named()) == 1, "the same files, the same case");
    const auto is_new = [&](const std::string &what) { BOOST_TEST(names.insert(named()).second, what); };
    write("study_rail/rail.h5", "another rail");
    is_new("another rail.h5 is another case");
    std::filesystem::remove("study_rail/rail.h5");
    is_new("one that is gone, too");
    write("study_included.prm", "subsection Wheelset\n  set Lateral shift = 2 mm\nend\n");
    is_new("so is another include of a listed scene");
    write("study_profile.csv", "a profile");
    write("study_included.prm", "subsection Profiles\n  set Rail = ./study_profile.csv\nend\n");
    is_new("another profile of a listed scene");
    write("study_profile.csv", "another profile");
    is_new("and another content of that");
    write("study_listed.prm", "include study_included.prm\n# another remark\n");
    BOOST_TEST(names.count(named()) == 1, "a remark in a listed scene is none");
  }

  BOOST_AUTO_TEST_CASE(test_plan)
  {
    std::ostringstream out;
    const RunFunction  run = [](const Scene &, const SceneGeometry &, const RunOptions &) { return 0; };
    std::ofstream("study.prm") << "subsection Study\n  set Axes = " << friction
                               << "\n  set Compute = run\nend\n";
    BOOST_TEST((execute({"study", "study.prm", "--plan", "--set", "Output/Folder = out/"}, run, out) == 0),
               "study --plan");
    const auto plan = nlohmann::json::parse(out.str());
    BOOST_TEST((plan["cases"].size() == 3 && plan["compute"] == "run" && plan["folder"] == "out/" &&
                plan["axes"][0]["entry"] == "Contact/Friction coefficient" &&
                plan["axes"][0]["values"].size() == 3),
               "the plan holds axes and cases");
    const std::string parameters = plan["cases"][1]["parameters"];
    BOOST_TEST((scene_from_text(parameters, "case", {}).scene.friction.at_rest == 0.2),
               "and the parameter file of each");

    BOOST_TEST(
      same_text(message_of([&]() {
                  execute({"run", "study.prm"}, run, out);
                }),
                "study.prm: a study, since Study/Axes is set; ./wheelrail study study.prm computes its cases",
                "a study is no scene to run"));
    BOOST_TEST(
      same_text(message_of([&]() {
                  execute({"halfspace", "study.prm"}, run, out);
                }),
                "study.prm: a study, since Study/Axes is set; ./wheelrail study study.prm computes its cases",
                "nor for half-spaces"));
    std::ofstream("study.prm") << "set Title = one scene\n";
    BOOST_TEST(
      same_text(message_of([&]() {
                  execute({"study", "study.prm", "--plan"}, run, out);
                }),
                "study.prm: no study, since Study/Axes is not set; write in subsection Study, for instance, "
                "\"set Axes = Contact/Friction coefficient: 0.1, 0.2, 0.3\"",
                "a scene is no study"));
    std::remove("study.prm");
  }

  /// An axis that is refused, and why.
  void
  check_axes(const std::string &axes, const std::string &expected, const std::vector<std::string> &more = {})
  {
    BOOST_TEST(
      same_text(message_of([&]() {
                  std::vector<std::string> sets = {"Study/Axes = " + axes};
                  sets.insert(sets.end(), more.begin(), more.end());
                  require_none(study_faults(scene_from_text("", "x.prm", sets).scene), {{}, "x.prm", "", {}});
                }),
                expected,
                axes));
  }

  BOOST_AUTO_TEST_CASE(test_messages)
  {
    check_axes(
      "0.1, 0.2",
      "--set: Study/Axes = 0.1, 0.2: \"0.1, 0.2\" is no axis; write \"Section/Entry: value, value\", "
      "and a semicolon between two axes");
    check_axes(
      "Contact/Friction coeficient: 0.1",
      "--set: Study/Axes = Contact/Friction coeficient: 0.1: Contact/Friction coeficient: no such entry; "
      "the nearest is Contact/Friction coefficient");
    check_axes("Contct/Friction coefficient: 0.1",
               "--set: Study/Axes = Contct/Friction coefficient: 0.1: Contct/Friction coefficient: no such "
               "subsection; the nearest is Contact");
    check_axes(
      "Wheelset/Lateral shift: 1 mm, 2",
      "--set: Study/Axes = Wheelset/Lateral shift: 1 mm, 2: Wheelset/Lateral shift: \"2\": a bare number; "
      "a length with its unit is needed, such as 1.5 mm");
    check_axes("Wheelset/Lateral shift: 1 kN",
               "--set: Study/Axes = Wheelset/Lateral shift: 1 kN: Wheelset/Lateral shift: \"1 kN\": the unit "
               "\"kN\" is one of force; a length takes one of m, mm, um, km");
    check_axes(
      "Contact/Friction coefficient:",
      "--set: Study/Axes = Contact/Friction coefficient:: Contact/Friction coefficient: \"\": no value; "
      "a pure number is needed, such as 0.25 or 1/40");
    check_axes(
      "Output/Folder: a, b",
      "--set: Study/Axes = Output/Folder: a, b: Output/Folder: cannot vary within a study; every case "
      "gets a folder of its own");
    check_axes(
      "Study/Compute: run",
      "--set: Study/Axes = Study/Compute: run: Study/Compute: cannot vary within a study; every case "
      "gets a folder of its own");
    check_axes(friction + "; " + friction,
               "--set: Study/Axes = " + friction + "; " + friction +
                 ": Contact/Friction coefficient is two axes; put their values into one");
    check_axes(
      "Contact/Friction coefficient: 0.1, 0.2; Wheelset/Lateral shift: 0 mm",
      "x.prm: Study/Axes = Contact/Friction coefficient: 0.1, 0.2; Wheelset/Lateral shift: 0 mm: "
      "Wheelset/Lateral shift has 1 values and Contact/Friction coefficient 2; pairs need as many of "
      "each, or set Study/Combine = grid",
      {"Study/Combine = pairs"});
    check_axes("Wheelset/Lateral shift: 1 mm, 0.001 m",
               "x.prm: Study/Axes = Wheelset/Lateral shift: 1 mm, 0.001 m: Wheelset/Lateral shift takes the "
               "value 0.001 m twice, as 1 mm and as 0.001 m; keep one of them");
    check_axes(
      "Wheelset/Lateral shift: 1 mm, 1 mm; Wheelset/Velocity: 10 m/s, 36 km/h",
      "x.prm: Study/Axes = Wheelset/Lateral shift: 1 mm, 1 mm; Wheelset/Velocity: 10 m/s, 36 km/h: case 2 "
      "has the values of case 1; keep one of them",
      {"Study/Combine = pairs"});
    std::string many, ticks;
    for (int i = 1; i <= 101; ++i)
      {
        many += (i == 1 ? "" : ", ") + std::to_string(i) + " mm";
        ticks += (i == 1 ? "" : ", ") + std::to_string(i);
      }
    const std::string found = message_of([&]() {
      require_none(study_faults(scene_of("Half-space/Radius along: " + many + "; Output/Ticks: " + ticks)),
                   {{}, "x.prm", "", {}});
    });
    BOOST_TEST(
      (found.find(": more than 10000 cases; leave values out, or divide the study") != std::string::npos),
      found);
  }
} // namespace
