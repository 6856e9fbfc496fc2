// label: fast

// What the program answers to values that contradict each other: errors and warnings, word by word.

#include "messages.h"

#include <wheelrail/model/scene_checks.h>

#include <string>
#include <vector>

using namespace wheelrail;
using test::check_set;
using test::message_of;
using test::same_text;

namespace
{
  BOOST_AUTO_TEST_CASE(test_cross_checks)
  {
    check_set(
      "Run/Averaging distance = 200 mm",
      "--set: Run/Averaging distance = 200 mm: longer than Run/Rolling distance = 60 mm; the mean is taken "
      "over the last part of the run, so at most that is possible");
    check_set(
      "Run/Evaluate at = 55 mm",
      "--set: Run/Evaluate at = 55 mm: half of Run/Averaging distance = 20 mm on either side of it must "
      "lie on the path, from 0 mm to Run/Rolling distance = 60 mm");
    BOOST_TEST(
      same_text(message_of([&]() {
                  require_computable(scene_from_text(
                    "", "x.prm", {"Run/Rolling distance = until steady", "Run/Evaluate at = 30 mm"}));
                }),
                "--set: Run/Evaluate at = 30 mm: a run with Run/Rolling distance = until steady finds the "
                "stretch of its "
                "means by itself; write Evaluate at = end, or a Rolling distance in mm",
                "a place of the means with a run until steady"));
    check_set("Run/Evaluate at = largest force",
              "--set: Run/Evaluate at = largest force: on smooth surfaces the largest force is chance; write "
              "Evaluate at = end, or add an Irregularity");
    const auto prepared = [](const std::string &window) {
      return message_of([&]() {
        require_computable(
          scene_from_text("", "x.prm", {"Mesh/Window = " + window, "Mesh/Prepared distance = 50 mm"}));
      });
    };
    BOOST_TEST(same_text(
      prepared("fixed"),
      "--set: Mesh/Prepared distance = 50 mm: shorter than Run/Rolling distance = 60 mm; write auto, "
      "or a longer distance for a run that is to be resumed with more",
      "a prepared distance that is too short"));
    BOOST_TEST(same_text(
      prepared("moving"),
      "--set: Mesh/Prepared distance = 50 mm: not needed with Mesh/Window = moving, where a resumed "
      "run may roll on as far as the rail goes; leave it out, or set Mesh/Window = fixed",
      "a prepared distance with a moving window"));
    check_set(
      "Run/Rolling distance = 1.7 m",
      "--set: Run/Rolling distance = 1700 mm: with 100 mm of free rail at each end this needs a rail of 1900 "
      "mm, and Track/Rail length is 1800 mm; roll at most 1600 mm or lengthen the rail");
    check_set(
      "Mesh/Coarse cell size = 12 mm",
      "--set: Mesh/Coarse cell size = 12 mm: 12 times the solution cell size of 1 mm; cells are halved from "
      "coarse to fine, so the ratio must be about 1, 2, 4, 8, 16, ...: take 16 mm");
    check_set(
      "Run/Passages = 3",
      "--set: Run/Passages = 3: the rail does not yield, so that every passage is the first one; give Rail "
      "material/Yield stress");
    check_set("Run/Rail = output/first",
              "--set: Run/Rail = output/first: a rail that does not yield keeps nothing of earlier runs; "
              "write new, or "
              "give Rail material/Yield stress");
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
    check_set("Output/Ticks = 2000",
              "--set: Output/Ticks = 2000: one output every 0.03 mm of rolling, which is less than a tenth "
              "of a cell (1 mm), "
              "shows nothing new; at most 600 are accepted");
  }

  /// The scene of the defaults with changes; the checks are left to the caller.
  Scene
  scene_with(const std::vector<std::string> &sets)
  {
    return scene_from_text("", "x.prm", sets).scene;
  }

  /// What is accepted though it looks odd.
  BOOST_AUTO_TEST_CASE(test_accepted)
  {
    const auto check_accepted = [](const std::vector<std::string> &sets, const std::string &what) {
      const Findings found = check_scene(scene_with(sets)).found;
      BOOST_TEST(same_text(found.errors.empty() ? "" : found.errors.front(), "", what));
    };
    check_accepted({"Run/Rolling distance = 0.05 mm", "Run/Averaging distance = 0.05 mm", "Output/Ticks = 1"},
                   "one output cannot be too many");
    check_accepted({"Rail material/Young's modulus = 10 GPa"},
                   "a tangent modulus above Young's modulus does not matter without a yield stress");
    check_accepted({"Mesh/Solution cell size = 0.5 mm", "Mesh/Coarse cell size = 8 mm"},
                   "coarse cells of 8 mm with 0.5 mm");
  }

  /// Wheels at several places of one rail.
  BOOST_AUTO_TEST_CASE(test_passages)
  {
    check_set(
      "Mesh/Planned strip = 3 mm",
      "--set: Mesh/Planned strip = 3 mm: two places are needed, the one nearer to the track centre first, "
      "such as -15 mm, 12 mm");
    check_set("Mesh/Planned strip = -60 mm, 60 mm",
              "--set: Mesh/Planned strip = -60 mm, 60 mm: the running surface of the rail reaches from "
              "-34.027 mm to 34.027 mm");
    check_set(
      "Mesh/Planned strip = 5 mm, 20 mm",
      "--set: Mesh/Planned strip = 5 mm, 20 mm: the wheel touches the rail beside it, at -10.751 mm; write "
      "none, or a strip around that place and a patch");
    const auto answer = [](const std::vector<std::string> &sets) {
      return message_of([&]() { require_computable(scene_from_text("", "x.prm", sets)); });
    };
    BOOST_TEST(
      same_text(answer({"Mesh/Planned strip = -20 mm, 10 mm", "Wheelset/Yaw = 5 mrad"}),
                "--set: Mesh/Planned strip = -20 mm, 10 mm: is for wheels without yaw; write none, or "
                "Wheelset/Yaw = 0 mrad",
                "a strip with yaw"));
    BOOST_TEST(same_text(
      answer({"Mesh/Planned strip = -30 mm, 10 mm"}),
      "x.prm: Mesh/Coarse cell size = 16 mm: rail and wheel cannot be divided into cells at Wheelset/Lateral "
      "shift = 0 mm: Mesh/Planned strip: with whole coarse blocks it is 48 mm wide, and the rail is too "
      "steep "
      "from 21.616 mm beside its middle on (positive to the track centre); take a narrower one, or a smaller "
      "Mesh/Coarse cell size.",
      "a strip that goes round the gauge corner"));
    BOOST_TEST(same_text(answer({"Run/Passage jump = 5"}),
                         "--set: Run/Passage jump: no such entry; all passages are computed: leave it out",
                         "an entry of earlier versions"));
    BOOST_TEST(
      same_text(answer({"Run/Start offset = 16 mm", "Mesh/Window = fixed"}),
                "--set: Run/Start offset = 16 mm: with Mesh/Window = fixed the cells of the rail change with "
                "the start; "
                "leave it out, or set Mesh/Window = moving",
                "another start on a fixed mesh"));
    BOOST_TEST(
      same_text(answer({"Run/Staggered starts = 3", "Mesh/Window = fixed"}),
                "--set: Run/Staggered starts = 3: with Mesh/Window = fixed the cells of the rail change with "
                "the start; "
                "leave it out, or set Mesh/Window = moving",
                "several starts on a fixed mesh"));
    BOOST_TEST(
      same_text(answer({"Run/Start offset = 800 mm"}),
                "x.prm: Run/Rolling distance = 60 mm: with 100 mm of free rail at each end and Run/Start "
                "offset = 800 mm this "
                "needs a rail of 1860 mm, and Track/Rail length is 1800 mm; lengthen the rail",
                "a start too far along"));
  }

  /// Half-spaces need no cells.
  BOOST_AUTO_TEST_CASE(test_halfspace_checks)
  {
    const auto answer = [](const std::vector<std::string> &sets) {
      return message_of([&]() { require_touching(scene_from_text("", "x.prm", sets)); });
    };
    BOOST_TEST(same_text(answer({"Wheelset/Lateral shift = -7 mm"}), "no message", "contact on the flange"));
    BOOST_TEST(same_text(answer({"Mesh/Coarse cell size = 12 mm", "Track/Rail length = 200 mm"}),
                         "no message",
                         "cells and a rail that no run could have"));
    BOOST_TEST(same_text(
      answer({"Rail material/Yield stress = 480 MPa", "Rail material/Tangent modulus = 210 GPa"}),
      "--set: Rail material/Tangent modulus = 210 GPa: not smaller than Rail material/Young's modulus = "
      "210 GPa; beyond yield the stress rises less than before",
      "materials are looked at"));
    const std::string cyclic = "Rail material/Law = Chaboche", yield = "Rail material/Yield stress = 400 MPa";
    BOOST_TEST(
      same_text(answer({cyclic}),
                "x.prm: Rail material/Yield stress = none: Law = Chaboche needs one, such as 380 MPa",
                "a yield stress is asked for"));
    BOOST_TEST(same_text(
      answer({cyclic,
              yield,
              "Rail material/Kinematic moduli = 20 GPa, 5 GPa",
              "Rail material/Kinematic rates = 50"}),
      "--set: Rail material/Kinematic rates = 50: 1 for the 2 moduli of Rail material/Kinematic moduli = "
      "20000 MPa, 5000 MPa; each back stress needs both",
      "lists are compared"));
    BOOST_TEST(
      same_text(answer({cyclic, yield, "Rail material/Isotropic hardening = -399 MPa"}),
                "--set: Rail material/Isotropic hardening = -399 MPa: softens the steel to nothing; at least "
                "a hundredth of "
                "Rail material/Yield stress = 400 MPa must be left",
                "softening is bounded"));
    BOOST_TEST(
      same_text(answer({cyclic,
                        yield,
                        "Rail material/Isotropic hardening = -300 MPa",
                        "Rail material/Isotropic rate = 1000"}),
                "--set: Rail material/Isotropic rate = 1000: with Rail material/Isotropic hardening = -300 "
                "MPa the stress "
                "falls faster than elastic unloading, which no state follows; take a smaller rate",
                "and so is its rate"));
  }

  void
  check_warning(const std::vector<std::string> &sets,
                const std::string              &expected,
                const Machine                  &machine = {})
  {
    const Findings found = check_scene(scene_with(sets), machine).found;
    std::string    all;
    for (const std::string &warning : found.warnings)
      all += (all.empty() ? "" : "\n") + warning;
    BOOST_TEST(same_text(all, expected, "warning: " + expected.substr(0, expected.find(": "))));
    BOOST_TEST(found.errors.empty(), "  and no error");
  }

  void
  check_error(const std::vector<std::string> &sets, const std::string &expected, const Machine &machine = {})
  {
    const Findings found = check_scene(scene_with(sets), machine).found;
    BOOST_TEST(same_text(found.errors.empty() ? "no error" : found.errors.front(),
                         expected,
                         "error: " + expected.substr(0, expected.find(": "))));
  }

  BOOST_AUTO_TEST_CASE(test_warnings)
  {
    const Findings none = check_scene(Scene(), {2, 2, 16e9, 12e9}).found;
    BOOST_TEST((none.errors.empty() && none.warnings.empty()), "the defaults raise no question");
    check_warning({"Contact/Friction coefficient = 0.2", "Wheelset/Traction coefficient = 0.25"},
                  "Wheelset/Traction coefficient = 0.25: friction transmits at most Contact/Friction "
                  "coefficient = 0.2, so the whole patch slides and the wheel spins up while it rolls");
    check_warning({"Wheelset/Traction coefficient = -0.5"},
                  "Wheelset/Traction coefficient = -0.5: friction transmits at most Contact/Friction "
                  "coefficient = 0.5, so the whole patch slides and the wheel locks while it rolls");
    check_warning({"Contact/Friction law = exponential",
                   "Contact/Friction coefficient = 0",
                   "Wheelset/Traction coefficient = 0"},
                  "Contact/Friction coefficient = 0: 0 at rest, but not at speed with Contact/Friction law = "
                  "exponential");
    check_warning(
      {"Contact/Friction law = exponential", "Contact/Friction decay = 10 s/m"},
      "Contact/Friction law = exponential: friction falls by 1 per m/s of sliding; at 1 GPa a fall "
      "beyond 0.0126 feeds sliding more than shear waves carry away, and tractions oscillate from "
      "node to node");
    check_warning({"Wheelset/Creepage = 0.001"},
                  "Wheelset/Creepage = 0.001: without effect, since Wheelset/Drive = torque");
    check_warning(
      {"Wheelset/Sprung mass = 0.01 t", "Mesh/Solution cell size = 0.5 mm", "Run/Wanted accuracy = 0.06"},
      "Wheelset/Sprung mass = 0.01 t: next to nothing presses the wheel on the rail; a railway "
      "vehicle has some 10 t per wheel");
    check_warning({"Wheelset/Sprung mass = 9 t", "Wheelset/Wheel load = 100 kN"},
                  "Wheelset/Sprung mass = 9 t: without effect, since Wheelset/Wheel load = 100 kN is set");
    check_warning({"Rail material/Young's modulus = 21 GPa", "Rail material/Tangent modulus = 2 GPa"},
                  "Rail material/Young's modulus = 21 GPa: steel has about 210 GPa");
    check_warning(
      {"Rail material/Kinematic moduli = 20 GPa", "Rail material/Kinematic rates = 50"},
      "Rail material/Law = bilinear: without effect are Isotropic hardening, Kinematic moduli and Kinematic "
      "rates, which belong to Chaboche");
    check_warning({"Wheel material/Law = Chaboche",
                   "Wheel material/Yield stress = 400 MPa",
                   "Wheel material/Kinematic moduli = 20 GPa, 5 GPa",
                   "Wheel material/Kinematic rates = 50, 100000"},
                  "Wheel material/Kinematic rates = 50, 100000: back stress 2 is bounded by C / gamma = 0.05 "
                  "MPa, next to "
                  "nothing beside the yield stress");
    check_warning({"Wheel material/Density = 790 kg/m3"},
                  "Wheel material/Density = 790 kg/m3: steel has about 7900 kg/m3");
    check_warning({"Rail material/Poisson's ratio = 0.48"},
                  "Rail material/Poisson's ratio = 0.48: nearly incompressible; steel has about 0.3, and the "
                  "stable time step falls to zero towards 0.5");
    check_warning(
      {"Mesh/Solution cell size = 4 mm", "Mesh/Fine margin = 4 mm"},
      "Mesh/Solution cell size = 4 mm: coarse; a patch of about 20 mm x 14 mm (width x length) "
      "is expected, some 3.3 cells in one direction, so the peak pressure will be uncertain by about 14 "
      "%; take 2 mm for results");
    check_warning(
      {"Wheelset/Sprung mass = 1.2 t", "Mesh/Solution cell size = 2 mm"},
      "Mesh/Solution cell size = 2 mm: coarse; a patch of about 6.7 mm x 7.8 mm (width x length) "
      "is expected, some 3.1 cells in one direction, so the peak pressure will be uncertain by about 16 "
      "%; take 1 mm for results");
    check_warning(
      {"Contact/Penalty scale = 0.5"},
      "Contact/Penalty scale = 0.5: low; the peak pressure will be uncertain by about 10 %; raise "
      "it for results");
    check_warning({"Run/Time step factor = 0.001"},
                  "Run/Rolling distance = 60 mm: takes about 10 million time steps at Wheelset/Velocity = "
                  "140 km/h, Mesh/Solution cell size = 1 mm and Run/Time step factor = 0.001, days of "
                  "computing; a higher speed or a shorter distance takes less");
    check_warning({},
                  "--ranks 8: more than the 2 cores of this machine; ranks that wait for each other take "
                  "turns, which is slower than fewer ranks",
                  {8, 2, 0, 0});
    check_warning({"Run/Rolling distance = 100 mm"},
                  "Mesh/Solution cell size = 1 mm: with Mesh/Coarse cell size = 16 mm this makes about 41000 "
                  "cells and may need some 0.87 GB of memory, 0.5 GB are free; take larger cells, a shorter "
                  "rolling distance or a smaller fine depth or margin",
                  {2, 2, 16e9, 0.5e9});
    check_error(
      {"Run/Error estimate = two meshes", "Rail material/Yield stress = 480 MPa", "Run/Passages = 2"},
      "Run/Error estimate = two meshes: a rail that was rolled over has cells of one size; write model");
    check_error(
      {"Run/Error estimate = two meshes", "Mesh/Solution cell size = 4 mm", "Mesh/Fine margin = 4 mm"},
      "Run/Error estimate = two meshes: the second run, on cells of 8 mm: Mesh/Solution cell size = 8 "
      "mm: too coarse; a patch of about 20 mm x 14 mm (width x length) is expected and needs three "
      "cells in length, so at most 4.7 mm is accepted; take 2 mm for results");
    check_error(
      {"Run/Rolling distance = 100 mm"},
      "Mesh/Solution cell size = 1 mm: with Mesh/Coarse cell size = 16 mm this makes about 41000 "
      "cells and needs some 0.87 GB of memory, this machine has 0.4 GB; take larger cells, a shorter "
      "rolling distance or a smaller fine depth or margin",
      {2, 2, 0.4e9, 0.4e9});
    check_error(
      {"Mesh/Solution cell size = 5 mm", "Mesh/Coarse cell size = 20 mm", "Mesh/Fine margin = 5 mm"},
      "Mesh/Solution cell size = 5 mm: too coarse; a patch of about 20 mm x 14 mm (width x length) is "
      "expected and needs three cells in length, so at most 4.7 mm is accepted; take 1.25 mm for "
      "results");
    check_error(
      {"Mesh/Solution cell size = 0.1 mm",
       "Mesh/Coarse cell size = 1.6 mm",
       "Run/Rolling distance = 1 m",
       "Mesh/Window = fixed"},
      "Mesh/Solution cell size = 0.1 mm: with Mesh/Coarse cell size = 1.6 mm this makes about 65 million "
      "cells, and 50 million are possible; take larger cells, a shorter rolling distance or a smaller fine "
      "depth or margin");
    check_error({"Wheelset/Lateral shift = 11 mm", "Wheelset/Flange back distance = 1370 mm"},
                "Wheelset/Lateral shift = 11 mm: Wheel 'S1002' and rail '54E1' have no contact point at a "
                "lateral shift of 11 mm: at the other wheel of the wheelset (shift of opposite sign) the "
                "flange stands on the rail. With this track, shifts from -10.4 to 10.4 mm are possible; set "
                "Wheelset/Lateral shift within them.");
    check_error(
      {"Wheelset/Lateral shift = -9 mm"},
      "Mesh/Coarse cell size = 16 mm: rail and wheel cannot be divided into cells at Wheelset/Lateral shift "
      "= -9 mm: The wheel section cannot be built: the fine cells reach so far up the flange that no block "
      "of "
      "16 mm fits between them and its tip. With Wheelset/Lateral shift = -6.2 mm they can.");
    check_error(
      {"Wheelset/Lateral shift = -6 mm", "Wheelset/Roll = from contact"},
      "Mesh/Coarse cell size = 16 mm: rail and wheel cannot be divided into cells at Wheelset/Lateral shift "
      "= -6 mm: The wheel section cannot be built: the fine cells reach so far up the flange that no block "
      "of "
      "16 mm fits between them and its tip. With Mesh/Coarse cell size = 8 mm they can.");
    check_error(
      {"Wheelset/Wheel load = 4 kN"},
      "Wheelset/Wheel load = 4 kN: less than the weight of wheel and half axle, 4.91 kN; give more, or a "
      "lighter Wheelset/Axle mass");
    check_error({"Wheelset/Fillet radius = 99 mm"},
                "Mesh/Coarse cell size = 16 mm: rail and wheel cannot be divided into cells at "
                "Wheelset/Lateral shift = 0 mm: The wheel section cannot be built: the disc with its fillets "
                "must lie within the width of the rim.");
    check_error(
      {"Mesh/Coarse cell size = 64 mm", "Mesh/Solution cell size = 4 mm", "Mesh/Fine margin = 50 mm"},
      "Mesh/Coarse cell size = 64 mm: rail and wheel cannot be divided into cells at Wheelset/Lateral shift "
      "= 0 mm: The section mesh has a folded block in its part 'running layer' at (-30.362 mm, "
      "-54.688 mm). The fine strip or the dimensions leave too little room there: reduce the block size, "
      "narrow the "
      "strip, or check the dimensions of the section. With Mesh/Coarse cell size = 16 mm they can.");
    check_error({"Run/Rolling distance = 1.7 m"},
                "Run/Rolling distance = 1700 mm: with 100 mm of free rail at each end this needs a rail of "
                "1900 mm, and Track/Rail length is 1800 mm; roll at most 1600 mm or lengthen the rail");
    check_error({"Mesh/Coarse cell size = 64 mm", "Run/Rolling distance = 1.5 m"},
                "Run/Rolling distance = 1500 mm: with 206 mm of free rail at each end this needs a rail of "
                "1912 mm, and Track/Rail length is 1800 mm; roll at most 1388 mm or lengthen the rail");
    check_error({"Track/Rail length = 200 mm"},
                "Run/Rolling distance = 60 mm: with 100 mm of free rail at each end this needs a rail of "
                "260 mm, and Track/Rail length is 200 mm; lengthen the rail");
  }
} // namespace
