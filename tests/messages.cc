// What the program answers to faulty input: the text of every message, word by word.

#include "check.h"

#include <wheelrail/application/commands.h>
#include <wheelrail/application/cross_checks.h>
#include <wheelrail/application/input_file.h>
#include <wheelrail/application/parameters.h>
#include <wheelrail/application/simulation.h>
#include <wheelrail/base/errors.h>

#include <filesystem>
#include <fstream>
#include <functional>

using namespace wheelrail;
using test::check;
using test::check_text;

namespace
{
  std::string
  message_of(const std::function<void()> &work)
  {
    try
      {
        work();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "no message";
  }

  void
  check_file(const std::string &text, const std::string &expected, const std::string &what)
  {
    check_text(message_of([&]() { scene_from_text(text, "x.prm", {}); }), expected, what);
  }

  void
  check_set(const std::string &set, const std::string &expected)
  {
    check_text(message_of([&]() { scene_from_text("", "x.prm", {set}); }), expected, "--set " + set);
  }

  void
  test_values()
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
    check_set("Wheelset/Roll =", "--set: Wheelset/Roll = : no value; none or from contact is accepted");
    check_set("Profiles/Rail = UIC 60",
              "--set: Profiles/Rail = UIC 60: not known here; 54E1 or 60E1 is accepted");
    check_set("Mesh/Element = full", "--set: Mesh/Element = full: not known here; reduced is accepted");
    check_set(
      "Rail material/Yield stress = 480 MPa",
      "--set: Rail material/Yield stress = 480 MPa: this version computes elastic bodies only; write none");
    check_set(
      "Wheel material/Yield stress = 480",
      "--set: Wheel material/Yield stress = 480: a bare number; a stress with its unit is needed, such as "
      "480 MPa");
    check_set("Output/Ticks = 2.5",
              "--set: Output/Ticks = 2.5: not a whole number; a whole number from 1 to 10000 is needed");
    check_set("Output/Ticks = 0",
              "--set: Output/Ticks = 0: too small; a whole number from 1 to 10000 is accepted");
    check_set("Output/Volume fields = yes",
              "--set: Output/Volume fields = yes: not known here; true or false is accepted");
    check_set("Output/Folder =", "--set: Output/Folder = : no value; a text is needed");
  }

  void
  test_names()
  {
    check_file("subsection Wheelset\nset Velocty = 1 m/s\nend",
               "x.prm:2: Wheelset/Velocty: no such entry; the nearest is Wheelset/Velocity",
               "a misspelt entry");
    check_file("set Velocity = 1 m/s",
               "x.prm:1: Velocity: no such entry; the nearest is Wheelset/Velocity",
               "an entry outside its subsection");
    check_file("subsection Contact\nset density = 1 kg/m3\nend",
               "x.prm:2: Contact/density: no such entry; the nearest are Rail material/Density, Wheel "
               "material/Density",
               "an entry of other sections");
    check_file(
      "subsection Contact\nset Zigzag frequency = 1\nend",
      "x.prm:2: Contact/Zigzag frequency: no such entry; Contact has Friction coefficient, Friction law, "
      "Dynamic friction coefficient, Friction decay, Friction half velocity, Penalty scale, Damping",
      "an entry like no other");
    check_file("subsection Contct\nset Damping = 1\nend",
               "x.prm:1: subsection Contct: no such subsection; the nearest is Contact",
               "a misspelt subsection");
    check_set(
      "Sleepers/Spacing = 600 mm",
      "--set: Sleepers/Spacing: no such subsection; there are Profiles, Track, Wheelset, Contact, Rail "
      "material, Wheel material, Mesh, Run, Output");
  }

  void
  test_syntax()
  {
    check_file("subsection Run\nset Rolling distance = 30 mm\nset Rolling distance = 40 mm\nend",
               "x.prm:3: Run/Rolling distance: set a second time, first at x.prm:2; keep one of them",
               "an entry set twice");
    check_text(message_of([]() {
                 scene_from_text("", "x.prm", {"Title = a", "Title = b"});
               }),
               "--set: Title: set a second time; keep one of them",
               "--set twice");
    check_file("subsection Run\nset Rolling distance = 30 mm",
               "x.prm:1: subsection Run is not closed: an \"end\" is missing",
               "a missing end at the end");
    check_file("subsection Run\nsubsection Output\nend",
               "x.prm:2: subsection Output inside subsection Run (x.prm:1): an \"end\" is missing before it",
               "a missing end before a subsection");
    check_file("end", "x.prm:1: \"end\" without a subsection before it; remove it", "an end too many");
    check_file(
      "velocity 3",
      "x.prm:1: \"velocity 3\": a line starts with set, subsection, end or #; an entry is written \"set Name "
      "= value\"",
      "a line of another kind");
    check_file(
      "set Title", "x.prm:1: \"set Title\": an entry is written \"set Name = value\"", "a set without =");
    check_set("Title",
              "--set \"Title\": the form is --set \"Section/Entry = value\", such as --set "
              "\"Wheelset/Velocity = 140 km/h\"");
    check_file(
      "subsection Run\nset Rolling distance = 30\nend\nend\nset Titel = x",
      "x.prm:2: Run/Rolling distance = 30: a bare number; a length with its unit is needed, such as 1.5 mm\n"
      "x.prm:4: \"end\" without a subsection before it; remove it\n"
      "x.prm:5: Titel: no such entry; the nearest is Title",
      "all faults at once, in the order of the file");
  }

  void
  test_files()
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
        check_text(message_of([&]() { read_input_file(path); }), expected, what);
      };
    check_path("messages/roling.prm",
               "messages/roling.prm: no such file; the nearest is messages/rolling.prm",
               "a misspelt file");
    check_path("nowhere/x.prm", "nowhere/x.prm: no such file", "a file in no folder");
    check_path("messages", "messages: a folder; a parameter file (.prm) is needed", "a folder");
    check_path("messages/empty.txt",
               "messages/empty.txt: empty; \"./wheelrail parameters\" prints a complete parameter file",
               "an empty file");
    check_path("messages/binary.txt",
               "messages/binary.txt: not a text file; a parameter file (.prm) is needed",
               "a binary file");
    fs::remove_all("messages");
  }

  void
  test_cross_checks()
  {
    check_set(
      "Run/Averaging distance = 200 mm",
      "--set: Run/Averaging distance = 200 mm: longer than Run/Rolling distance = 100 mm; the mean is taken "
      "over the last part of the run, so at most that is possible");
    check_set(
      "Run/Rolling distance = 1.7 m",
      "--set: Run/Rolling distance = 1700 mm: with 100 mm of free rail at each end this needs a rail of 1900 "
      "mm, and Track/Rail length is 1800 mm; roll at most 1600 mm or lengthen the rail");
    check_set(
      "Mesh/Coarse cell size = 12 mm",
      "--set: Mesh/Coarse cell size = 12 mm: 12 times the solution cell size of 1 mm; cells are halved from "
      "coarse to fine, so the ratio must be about 1, 2, 4, 8, 16, ...: take 16 mm");
    check_set("Mesh/Fine depth = 1.5 mm",
              "--set: Mesh/Fine depth = 1.5 mm: less than two cells of 1 mm; write auto or at least 2 mm");
    check_set("Mesh/Fine margin = 0.5 mm",
              "--set: Mesh/Fine margin = 0.5 mm: less than one cell of 1 mm; at least that is needed around "
              "the patch");
    check_set(
      "Wheelset/Bore radius = 125 mm",
      "--set: Wheelset/Bore radius = 125 mm: must be at least 10 mm smaller than Wheelset/Hub outer radius = "
      "130 mm; the order from the axle outwards is bore, hub, rim, running circle");
    check_set("Wheelset/Nominal rolling radius = 400 mm",
              "x.prm: Wheelset/Rim inner radius = 395 mm: must be at least 20 mm smaller than "
              "Wheelset/Nominal rolling "
              "radius = 400 mm; the order from the axle outwards is bore, hub, rim, running circle");
    check_set("Wheelset/Disc position = 5 mm",
              "--set: Wheelset/Disc position = 5 mm: the disc (28 mm thick) reaches beyond the rim, which "
              "lies from 0 "
              "mm to 135 mm off the flange back");
    check_set("Wheelset/Flange back distance = 1440 mm",
              "--set: Wheelset/Flange back distance = 1440 mm: not smaller than Track/Gauge = 1435 mm; the "
              "flanges run "
              "between the rails, with 1435 mm the distance is about 1360 mm");
    check_set(
      "Rail material/Tangent modulus = 210 GPa",
      "--set: Rail material/Tangent modulus = 210 GPa: not smaller than Rail material/Young's modulus = 210 "
      "GPa; beyond yield the stress rises less than before");
    check_set(
      "Output/Ticks = 500",
      "--set: Output/Ticks = 500: one output every 0.2 mm of rolling, which is less than half a cell (1 mm), "
      "shows nothing new; at most 200 are accepted");
    check_set(
      "Run/Averaging distance = 200 mm",
      "--set: Run/Averaging distance = 200 mm: longer than Run/Rolling distance = 100 mm; the mean is taken "
      "over the last part of the run, so at most that is possible");
  }

  /// The scene of the defaults with changes; the cross-checks are left to the caller.
  Scene
  scene_with(const std::vector<std::string> &sets)
  {
    return scene_from_text("", "x.prm", sets, Checks::entries);
  }

  void
  check_warning(const std::vector<std::string> &sets,
                const std::string              &expected,
                const Machine                  &machine = {})
  {
    const Findings found = cross_checks(scene_with(sets), machine);
    std::string    all;
    for (const std::string &warning : found.warnings)
      all += (all.empty() ? "" : "\n") + warning;
    check_text(all, expected, "warning: " + expected.substr(0, expected.find(": ")));
    check(found.errors.empty(), "  and no error");
  }

  void
  check_error(const std::vector<std::string> &sets, const std::string &expected, const Machine &machine = {})
  {
    const Findings found = cross_checks(scene_with(sets), machine);
    check_text(found.errors.empty() ? "no error" : found.errors.front(),
               expected,
               "error: " + expected.substr(0, expected.find(": ")));
  }

  void
  test_warnings()
  {
    const Findings none = cross_checks(Scene(), {2, 2, 16e9, 12e9});
    check(none.errors.empty() && none.warnings.empty(), "the defaults raise no question");
    check_warning({"Contact/Friction coefficient = 0.2"},
                  "Wheelset/Traction coefficient = 0.25: friction carries at most Contact/Friction "
                  "coefficient = 0.2, so the whole patch slides and the wheel spins up while it rolls");
    check_warning({"Wheelset/Traction coefficient = -0.5"},
                  "Wheelset/Traction coefficient = -0.5: friction carries at most Contact/Friction "
                  "coefficient = 0.5, so the whole patch slides and the wheel locks while it rolls");
    check_warning({"Wheelset/Creepage = 0.001"},
                  "Wheelset/Creepage = 0.001: without effect, since Wheelset/Drive = torque");
    check_warning({"Wheelset/Sprung mass = 0.01 t", "Mesh/Solution cell size = 0.5 mm"},
                  "Wheelset/Sprung mass = 0.01 t: next to nothing presses the wheel on the rail; a railway "
                  "vehicle has some 10 t per wheel");
    check_warning({"Rail material/Young's modulus = 21 GPa", "Rail material/Tangent modulus = 2 GPa"},
                  "Rail material/Young's modulus = 21 GPa: steel has about 210 GPa");
    check_warning({"Wheel material/Density = 790 kg/m3"},
                  "Wheel material/Density = 790 kg/m3: steel has about 7900 kg/m3");
    check_warning({"Rail material/Poisson's ratio = 0.48"},
                  "Rail material/Poisson's ratio = 0.48: nearly incompressible; steel has about 0.3, and the "
                  "stable time step falls to zero towards 0.5");
    check_warning({"Mesh/Solution cell size = 4 mm", "Mesh/Fine margin = 4 mm"},
                  "Mesh/Solution cell size = 4 mm: coarse; a patch of about 20 mm x 14 mm (width x length) "
                  "is expected, which is less than six cells in one direction, so the peak pressure will be "
                  "some 10 % or more off; take 1.4 mm for figures");
    check_warning({"Run/Time step factor = 0.001"},
                  "Run/Rolling distance = 100 mm: takes about 17 million time steps at Wheelset/Velocity = "
                  "140 km/h, Mesh/Solution cell size = 1 mm and Run/Time step factor = 0.001, days of "
                  "computing; a higher speed or a shorter distance takes less");
    check_warning({},
                  "--ranks 8: more than the 2 cores of this machine; ranks that wait for each other take "
                  "turns, which is slower than fewer ranks",
                  {8, 2, 0, 0});
    check_warning({},
                  "Mesh/Solution cell size = 1 mm: with Mesh/Coarse cell size = 16 mm this makes about 97000 "
                  "cells and may need some 2.5 GB of memory, 1 GB are free; take larger cells, a shorter "
                  "rolling distance or a smaller fine depth or margin",
                  {2, 2, 16e9, 1e9});
    check_error({},
                "Mesh/Solution cell size = 1 mm: with Mesh/Coarse cell size = 16 mm this makes about 97000 "
                "cells and needs some 2.5 GB of memory, this machine has 1 GB; take larger cells, a shorter "
                "rolling distance or a smaller fine depth or margin",
                {2, 2, 1e9, 1e9});
    check_error(
      {"Mesh/Solution cell size = 5 mm", "Mesh/Coarse cell size = 20 mm", "Mesh/Fine margin = 5 mm"},
      "Mesh/Solution cell size = 5 mm: too coarse; a patch of about 20 mm x 14 mm (width x length) is "
      "expected and needs three cells in length, so at most 4.7 mm is accepted, and a tenth of the patch for "
      "figures that can be trusted");
    check_error(
      {"Mesh/Solution cell size = 0.1 mm", "Mesh/Coarse cell size = 1.6 mm", "Run/Rolling distance = 1 m"},
      "Mesh/Solution cell size = 0.1 mm: with Mesh/Coarse cell size = 1.6 mm this makes about 61 million "
      "cells, and 50 million are possible; take larger cells, a shorter rolling distance or a smaller fine "
      "depth or margin");
    check_error({"Wheelset/Lateral shift = 11 mm", "Wheelset/Flange back distance = 1370 mm"},
                "Wheelset/Lateral shift = 11 mm: Wheel 'S1002' and rail '54E1' have no contact point at a "
                "lateral shift of 11 mm: at the other wheel of the wheelset (shift of opposite sign) the "
                "flange stands on the rail. With this track, shifts from -10.4 to 10.4 mm are possible; set "
                "Wheelset/Lateral shift within them.");
    check_error({"Run/Rolling distance = 1.7 m"},
                "Run/Rolling distance = 1700 mm: with 100 mm of free rail at each end this needs a rail of "
                "1900 mm, and Track/Rail length is 1800 mm; roll at most 1600 mm or lengthen the rail");
    check_error({"Mesh/Coarse cell size = 64 mm", "Run/Rolling distance = 1.5 m"},
                "Run/Rolling distance = 1500 mm: with 206 mm of free rail at each end this needs a rail of "
                "1912 mm, and Track/Rail length is 1800 mm; roll at most 1388 mm or lengthen the rail");
    check_error({"Track/Rail length = 200 mm"},
                "Run/Rolling distance = 100 mm: with 100 mm of free rail at each end this needs a rail of "
                "300 mm, and Track/Rail length is 200 mm; lengthen the rail");
  }

  void
  test_command_line()
  {
    const auto check_line = [](const Arguments &arguments, const std::string &expected) {
      std::string line;
      for (const std::string &argument : arguments)
        line += " " + argument;
      const RunFunction run = [](const Scene &, const RunOptions &) { return 0; };
      check_text(message_of([&]() { execute(arguments, run, std::cout); }), expected, "wheelrail" + line);
    };
    check_line({"halfspace"},
               "\"halfspace\" is no command; there are run, geometry, parameters, report, version and help");
    check_line({"run"}, "run needs a parameter file, such as ./wheelrail run prm/rolling.prm");
    check_line({"geometri"},
               "\"geometri\" is no command; there are run, geometry, parameters, report, version and help, "
               "perhaps geometry is meant");
    check_line({"run", "a.prm", "--overwrit"},
               "run: --overwrit is no option; there are --set, --overwrite, --resume, --validate and --help, "
               "perhaps --overwrite is meant; \"wheelrail run --help\" tells more");
    check_line({"run", "a.prm", "b.prm"},
               "run: only one FILE.prm can be given; \"wheelrail run --help\" tells more");
    check_line({"version", "x"},
               "version: nothing but options can follow; \"wheelrail version --help\" tells more");
    check_line({"run", "a.prm", "--set"},
               "run: --set needs a value after it; \"wheelrail run --help\" tells more");
    check_line({"run", "a.prm", "--overwrite=yes"},
               "run: --overwrite takes no value; \"wheelrail run --help\" tells more");
    check_line({"geometry", "--shifts", "1", "--shifts", "2"},
               "geometry: --shifts is given more than once; \"wheelrail geometry --help\" tells more");
    check_line({"parameters", "--markdown", "a.prm"},
               "parameters --markdown prints the defaults of all entries: leave file and --set out");
    check_line({"parameters", "--validate"},
               "parameters --validate needs a parameter file, such as ./wheelrail parameters --validate "
               "prm/rolling.prm");
    check_line({"report"}, "report needs the output folder of a run, such as output/rolling");
    check_line({"run", "a.prm", "--overwrite", "--resume"},
               "--overwrite starts anew and --resume goes on: give one of them");
    check_line({"report", "nowhere"}, "nowhere: no such folder; report needs the output folder of a run");
    check_line(
      {"geometry", "--shifts", "1:2"},
      "--shifts 1:2: not understood; write first:last:step or values with commas, in mm, such as -6:6:0.5");
    check_line(
      {"geometry", "--shifts", "1,two"},
      "--shifts 1,two: \"two\" is not a number; write first:last:step or values with commas, in mm, such as "
      "-6:6:0.5");
  }
} // namespace

int
main()
{
  test_values();
  test_names();
  test_syntax();
  test_files();
  test_cross_checks();
  test_warnings();
  test_command_line();
  return test::report();
}
