// label: fast

// What the program answers to faulty input: the text of every message, word by word.

#include "messages.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/left_out.h>
#include <wheelrail/input/input_file.h>
#include <wheelrail/run/simulation.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

using namespace wheelrail;
using test::check_file;
using test::check_set;
using test::message_of;
using test::same_text;

namespace
{
  BOOST_AUTO_TEST_CASE(test_values)
  {
    check_file(
      "subsection Wheelset\n  set Velocity = 140\nend",
      "x.prm:2: Wheelset/Velocity = 140: a bare number; a velocity with its unit is needed, such as 140 km/h",
      "a bare number");
    check_set(
      "Wheelset/Velocity = 140 kN",
      "--set: Wheelset/Velocity = 140 kN: the unit \"kN\" is one of force; a velocity takes one of m/s, "
      "km/h, mm/s");
    check_set(
      "Wheelset/Velocity = 900 km/h",
      "--set: Wheelset/Velocity = 900 km/h: too large; a velocity from 5 km/h to 500 km/h is accepted");
    check_set("Run/Rolling distance = 0 mm",
              "--set: Run/Rolling distance = 0 mm: too small; a length above 0 mm, at most 10 m is accepted");
    check_set("Run/Rolling distance =",
              "--set: Run/Rolling distance = : no value; a length with its unit is needed, such as 1.5 mm");
    check_set(
      "Wheelset/Drive = torqe",
      "--set: Wheelset/Drive = torqe: not known here; torque or rate is accepted, perhaps torque is meant");
    check_set(
      "Wheelset/Roll =",
      "--set: Wheelset/Roll = : no value; none, from contact, or an angle from -50 mrad to 50 mrad is "
      "accepted");
    check_set(
      "Wheelset/Roll = form contact",
      "--set: Wheelset/Roll = form contact: not known here, perhaps from contact is meant; none, from "
      "contact, or an angle from -50 mrad to 50 mrad is accepted");
    check_set("Profiles/Rail = UIC 60",
              "--set: Profiles/Rail = UIC 60: the former name of 60E1 (EN 13674-1); write 60E1");
    check_set(
      "Profiles/Rail = 49E1",
      "--set: Profiles/Rail = 49E1: not known here; 54E1, 60E1 or a profile file (with its ending, such as "
      "worn.prr) is accepted");
    check_set(
      "Mesh/Element = fully",
      "--set: Mesh/Element = fully: not known here; reduced or full is accepted, perhaps full is meant");
    check_set(
      "Rail material/Yield stress = 0.5 MPa",
      "--set: Rail material/Yield stress = 0.5 MPa: too small; a stress from 1 MPa to 10 GPa is accepted");
    check_set(
      "Wheel material/Yield stress = 480",
      "--set: Wheel material/Yield stress = 480: a bare number; a stress with its unit is needed, such as "
      "480 MPa");
    check_set(
      "Rail material/Kinematic rates = 1, 2, 3, 4, 5, 6, 7, 8, 9",
      "--set: Rail material/Kinematic rates = 1, 2, 3, 4, 5, 6, 7, 8, 9: 9 values; at most 8 are accepted");
    check_set("Material test/Axial = 0.01, 500 MPa",
              "--set: Material test/Axial = 0.01, 500 MPa: strains and stresses together; write all values "
              "as strains (0.01) "
              "or all as stresses (500 MPa)");
    check_set("Output/Ticks = 2.5",
              "--set: Output/Ticks = 2.5: not a whole number; a whole number from 1 to 10000 is needed");
    check_set("Output/Ticks = 0",
              "--set: Output/Ticks = 0: too small; a whole number from 1 to 10000 is accepted");
    check_set("Output/Volume fields = yes",
              "--set: Output/Volume fields = yes: not known here; true or false is accepted");
    check_set("Output/Folder =", "--set: Output/Folder = : no value; a text is needed");
    check_set("Title = a\nb", "--set: Title = a?b: a text is one line that does not end with a backslash");
    check_set("Output/Folder = runs\\",
              "--set: Output/Folder = runs\\: a text is one line that does not end with a backslash");
  }

  BOOST_AUTO_TEST_CASE(test_names)
  {
    check_file("subsection Wheelset\nset Velocty = 1 m/s\nend",
               "x.prm:2: Wheelset/Velocty: no such entry; the nearest is Wheelset/Velocity",
               "a misspelt entry");
    for (const auto &[written, told] :
         std::map<std::string, std::string>{{"Axle load = 22.5 t", "110.36 kN"},
                                            {"Static axle load = 200 kN", "100 kN"},
                                            {"axle weight = heavy", "... kN"}})
      check_file("subsection Wheelset\nset " + written + "\nend",
                 "x.prm:2: Wheelset/" + written.substr(0, written.find(" =")) +
                   ": no such entry; a wheel carries half of it: write \"set Wheel load = " + told +
                   "\" in subsection Wheelset",
                 written);
    check_file("set Velocity = 1 m/s",
               "x.prm:1: Velocity: no such entry; the nearest is Wheelset/Velocity",
               "an entry outside its subsection");
    check_file("subsection Contact\nset density = 1 kg/m3\nend",
               "x.prm:2: Contact/density: no such entry; the nearest are Rail material/Density, Wheel "
               "material/Density",
               "an entry of other sections");
    check_file(
      "subsection Half-space\nset Body = real\nend",
      "x.prm:2: Half-space/Body: no such entry; the nearest are Half-space/Bodies, Irregularity 1/Body, "
      "Irregularity 2/Body",
      "one of its own section first");
    check_file(
      "subsection Contact\nset Zigzag frequency = 1\nend",
      "x.prm:2: Contact/Zigzag frequency: no such entry; Contact has Friction coefficient, Friction "
      "coefficient left, Friction law, "
      "Dynamic friction coefficient, Friction decay, Friction half velocity, Penalty scale, Surface filter, "
      "Damping",
      "an entry like no other");
    check_file("subsection Contct\nset Damping = 1\nend",
               "x.prm:1: subsection Contct: no such subsection; the nearest is Contact",
               "a misspelt subsection");
    check_set(
      "Irregularity 10/Kind = dent",
      "--set: Irregularity 10/Kind: no such subsection; there are Irregularity 1 to 9, and a file may "
      "hold more (Kind = file)");
    check_set(
      "Sleepers/Spacing = 600 mm",
      "--set: Sleepers/Spacing: no such subsection; there are Profiles, Track, Wheelset, Contact, Rail "
      "material, Wheel material, Mesh, Run, Output, Half-space, Irregularity 1, Irregularity 2, Irregularity "
      "3, "
      "Irregularity 4, Irregularity 5, Irregularity 6, Irregularity 7, Irregularity 8, Irregularity 9, Wear, "
      "Material test, Study");
  }

  BOOST_AUTO_TEST_CASE(test_syntax)
  {
    check_file("subsection Run\nset Rolling distance = 30 mm\nset Rolling distance = 40 mm\nend",
               "x.prm:3: Run/Rolling distance: set a second time, first at x.prm:2; keep one of them",
               "an entry set twice");
    BOOST_TEST(same_text(message_of([]() {
                           scene_from_text("", "x.prm", {"Title = a", "Title = b"});
                         }),
                         "--set: Title: set a second time; keep one of them",
                         "--set twice"));
    check_file("subsection Run\nset Rolling distance = 30 mm",
               "x.prm:1: subsection Run is not closed: an \"end\" is missing",
               "a missing end at the end");
    check_file("subsection Run\nsubsection Output\nend",
               "x.prm:2: subsection Output inside subsection Run (x.prm:1): an \"end\" is missing before it",
               "a missing end before a subsection");
    check_file("subsection\nend", "x.prm:1: subsection without a name", "a subsection without a name");
    check_file("end", "x.prm:1: \"end\" without a subsection before it; remove it", "an end too many");
    check_file(
      "velocity 3",
      "x.prm:1: \"velocity 3\": a line starts with set, subsection, end, include or #; an entry is written "
      "\"set Name = value\"",
      "a line of another kind");
    check_file(
      "set Title", "x.prm:1: \"set Title\": an entry is written \"set Name = value\"", "a set without =");
    check_file("set Title = x\\",
               "x.prm:1: the last line ends with a backslash, and no line follows; remove it",
               "nothing after a backslash");
    check_file("\nset Title = \\\n  a\nsubsection Run\n  set Rolling \\\n  distance = 30\nend",
               "x.prm:5: Run/Rolling distance = 30: a bare number; a length with its unit is needed, such as "
               "1.5 mm",
               "a fault in a line that goes on in the next one");
    check_set("Title",
              "--set \"Title\": the form is --set \"Section/Entry = value\", such as --set "
              "\"Wheelset/Velocity = 140 km/h\"");
    for (const char *set : {"Title = a#b", "Run/Rolling distance = 30 mm # short"})
      check_set(set,
                std::string("--set \"") + set +
                  "\": # begins a remark in parameter files, so that no value can hold it; write the value "
                  "without it");
    check_set("Title = a\nb", "--set: Title = a?b: a text is one line that does not end with a backslash");
    check_set(
      "Run/Time step factor = 1e-300",
      "--set: Run/Time step factor = 1e-300: too small; a pure number from 0.001 to 0.98 is accepted");
    check_file(
      "subsection Run\nset Rolling distance = 30\nend\nend\nset Titel = x",
      "x.prm:2: Run/Rolling distance = 30: a bare number; a length with its unit is needed, such as 1.5 mm\n"
      "x.prm:4: \"end\" without a subsection before it; remove it\n"
      "x.prm:5: Titel: no such entry; the nearest is Title",
      "all faults at once, in the order of the file");
  }

  /// Many faults, long and unprintable texts: a message stays readable.
  BOOST_AUTO_TEST_CASE(test_long_texts)
  {
    std::string text, expected;
    for (int line = 1; line <= 40; ++line)
      {
        text += "end\n";
        if (line <= 25)
          expected +=
            "x.prm:" + std::to_string(line) + ": \"end\" without a subsection before it; remove it\n";
      }
    check_file(text, expected + "x.prm: 15 more faults; correct these first", "forty faults");
    check_set("Wheelset/Velocity = " + std::string(300, '7') + " km/h",
              "--set: Wheelset/Velocity = " + std::string(100, '7') +
                "...: too long for a number; a velocity with its unit is needed, such as 140 km/h");
    check_set("Title = " + std::string(100000, 'x'),
              "--set: Title = " + std::string(100, 'x') +
                "...: too long, 100000 characters; at most 200 are accepted");
    std::string accepted = "Title = ";
    for (int letter = 0; letter < 200; ++letter)
      accepted += "\xC3\xBC";
    check_set(accepted, "no message");
    check_set("Wheelset/Drive = a\nb",
              "--set: Wheelset/Drive = a?b: not known here; torque or rate is accepted");
    BOOST_TEST(
      same_text(shown_text("gr\xC3\xBC\xC3\x9F", 3), "gr...", "a letter of two bytes is not cut in two"));
    BOOST_TEST(
      same_text(shown_text("gr\xC3\xBC\xC3\x9F", 4), "gr\xC3\xBC...", "a letter of two bytes is kept whole"));
  }

  BOOST_AUTO_TEST_CASE(test_files)
  {
    namespace fs = std::filesystem;
    fs::create_directories("messages");
    std::ofstream("messages/rolling.prm") << "set Title = x\n";
    std::ofstream("messages/empty.txt") << "\r\n  \n";
    std::ofstream("messages/binary.txt") << std::string(
      "\x7f"
      "ELF\0\x01",
      6);
    const auto check_path =
      [](const std::string &path, const std::string &expected, const std::string &what) {
        BOOST_TEST(same_text(message_of([&]() { read_input_file(path); }), expected, what));
      };
    check_path("messages/roling.prm",
               "messages/roling.prm: no such file; the nearest is messages/rolling.prm",
               "a misspelt file");
    check_path("nowhere/x.prm", "nowhere/x.prm: no such file", "a file in no folder");
    check_path("messages", "messages: a folder; a parameter file (.prm) is needed", "a folder");
    std::ofstream("messages/large.txt") << std::string((1 << 20) + 1, 'x');
    check_path("messages/large.txt",
               "messages/large.txt: larger than 1 MiB; this is no parameter file",
               "a large file");
    check_path("messages/empty.txt",
               "messages/empty.txt: empty; \"./wheelrail parameters\" prints a complete parameter file",
               "an empty file");
    check_path("messages/binary.txt",
               "messages/binary.txt: not a text file; a parameter file (.prm) is needed",
               "a binary file");
    fs::create_symlink("b.prm", "messages/a.prm");
    fs::create_symlink("a.prm", "messages/b.prm");
    check_path("messages/a.prm",
               "messages/a.prm: a symbolic link that leads back to itself; correct it with ln -sf",
               "links in a circle");
    fs::create_symlink("gone.prm", "messages/link.prm");
    check_path("messages/link.prm",
               "messages/link.prm: a symbolic link to gone.prm, which is not there; correct it with ln -sf",
               "a link to nothing");
    fs::remove_all("messages");
    test::check_unreadable([](const std::string &path) { read_input_file(path); });
  }

  BOOST_AUTO_TEST_CASE(test_command_line)
  {
    const auto check_line = [](const Arguments &arguments, const std::string &expected) {
      std::string line;
      for (const std::string &argument : arguments)
        line += " " + argument;
      const RunFunction run = [](const Scene &, const SceneGeometry &, const RunOptions &) { return 0; };
      BOOST_TEST(
        same_text(message_of([&]() { execute(arguments, run, std::cout); }), expected, "wheelrail" + line));
    };
    check_line({"simulate"},
               "\"simulate\" is no command; there are run, geometry, halfspace, receptance, material, "
               "contact, vehicle, wear, "
               "parameters, compare, report, study, version, test, build and help");
    check_line({"compare", "nowhere"}, "nowhere: no such folder; compare needs the output folder of a run");
    check_line({"build"}, "build is a command of the launcher wheelrail beside the sources");
    check_line({"run", "a.prm", "--ranks", "2"},
               "--ranks 2: an option of the launcher, which starts the processes; the program itself is "
               "started by mpirun -n with their number");
    check_line({"run"}, "run needs a parameter file, such as ./wheelrail run prm/rolling.prm");
    check_line({"study"}, "study needs a parameter file, such as ./wheelrail study prm/studies/friction.prm");
    check_line({"contact"}, "contact needs an input file of the program CONTACT, NAME.inp");
    check_line({"material"},
               "material needs a parameter file, such as ./wheelrail material prm/rolling_plastic.prm --set "
               "\"Material test/Axial = 0.01, -0.01\"");
    check_line(
      {"geometri"},
      "\"geometri\" is no command; there are run, geometry, halfspace, receptance, material, contact, "
      "vehicle, wear, "
      "parameters, compare, report, study, version, test, build and help, perhaps geometry is meant");
    check_line(
      {"run", "a.prm", "--overwrit"},
      "run: --overwrit is no option; there are --set, --row, --traction, --ranks, --overwrite, --resume, "
      "--validate, --wheelset and --help, "
      "perhaps --overwrite is meant; \"./wheelrail run --help\" tells more");
    check_line({"run", "a.prm", "b.prm"},
               "run: only one FILE.prm can be given; \"./wheelrail run --help\" tells more");
    check_line({"version", "x"},
               "version: nothing but options can follow; \"./wheelrail version --help\" tells more");
    check_line({"run", "a.prm", "--set"},
               "run: --set needs a value after it; \"./wheelrail run --help\" tells more");
    check_line({"run", "a.prm", "--overwrite=yes"},
               "run: --overwrite takes no value; \"./wheelrail run --help\" tells more");
    check_line({"geometry", "--shifts", "1", "--shifts", "2"},
               "geometry: --shifts is given more than once; \"./wheelrail geometry --help\" tells more");
    check_line({"parameters", "--markdown", "a.prm"},
               "parameters --markdown prints the defaults of all entries: leave file and --set out");
    check_line({"parameters", "--json", "--xml"},
               "parameters prints in one style: give one of --json, --xml and --markdown");
    check_line({"parameters", "--validate"},
               "parameters --validate needs a parameter file, such as ./wheelrail parameters --validate "
               "prm/rolling.prm");
    check_line({"report"}, "report needs the output folder of a run, such as output/rolling");
    check_line({"run", "a.prm", "--overwrite", "--resume"},
               "--overwrite starts anew and --resume continues: give one of them");
    check_line({"report", "nowhere"}, "nowhere: no such folder; report needs the output folder of a run");
    check_line(
      {"geometry", "--shifts", "1:2"},
      "--shifts 1:2: not understood; write first:last:step or values with commas, in mm, such as -6:6:0.5");
    check_line({"geometry", "--shifts", "2:1:0.5"},
               "--shifts 2:1:0.5: the step must be positive and the last value not below the first; write "
               "first:last:step or values with commas, in mm, such as -6:6:0.5");
    check_line(
      {"geometry", "--shifts", "0:1e9:1"},
      "--shifts 0:1e9:1: more than 100000 values; write first:last:step or values with commas, in mm, "
      "such as -6:6:0.5");
    check_line(
      {"geometry", "--shifts", "1,two"},
      "--shifts 1,two: \"two\" is not a number; write first:last:step or values with commas, in mm, such as "
      "-6:6:0.5");
  }

  // --validate knows from the launcher on how many processes the run would start.
  BOOST_AUTO_TEST_CASE(test_ranks)
  {
    std::ofstream("ranks.prm") << "set Title = x\n";
    const long        cores = sysconf(_SC_NPROCESSORS_ONLN);
    const std::string ranks = std::to_string(cores + 1);
    setenv("WHEELRAIL_RANKS", ranks.c_str(), 1);
    std::ostringstream out;
    execute({"run", "ranks.prm", "--validate"}, {}, out);
    unsetenv("WHEELRAIL_RANKS");
    const std::string warning =
      "warning: --ranks " + ranks + ": more than the " + std::to_string(cores) +
      " cores of this machine; ranks that wait for each other take turns, which is slower than fewer ranks\n";
    BOOST_TEST((out.str().find(warning) != std::string::npos), warning);
    unlink("ranks.prm");
  }

  BOOST_AUTO_TEST_CASE(test_left_out)
  {
    BOOST_TEST(same_text(message_of([]() { refuse_left_out("receptance", Subject::track); }),
                         "receptance: this program is built without track; "
                         "WHEELRAIL_CMAKE_OPTIONS=-DWHEELRAIL_TRACK=ON ./wheelrail build makes one with it",
                         "a subject that is left out"));
    if (!is_built(Subject::track))
      check_set("Track/Support = sleepers", left_out("--set: Track/Support = sleepers", Subject::track));
    if (!is_built(Subject::vehicle))
      check_set(
        "Wheelset/Wheels = both",
        left_out("--set: Wheelset/Wheels = both", Subject::vehicle) +
          "\n--set: Wheelset/Wheels = both: a run has one wheel; run --wheelset rolls the modelled one "
          "as it rolls on the wheelset, Wheels = one by itself");
  }
} // namespace
