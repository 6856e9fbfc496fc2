// label: fast
// needs: track sections

// Parameter files as texts: syntax, the ready scenes, and the command line that reads them.

#include "error_of.h"
#include "near.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/application/geometry_command.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/left_out.h>
#include <wheelrail/input/cross_checks.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/former_drive.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/model/scene_head.h>
#include <wheelrail/run/simulation.h>
#include <wheelrail/scene/one_wheel.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;
using test::same_text;

namespace
{
  BOOST_AUTO_TEST_CASE(test_syntax)
  {
    const std::string text =
      "set Title = a = b # remark\r\n\r\n# only a remark\r\nsubsection Run\r\n\tset Rolling "
      "distance=30mm\r\nend # of Run\r\nsubsection Contact\nend\nsubsection Run\nset Energy "
      "limit = 1/100\nend";
    const auto read = [](const std::string &given, const std::vector<std::string> &sets = {}) {
      return scene_from_text(given, "t.prm", sets).scene;
    };
    const Scene scene = read(text, {"Contact/Friction coefficient=0.4", "Title = c"});
    BOOST_TEST(near(scene.rolling_distance, 0.03, 0, "CRLF, tabs and no blanks around ="));
    BOOST_TEST(
      near(scene.energy_limit, 0.01, 0, "a subsection may come twice, the last line may lack its end"));
    BOOST_TEST(near(scene.friction.at_rest, 0.4, 0, "--set of an entry"));
    BOOST_TEST(same_text(scene.title, "c", "--set goes before the file"));
    BOOST_TEST(same_text(read(text).title, "a = b", "= and remark in a value"));
    const std::string braces = "{a|b}  {c} d";
    BOOST_TEST(same_text(
      read("set Title = " + braces).title, braces, "braces and several blanks in a value of a file"));
    BOOST_TEST(same_text(read("", {"Title = " + braces}).title, braces, "and of --set"));
    BOOST_TEST(same_text(read("\xEF\xBB\xBFset Title = mark").title, "mark", "byte order mark"));
    BOOST_TEST(
      same_text(read("SUBSECTION Run\nEND\nSET Title = x").title, "x", "keywords in capital letters"));
  }

  /// A line that ends with a backslash goes on in the next one.
  BOOST_AUTO_TEST_CASE(test_continuation)
  {
    const auto read = [](const std::string &text) { return scene_from_text(text, "t.prm", {}).scene; };
    BOOST_TEST(same_text(read("set Title = one \\\n   two \\  \r\n\tthree # four").title,
                         "one two three",
                         "three lines, blanks after the backslash"));
    BOOST_TEST(same_text(read("set \\\nTitle = x").title, "x", "a line is broken before the name"));
    const Scene remark = read("# a remark \\\nset Title = x # another \\\nsubsection Run # \\\nend");
    BOOST_TEST(same_text(remark.title, "x", "a backslash in a remark goes on nowhere"));
    const SceneInput input = scene_from_text("set Title = a\\\n b\n# \\\nsubsection Run\nend", "t.prm", {});
    BOOST_TEST(same_text(input.text, "set Title = ab\n#\nsubsection Run\nend\n", "the text that is kept"));
  }

  /// Whether a ready scene needs pads, sleepers or a wheelset, and the build leaves them out.
  bool
  of_subject_left_out(const std::filesystem::path &file)
  {
    try
      {
        const Scene scene = read_scene(file.string(), {}).scene;
        return scene.both_wheels && !is_built(Subject::vehicle);
      }
    catch (const InputError &error)
      {
        return std::string(error.what()).find(": this program is built without ") != std::string::npos;
      }
  }

  /// Every scene of prm/ is valid, and they and those of tests/runs/ say themselves what drives the wheel.
  BOOST_AUTO_TEST_CASE(test_ready_files)
  {
    const std::filesystem::path source = WHEELRAIL_SOURCE_DIR;
    for (const char *const folder : {"prm", "prm/studies", "tests/runs"})
      for (const auto &file : std::filesystem::directory_iterator(source / folder))
        if (file.path().extension() == ".prm" && !of_subject_left_out(file.path()))
          {
            const std::string name    = folder + ("/" + file.path().filename().string());
            const std::string message = test::error_of<InputError>([&]() {
              SceneInput input = read_scene(file.path().string(), {});
              BOOST_TEST(input.origin.count("Wheelset/Traction coefficient") == 1,
                         name + " states its traction");
              if (folder == std::string("prm"))
                {
                  // a whole wheelset is no run; one of its wheels is
                  if (input.scene.both_wheels)
                    {
                      BOOST_TEST(contact_checks(input.scene).errors.empty(),
                                 name + " is valid as a wheelset");
                      leave_wheelset(input.scene);
                    }
                  require_computable(input);
                }
            });
            BOOST_TEST(same_text(message, "", name + " is valid"));
          }
  }

  /// In what a ready scene differs from prm/rolling.prm, which it includes.
  void
  check_difference(const std::string &name, const std::map<std::string, std::string> &expected)
  {
    const std::string prm = std::string(WHEELRAIL_SOURCE_DIR) + "/prm/";
    const Scene base = read_scene(prm + "rolling.prm", {}).scene, scene = read_scene(prm + name, {}).scene;
    std::string found, wanted;
    for (const Entry &entry : entries())
      {
        if (entry.get(scene) != entry.get(base))
          found += entry.path() + " = " + entry.get(scene) + ";";
        if (const auto value = expected.find(entry.path()); value != expected.end())
          wanted += value->first + " = " + value->second + ";";
      }
    BOOST_TEST(same_text(found, wanted, "prm/" + name + " and prm/rolling.prm"));
  }

  BOOST_AUTO_TEST_CASE(test_included_scenes)
  {
    check_difference("quickstart.prm",
                     {{"Title", "quick start, coarse cells"},
                      {"Mesh/Solution cell size", "2 mm"},
                      {"Run/Standard error", "0.005"},
                      {"Run/Averaging distance", "10 mm"},
                      {"Output/Folder", "output/quickstart"},
                      {"Output/Ticks", "6"}});
    check_difference("rolling_plastic.prm",
                     {{"Title", "S1002 on 54E1, 140 km/h, driving, elastic-plastic"},
                      {"Rail material/Yield stress", "480 MPa"},
                      {"Wheel material/Yield stress", "480 MPa"},
                      {"Run/Rolling distance", "100 mm"},
                      {"Output/Folder", "output/rolling_plastic"}});
  }

  /// Scenes that say nowhere what drives the wheel: they were driven in earlier versions.
  BOOST_AUTO_TEST_CASE(test_former_drive)
  {
    const std::string said =
      ": Wheelset/Traction coefficient is not set: the wheel rolls freely, since its default is 0 now and "
      "was 0.25 "
      "in earlier versions; write \"set Traction coefficient = 0.25\" in subsection Wheelset for what they "
      "did, or "
      "0 to be rid of this note";
    const auto write = [](const std::string &name, const std::string &text) { std::ofstream(name) << text; };
    write("free.csv", "time [s], load [kN]\n0, 90\n1, 90\n");
    write("driven.csv", "time [s], torque [kN m]\n0, 1\n1, 1\n");
    write("wheels.csv", "load [kN]\n90\n");
    write("driven_wheels.csv", "load [kN], traction\n90, 0.1\n");
    write("says.prm", "subsection Wheelset\n  set Traction coefficient = 0.25\nend\n");
    write("silent.prm", "set Title = silent\n");
    const auto note = [](const std::vector<std::string> &sets) {
      return former_drive_note(scene_from_text("", "x.prm", sets));
    };
    BOOST_TEST(same_text(note({}), "x.prm" + said, "nothing said"));
    BOOST_TEST(near(scene_from_text("", "x.prm", {}).scene.traction_coefficient, 0, 0, "which rolls freely"));
    BOOST_TEST(
      same_text(note({"Wheelset/Motion = free.csv"}), "x.prm" + said, "nor in the table of the motion"));
    BOOST_TEST(
      same_text(note({"Run/Passage list = wheels.csv"}), "x.prm" + said, "nor in that of the passages"));
    BOOST_TEST(same_text(
      note({"Study/Axes = Contact/Friction coefficient: 0.1, 0.2"}), "x.prm" + said, "nor by a study"));
    BOOST_TEST(same_text(note({"Run/Passage list = silent.prm, says.prm, silent.prm"}),
                         "silent.prm" + said,
                         "one of the scenes of a list"));
    for (const std::string set : {"Wheelset/Traction coefficient = 0",
                                  "Wheelset/Drive = rate",
                                  "Wheelset/Motion = driven.csv",
                                  "Wheelset/Motion = missing.csv",
                                  "Run/Passage list = driven_wheels.csv",
                                  "Run/Passage list = says.prm, says.prm",
                                  "Study/Axes = Wheelset/Traction coefficient: 0, 0.1"})
      BOOST_TEST(same_text(note({set}), "", set + " says it"));

    std::string        told;
    std::ostringstream out;
    const RunFunction  run = [&](const Scene &, const SceneGeometry &, const RunOptions &options) {
      told = options.note;
      return 0;
    };
    execute({"run", "silent.prm"}, run, out);
    BOOST_TEST(same_text(told, "silent.prm" + said, "a run has it in its head"));
    BOOST_TEST(out.str().empty(), "and only there");
    execute({"run", "silent.prm", "--validate"}, run, out);
    BOOST_TEST(out.str().rfind("note: silent.prm" + said + "\n", 0) == 0, "--validate tells it");
    execute({"run", "says.prm"}, run, out);
    BOOST_TEST(same_text(told, "", "no note where the scene says it"));
  }

  /// What stands above the figures, in words.
  BOOST_AUTO_TEST_CASE(test_head)
  {
    const auto head = [](const std::vector<std::string> &sets, const HeadOf of = HeadOf::run) {
      const Scene scene = read_scene(std::string(WHEELRAIL_SOURCE_DIR) + "/prm/rolling.prm", sets).scene;
      std::string text;
      for (const HeadLine &line : scene_head(scene, 103.24e3, of))
        text += line.name + ": " + line.text + "; ";
      return text;
    };
    BOOST_TEST(same_text(head({}),
                         "wheel and rail: S1002 wheel on 54E1 rail, inclination 1:40; "
                         "running: wheel load 103.2 kN, 140 km/h, lateral shift 0 mm, yaw 0 mrad; "
                         "drive: driving, traction coefficient 0.25 of friction 0.5; "
                         "steel: rail elastic, wheel elastic; "
                         "support: foot and ends of the rail clamped; cells: of 1 mm; ",
                         "the main scene in words"));
    BOOST_TEST(same_text(
      head(split_list(
        "Wheelset/Side = left, Profiles/Rail = measured/a.ban, Track/Rail inclination = 0, Wheelset/Lateral "
        "shift = -2.5 mm, Wheelset/Yaw = 5 mrad, Wheelset/Roll = from contact, Wheelset/Lateral creepage = "
        "0.001, Wheelset/Traction coefficient = 0, Contact/Friction law = exponential, Rail material/Yield "
        "stress = 480 MPa, Mesh/Solution cell size = 2 mm")),
      "wheel and rail: left S1002 wheel on a.ban rail, inclination 0; "
      "running: wheel load 103.2 kN, 140 km/h, lateral shift -2.5 mm, yaw 5 mrad, roll from contact, "
      "lateral creepage 0.1 %; "
      "drive: rolling freely, traction coefficient 0, friction 0.5 at rest, 0.4 at high sliding speed; "
      "steel: rail yields at 480 MPa, wheel elastic; support: foot and ends of the rail clamped; cells: of 2 "
      "mm; ",
      "another scene"));
    BOOST_TEST(
      same_text(head({"Half-space/Undeformed distance = hertz",
                      "Half-space/Normal force = 100 kN",
                      "Wheelset/Drive = rate",
                      "Wheelset/Creepage = 0.002",
                      "Half-space/Element size = 0.25 mm"},
                     HeadOf::halfspaces),
                "surfaces: Half-space/Undeformed distance = hertz; running: normal force 100 kN, 140 km/h; "
                "drive: turning rate held at a creepage of 0.2 %, friction 0.5; elements: of 0.25 mm; ",
                "half-spaces without profiles"));
  }

  BOOST_AUTO_TEST_CASE(test_commands)
  {
    const std::string file = std::string(WHEELRAIL_SOURCE_DIR) + "/prm/quickstart.prm";
    Scene             scene;
    RunOptions        options;
    const RunFunction run = [&](const Scene &s, const SceneGeometry &, const RunOptions &o) {
      scene   = s;
      options = o;
      return 3;
    };
    std::ostringstream out;
    BOOST_TEST(near(
      execute({"run", file, "--set", "Title = x", "--set", "Contact/Damping = 0.1", "--overwrite"}, run, out),
      3,
      0,
      "run hands on the exit code"));
    BOOST_TEST(same_text(scene.title, "x", "run: --set"));
    BOOST_TEST(near(scene.contact_damping, 0.1, 0, "run: second --set"));
    BOOST_TEST((options.overwrite && !options.resume), "run: --overwrite");
    const std::string tail = "# --set \"Title = x\"\n# --set \"Contact/Damping = 0.1\"\n";
    BOOST_TEST((options.prm_text.find("set Title = quick start") != std::string::npos &&
                options.prm_text.substr(options.prm_text.size() - tail.size()) == tail),
               "run: the file as given with the changes as remarks");
    BOOST_TEST(same_text(options.parameters_text, print_parameters(scene), "run: all entries in force"));
    BOOST_TEST(near(execute({"parameters", file}, run, out), 0, 0, "parameters"));
    BOOST_TEST(
      same_text(out.str(), print_parameters(read_scene(file, {}).scene), "parameters prints the listing"));
    BOOST_TEST((needs_mpi({"run", "x.prm"}) && needs_mpi({"receptance", "x.prm"}) &&
                !needs_mpi({"run", "x.prm", "--validate"}) && !needs_mpi({"geometry"}) && !needs_mpi({})),
               "only a run needs MPI");
    unsetenv("PMIX_RANK");
    unsetenv("OMPI_COMM_WORLD_SIZE");
    BOOST_TEST(!needs_mpi({"wear", "x.prm"}), "wear by itself is one process");
    setenv("PMIX_RANK", "0", 1);
    BOOST_TEST((needs_mpi({"wear", "x.prm"}) && !needs_mpi({"halfspace", "x.prm"})),
               "under a launcher of MPI it shares");
    unsetenv("PMIX_RANK");
    const std::vector<double> shifts = parse_shifts("-6:6:0.5");
    BOOST_TEST(near(static_cast<double>(shifts.size()), 25, 0, "shifts: number"));
    BOOST_TEST(near(shifts.front(), -0.006, 0, "shifts: first"));
    BOOST_TEST(near(shifts.back(), 0.006, 0, "shifts: last"));
    BOOST_TEST(near(parse_shifts("-5.5,0,2").at(2), 0.002, 0, "shifts: list"));
    BOOST_TEST(
      near(static_cast<double>(parse_shifts("0:0.3:0.1").size()), 4, 0, "shifts: 0.3 in steps of 0.1"));
  }
} // namespace
