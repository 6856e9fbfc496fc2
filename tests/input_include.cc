// label: fast
// needs: wear

// Parameter files that include others: whose value is in force, from where paths count, what is kept of the
// text, and what the program answers to faults, word by word.

#include "messages.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/run/simulation.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

using namespace wheelrail;
using test::message_of;
using test::near;
using test::same_text;

namespace
{
  namespace fs = std::filesystem;

  /// Writes a file below the test's own folder.
  void
  write(const std::string &name, const std::string &text)
  {
    fs::create_directories((fs::path("include") / name).parent_path());
    std::ofstream(fs::path("include") / name) << text;
  }

  Scene
  read(const std::string &name, const std::vector<std::string> &sets = {})
  {
    return read_scene("include/" + name, sets).scene;
  }

  void
  check_message(const std::string &name, const std::string &expected)
  {
    BOOST_TEST(same_text(message_of([&]() { read(name); }), expected, name));
  }

  // The value of the including file is in force wherever it stands, of two included files that of the later.
  void
  test_order()
  {
    write(
      "base.prm",
      "set Title = base\nsubsection Run\n  set Rolling distance = 30 mm\n  set Energy limit = 0.01\nend\n");
    write("other.prm", "subsection Run\n  set Energy limit = 0.02\nend\n");
    write("after.prm", "include base.prm\nset Title = after");
    write("before.prm", "set Title = before\ninclude base.prm");
    write("two.prm", "include base.prm\ninclude other.prm\n");
    write("turned.prm", "include other.prm\ninclude base.prm\n");
    write("deep.prm", "set Title = deep\ninclude two.prm\n");
    BOOST_TEST(same_text(read("after.prm").title, "after", "set after the include"));
    BOOST_TEST(same_text(read("before.prm").title, "before", "set before the include"));
    BOOST_TEST(near(read("before.prm").rolling_distance, 0.03, 0, "set in the included file alone"));
    BOOST_TEST(near(read("two.prm").energy_limit, 0.02, 0, "the later of two included files"));
    BOOST_TEST(near(read("turned.prm").energy_limit, 0.01, 0, "the other way round"));
    BOOST_TEST(same_text(read("deep.prm").title, "deep", "two levels down"));
    BOOST_TEST(near(read("deep.prm").energy_limit, 0.02, 0, "two levels down, not set above"));
    BOOST_TEST(same_text(read("deep.prm", {"Title = line"}).title, "line", "--set goes before all of them"));
  }

  void
  test_paths()
  {
    write("steels/mild.prm", "include common/density.prm\nset Young's modulus = 205 GPa\n");
    write("steels/common/density.prm", "set Density = 7800 kg/m3\n");
    write("scenes/a.prm", "subsection Rail material\n  include ../steels/mild.prm\nend\n");
    const Scene scene = read("scenes/a.prm");
    BOOST_TEST(near(scene.rail_material.youngs_modulus, 205e9, 0, "a path counts from the including file"));
    BOOST_TEST(near(scene.rail_material.density, 7800, 0, "so does that in the included one"));
    BOOST_TEST(near(scene.wheel_material.density, 7900, 0, "an include in a subsection belongs to it"));
    write("scenes/b.prm", "include " + fs::absolute("include/base.prm").string() + " # a whole path\n");
    BOOST_TEST(same_text(read("scenes/b.prm").title, "base", "a path from the root"));
    write("scenes/c.prm", "include ../two words.prm\nINCLUDE ../other.prm");
    write("two words.prm", "set Title = blanks\n");
    BOOST_TEST(same_text(read("scenes/c.prm").title, "blanks", "a name with a blank"));
    BOOST_TEST(near(read("scenes/c.prm").energy_limit, 0.02, 0, "the keyword in capital letters"));
  }

  // Each scene has its own output folder; files that it names lie here, or beside the scene that names them.
  void
  test_own_folder()
  {
    write("ready/base.prm",
          "subsection Profiles\n  set Rail   = worn.txt # beside\n  set Wheel = here.txt\nend\nsubsection "
          "Output\n  set Folder = output/base\n  set Ticks = 3\nend\n");
    write("ready/worn.txt", "");
    write("ready/here.txt", "");
    std::ofstream("here.txt") << "";
    write("mine.prm", "include ready/base.prm\n");
    write("named.prm", "include ready/base.prm\nsubsection Output\n  set Folder = runs/a\nend\n");
    write("folder.prm", "set Folder = runs/b\n");
    write("part.prm", "subsection Output\n  include folder.prm\nend\n");
    BOOST_TEST(same_text(read("ready/base.prm").folder, "output/base", "a folder of its own"));
    BOOST_TEST(same_text(read("mine.prm").folder, "output/mine", "an included scene keeps its folder"));
    BOOST_TEST(read("mine.prm").ticks == 3, "and nothing else");
    BOOST_TEST(same_text(read("named.prm").folder, "runs/a", "a folder that the scene names"));
    BOOST_TEST(same_text(read("part.prm").folder, "runs/b", "part of a subsection in a file of its own"));
    BOOST_TEST(same_text(
      read("mine.prm", {"Output/Folder = runs/c"}).folder, "runs/c", "a folder of the command line"));
    BOOST_TEST(same_text(read("base.prm").folder, "output/base", "none at all"));
    BOOST_TEST(
      same_text(read("mine.prm").rail_profile, "include/ready/worn.txt", "a file beside the included scene"));
    BOOST_TEST(
      same_text(read("mine.prm").wheel_profile, "here.txt", "one where the command is given goes before"));
    BOOST_TEST(same_text(read("mine.prm", {"Profiles/Rail = worn.txt"}).rail_profile,
                         "worn.txt",
                         "one of the command line lies here"));
    BOOST_TEST(
      (read_scene("include/mine.prm", {}).text.find("set Rail   = include/ready/worn.txt # beside") !=
       std::string::npos),
      "the text that is kept names it as it was found");
    fs::remove("here.txt");
    write("ready/lacks.prm",
          "subsection Profiles\n  set Rail = gone.txt\nend\nsubsection Wear\n  set Mix = gone.csv\nend\n");
    write("lacks.prm", "include ready/lacks.prm\n");
    for (const std::string command : {"run", "geometry", "wear"})
      {
        std::ostringstream out;
        BOOST_TEST(same_text(
          message_of([&]() {
            execute({command, "include/lacks.prm"}, {}, out);
          }),
          "include/ready/lacks.prm:2: Profiles/Rail: gone.txt: no such file; profiles are looked for where "
          "the command is given, then beside the scene",
          command + " names the line of the included file"));
      }
    std::ostringstream out;
    BOOST_TEST(
      same_text(message_of([&]() {
                  execute({"wear", "include/lacks.prm", "--set", "Profiles/Rail = 54E1"}, {}, out);
                }),
                "include/ready/lacks.prm:5: Wear/Mix: gone.csv: no such file; Wear/Mix needs a table with a "
                "row for each kind "
                "of traffic",
                "a table that is not there"));
  }

  // input.prm of the output folder: one file, each entry set once, remarks kept.
  void
  test_text()
  {
    write("kept.prm",
          "# mine\nset Title = a # remark\ninclude base.prm\n\nsubsection Run\n  set Energy limit \\\n= "
          "0.05\nend");
    const std::string flat = read_scene("include/kept.prm", {"Title = b"}).text;
    BOOST_TEST(same_text(
      flat,
      "# mine\nset Title = a # remark\n# include base.prm\n# set Title = base (replaced at "
      "include/kept.prm:2)\nsubsection Run\n  set Rolling distance = 30 mm\n# set Energy limit = 0.01 "
      "(replaced at include/kept.prm:6)\nend\n# end of include/base.prm\n\nsubsection Run\n  set Energy "
      "limit = 0.05\nend\n",
      "the text with the included files"));
    BOOST_TEST(same_text(print_parameters(scene_from_text(flat, "kept.prm", {}).scene),
                         print_parameters(read("kept.prm")),
                         "it reads back to the same scene"));
    RunOptions        options;
    const RunFunction run = [&](const Scene &, const SceneGeometry &, const RunOptions &o) {
      options = o;
      return 0;
    };
    std::ostringstream out;
    execute({"run", "include/kept.prm", "--set", "Title = b"}, run, out);
    BOOST_TEST(
      same_text(options.prm_text, flat + "# --set \"Title = b\"\n", "a run keeps it, with --set as remarks"));
  }

  void
  test_faults()
  {
    write("bad.prm", "set Titel = x\nsubsection Run\n  set Rolling distance = 30\nend\nend\n");
    write("user.prm",
          "set Title =\ninclude bad.prm\nset Colour = red\nsubsection Run\n  set Rolling distance = "
          "20 mm\n");
    check_message("user.prm",
                  "include/bad.prm:1: Titel: no such entry; the nearest is Title\n"
                  "include/bad.prm:3: Run/Rolling distance = 30: a bare number; a length with its unit is "
                  "needed, such as 1.5 mm\n"
                  "include/bad.prm:5: \"end\" without a subsection before it; remove it\n"
                  "include/user.prm:3: Colour: no such entry; outside the subsections has Title\n"
                  "include/user.prm:4: subsection Run is not closed: an \"end\" is missing");
    write("missing.prm", "\ninclude bose.prm\n");
    check_message("missing.prm",
                  "include/missing.prm:2: include bose.prm: include/bose.prm: no such file; the nearest is "
                  "include/base.prm");
    write("empty.prm", "include\ninclude scenes\n");
    check_message("empty.prm",
                  "include/empty.prm:1: include without a file; write \"include FILE.prm\"\n"
                  "include/empty.prm:2: include scenes: include/scenes: a folder; a parameter file (.prm) is "
                  "needed");
    write("twice.prm", "include base.prm\nset Title = a\nset Title = b\n");
    check_message(
      "twice.prm",
      "include/twice.prm:3: Title: set a second time, first at include/twice.prm:2; keep one of them");
    write("base_twice.prm", "set Title = a\nset Title = b\n");
    write("hides.prm", "include base_twice.prm\nset Title = c\n");
    check_message(
      "hides.prm",
      "include/base_twice.prm:2: Title: set a second time, first at include/base_twice.prm:1; keep "
      "one of them");
    write("section.prm", "subsection Run\n  include base.prm\nend\n");
    check_message(
      "section.prm",
      "include/base.prm:1: Run/Title: no such entry; the nearest is Title\n"
      "include/base.prm:2: subsection Run inside subsection Run (include/section.prm:1): an \"end\" "
      "is missing before it");
    // what an included file says is also compared with the rest, and named by its place
    write("long.prm", "include base.prm\nsubsection Run\n  set Averaging distance = 40 mm\nend\n");
    BOOST_TEST(same_text(
      message_of([]() { require_computable(read_scene("include/long.prm", {})); }),
      "include/long.prm:3: Run/Averaging distance = 40 mm: longer than Run/Rolling distance = 30 mm; "
      "the mean is taken over the last part of the run, so at most that is possible",
      "long.prm"));
    write("ticks.prm", "subsection Output\n  set Ticks = 3000\nend\n");
    write("many.prm", "include ticks.prm\n");
    BOOST_TEST((message_of([]() {
                  require_computable(read_scene("include/many.prm", {}));
                }).rfind("include/ticks.prm:2: Output/Ticks = 3000: one output every 0.02 mm", 0) == 0),
               "a fault between entries names the line of the included file");
  }

  void
  test_circles()
  {
    write("self.prm", "include self.prm\n");
    check_message(
      "self.prm",
      "include/self.prm:1: include self.prm: files include each other in a circle (include/self.prm, "
      "include/self.prm); remove one of the includes");
    write("sub/one.prm", "include ../two.circle\n");
    write("two.circle", "set Title = x\ninclude sub/../sub/one.prm\n");
    check_message(
      "sub/one.prm",
      "include/two.circle:2: include sub/../sub/one.prm: files include each other in a circle "
      "(include/sub/one.prm, include/two.circle, include/sub/one.prm); remove one of the includes");
    // not a circle, but two to the power of the number of files
    for (int n = 0; n < 9; ++n)
      {
        const std::string next = "include double_" + std::to_string(n + 1) + ".prm\n";
        write("double_" + std::to_string(n) + ".prm", n < 8 ? next + next : "set Title = x\n");
      }
    const std::string message = message_of([]() { read("double_0.prm"); });
    BOOST_TEST(same_text(
      message.substr(0, message.find('\n')),
      "include/double_6.prm:1: include double_7.prm: more than 100 files are included in all; put some of "
      "them together",
      "more than a hundred files"));
    BOOST_TEST(same_text(read("double_4.prm").title, "x", "thirty files"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(input_include)
{
  fs::remove_all("include");
  test_order();
  test_paths();
  test_own_folder();
  test_text();
  test_faults();
  test_circles();
  fs::remove_all("include");
}
