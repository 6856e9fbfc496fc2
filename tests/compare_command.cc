// The command compare: a run that is the half-space solution itself, in a pose, differs from it by nothing;
// forces and pose come from its files; sentences on trust.

#include "check.h"
#include "messages.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/application/compare_command.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/reference/trust.h>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace wheelrail;
using test::check;
using test::check_near;
using test::check_text;

namespace
{
  namespace fs = std::filesystem;

  const fs::path folder = "compare_command_output";

  /// A folder as of a finished run whose patch is the half-space solution under `load`, in a pose.
  void
  write_run(const Scene &scene, const SectionOffsets &offsets)
  {
    WheelRailLoad load;
    load.force                     = 95e3;
    load.vertical                  = true;
    load.longitudinal              = scene.friction_coefficient > 0 ? 20e3 : 0;
    const WheelRailSolution result = solve_wheel_rail(scene, make_geometry(scene), load, offsets);
    Summary                 run    = halfspace_summary(scene, result);
    set_figure(run, "relative_lateral_m", offsets.lateral);
    set_figure(run, "rail_head_roll_rad", offsets.rail_roll);
    set_figure(run, "wheel_rim_roll_rad", offsets.wheel_roll);
    set_figure(run, "vertical_force_std_N", 900);
    set_figure(run, "longitudinal_force_std_N", 90);
    fs::create_directories(folder);
    write_summary(run, (folder / "summary.json").string());
    std::ofstream(folder / "parameters.prm") << print_parameters(scene);
    TickFile patches((folder / "patch.h5").string(), false, 0);
    append_patch(patches, result.patch);
  }

  void
  test_same_solution()
  {
    Scene scene;
    scene.traction_coefficient   = 0.25;
    scene.halfspace_element_size = 0.5e-3;
    write_run(scene, {-0.2e-3, -1.5e-3, 0.3e-3});
    std::ostringstream out;
    check_near(execute({"compare", folder.string()}, {}, out), 0, 0, "exit code");
    const Summary s = read_summary((folder / "summary.json").string());
    for (const char *base : {"vertical_force",
                             "longitudinal_force",
                             "normal_force",
                             "lateral_force",
                             "max_pressure",
                             "contact_area",
                             "patch_lateral",
                             "patch_longitudinal",
                             "max_shear_traction",
                             "creepage",
                             "stick_fraction"})
      check_near(get_figure(s, std::string("relative_difference_") + base), 0, 1e-3, base);
    check_near(get_figure(s, "halfspace_max_pressure_Pa"), s.max_pressure, 1e-3 * s.max_pressure, "its peak");
    check(out.str().find("-% %") == std::string::npos && out.str().find("% of the load") != std::string::npos,
          "differences with their unit, the lateral force in parts of the load");
    check(out.str().find("agrees with the half-spaces within 0.1 %") != std::string::npos, "the sentence");
    for (const char *file : {"compare.json",
                             "compare.html",
                             "halfspace.h5",
                             "halfspace_slices.h5",
                             "pictures/compare_cut_aa.png",
                             "pictures/compare_subsurface_aa.png"})
      check(fs::exists(folder / file), std::string(file) + " is written");
    std::ifstream     page(folder / "compare.html");
    std::stringstream text;
    text << page.rdbuf();
    check(text.str().find("data:image/png;base64,") != std::string::npos, "the page holds its pictures");
    check(text.str().find("://") == std::string::npos, "the page needs no network");
  }

  /// Without its pose in the summary the same run compares worse: the pose is used.
  void
  test_pose_is_used()
  {
    const std::string path = (folder / "summary.json").string();
    Summary           s    = read_summary(path);
    set_figure(s, "relative_lateral_m", 0);
    set_figure(s, "rail_head_roll_rad", 0);
    set_figure(s, "wheel_rim_roll_rad", 0);
    write_summary(s, path);
    std::ostringstream out;
    execute({"compare", folder.string(), "--no-pictures"}, {}, out);
    // -26 MPa per 0.1 mm and -75 MPa per mrad of inclination (contact_pose_54E1.csv)
    const double expected = (2 * 26 - 1.8 * 75) * 1e6 / 1270e6;
    check_near(get_figure(read_summary(path), "relative_difference_max_pressure"),
               expected,
               0.015,
               "effect of the pose");
  }

  void
  test_sentences()
  {
    const auto has = [](const Trust &trust, const bool finished, const std::string &part) {
      const std::string sentence = trust_sentence(Scene(), trust, finished);
      check(sentence.find(part) != std::string::npos, "\"" + part + "\" in: " + sentence);
    };
    const Trust good{-0.015, 13, 0.008, 0.003, 0.1, 0};
    has(good, true, "within 1.5 % in peak pressure and can be trusted as far");
    has(good, true, "are enough");
    has(good, false, "did not finish");
    Trust other           = good;
    other.peak_difference = -0.04;
    has(other, true, "can be trusted to about 4 %");
    other.peak_difference = -0.12;
    has(other, true, "off by 12 % in peak pressure and shows tendencies only");
    other       = good;
    other.cells = 7;
    has(other, true, "differs from the half-spaces by 1.5 % in peak pressure, which may be chance: 7 cells");
    other.penetration = 0.08;
    has(other, true, "7 cells of 1 mm over the shorter extent of the patch are too few");
    other.cells = 1.3;
    has(other, true, "1 cell of 1 mm over the shorter extent of the patch is too few");
    has(other, true, "raise Contact/Penalty scale");
    check(trust_sentence(Scene(), other, true).find("Of the difference") == std::string::npos,
          "no rule of parts is known for so few cells");
    other.cells        = 7;
    other.unsteadiness = 0.02;
    has(other, true, "not steady");
    other.turn = 0.5;
    has(other, true, "no full reference here, since the surfaces turn by 29 degrees");
    has(other, true, "the curved contact");
    other                 = good;
    other.peak_difference = -0.123;
    other.plastic_strain  = 2.9e-3;
    has(other, true, "no full reference here, since steel has flowed (plastic strain up to 2.9e-3)");
    has(other, true, "yielding, which half-spaces know nothing of");
    const std::string yielded = trust_sentence(Scene(), other, true);
    check(yielded.find("fair reference") == std::string::npos &&
            yielded.find("can be trusted") == std::string::npos,
          "a run that has flowed is not judged by half-spaces: " + yielded);
    other.patches = 2;
    has(other, true, "and the run has 2 patches");
    // the parts of doc/manual/compare.md: 13 cells, f = 10
    check_near(good.penalty_part(), -0.0067, 2e-4, "what the penalty contact takes from the peak");
    check_near(good.mesh_part(), -0.0077, 2e-4, "what the cells take");
    other.patches = 1;
    other.turn    = 0.5;
    has(other,
        true,
        "since steel has flowed (plastic strain up to 2.9e-3) and the surfaces turn by 29 degrees");
    other                = good;
    other.plastic_strain = 5e-5;
    has(other, true, "can be trusted as far");
  }

  /// What a run says of itself when its peak is not that of half-spaces.
  void
  test_misses()
  {
    Scene scene;
    Trust trust{-0.09, 13, 0.008, 0.003, 0.1, 0};
    check(peak_miss(scene, trust).sentence.empty(), "a tenth of the peak may be missing");
    trust.peak_difference = -0.27;
    trust.cells           = 4;
    PeakMiss miss         = peak_miss(scene, trust);
    check_text(
      miss.sentence,
      "the peak pressure is 27 % below that of half-spaces under the same force and in the same pose: 4 "
      "cells of 1 mm over the shorter extent of the patch are too few (take at least 12)",
      "too few cells");
    check(miss.is_fault, "which is the run's fault");
    trust.cells = 13;
    check_text(
      peak_miss(scene, trust).sentence,
      "the peak pressure is 27 % below that of half-spaces under the same force and in the same pose, and "
      "the usual causes (cells, penalty, unsteady forces) do not explain it",
      "no known cause");
    trust.plastic_strain = 0.01;
    miss                 = peak_miss(scene, trust);
    check_text(
      miss.sentence,
      "the peak pressure is 27 % below that of half-spaces under the same force and in the same pose: "
      "half-spaces are no full reference here, since steel has flowed (plastic strain up to 10e-3)",
      "bodies that yield");
    check(!miss.is_fault, "which is no fault");
    trust.plastic_strain = 0;
    trust.patches        = 2;
    check(!peak_miss(scene, trust).is_fault, "nor are two patches");
  }

  /// Figures of a summary that was changed by hand.
  void
  test_changed_figures()
  {
    const std::string path         = (folder / "summary.json").string();
    const Summary     whole        = read_summary(path);
    const auto        check_figure = [&](const char *key, const double value, const std::string &end) {
      Summary changed = whole;
      set_figure(changed, key, value);
      write_summary(changed, path);
      std::ostringstream out;
      check_text(test::message_of([&]() {
                   execute({"compare", folder.string()}, {}, out);
                 }),
                 "The file \"" + path + "\" " + end,
                 std::string(key) + " changed");
    };
    const std::string lacks =
      "lacks one of vertical_force_N, longitudinal_force_N and max_pressure_Pa: the run did not get so far "
      "that "
      "its patch could be compared.";
    check_figure("vertical_force_N", Summary::none, lacks);
    check_figure("max_pressure_Pa", Summary::none, lacks);
    const std::string none =
      ", which no run of its scene gives; compute it again with \"./wheelrail run\" and --overwrite.";
    check_figure("vertical_force_N", 1e12, "holds vertical_force_N = 1e+12" + none);
    check_figure("vertical_force_N", -5, "holds vertical_force_N = -5" + none);
    check_figure("longitudinal_force_N", 1e12, "holds longitudinal_force_N = 1e+12" + none);
    check_figure("max_pressure_Pa", 1e14, "holds max_pressure_Pa = 1e+14" + none);
    check_figure("relative_lateral_m", 1e12, "holds relative_lateral_m = 1e+12" + none);
    check_figure("rail_head_roll_rad", 1e12, "holds rail_head_roll_rad = 1e+12" + none);
    write_summary(whole, path);
  }

  /// A frictionless run has a longitudinal force of some newtons, of the pressures on its bent surfaces.
  void
  test_frictionless()
  {
    Scene scene;
    scene.friction_coefficient = 0;
    scene.traction_coefficient = 0;
    write_run(scene, {});
    const std::string path = (folder / "summary.json").string();
    Summary           run  = read_summary(path);
    set_figure(run, "longitudinal_force_N", 0.527);
    set_figure(run, "creepage", 1e-5);
    write_summary(run, path);
    std::ostringstream out;
    check_near(execute({"compare", folder.string(), "--no-pictures"}, {}, out),
               0,
               0,
               "exit code of a frictionless comparison");
    check(out.str().find("nan") == std::string::npos, "no nan in it");
    check_near(get_figure(read_summary(path), "relative_difference_max_pressure"), 0, 1e-3, "its peak");
  }
} // namespace

int
main()
{
  fs::remove_all(folder);
  test_same_solution();
  test_pose_is_used();
  test_sentences();
  test_misses();
  test_changed_figures();
  test_frictionless();
  return test::report();
}
