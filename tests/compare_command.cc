// The command compare: a run that is the half-space solution itself, in a pose, differs from it by nothing;
// forces and pose come from its files; sentences on trust.

#include "messages.h"
#include "near.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/bodies/run_reference.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/output/hdf5_file.h>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace wheelrail;
using test::near;
using test::same_text;

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
    load.longitudinal              = scene.friction.at_rest > 0 ? 20e3 : 0;
    const WheelRailSolution result = solve_wheel_rail(scene, make_geometry(scene), load, offsets);
    Summary                 run    = halfspace_summary(scene, result);
    set_figure(run, "relative_lateral_m", offsets.lateral);
    set_figure(run, "rail_head_roll_rad", offsets.rail_roll);
    set_figure(run, "wheel_rim_roll_rad", offsets.wheel_roll);
    run.energy_error = 4e-4;
    set_figure(run, "max_pressure_fitted_std_Pa", 1e6);
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
    BOOST_TEST(near(execute({"compare", folder.string()}, {}, out), 0, 0, "exit code"));
    const Summary s = read_summary((folder / "summary.json").string());
    for (const std::string &base : split_list(
           "vertical_force, longitudinal_force, normal_force, lateral_force, max_pressure, contact_area, "
           "patch_lateral, patch_longitudinal, max_shear_traction, creepage, stick_fraction"))
      BOOST_TEST(near(get_figure(s, std::string("relative_difference_") + base), 0, 1e-3, base));
    BOOST_TEST(
      near(get_figure(s, "halfspace_max_pressure_Pa"), s.max_pressure, 1e-3 * s.max_pressure, "its peak"));
    BOOST_TEST(
      (out.str().find("-% %") == std::string::npos && out.str().find("% of the load") != std::string::npos),
      "differences with their unit, the lateral force in parts of the load");
    BOOST_TEST((out.str().find("The run agrees with the half-spaces within 0.1 %") != std::string::npos),
               "the sentence");
    for (const std::string &file :
         split_list("compare.json, compare.html, halfspace.h5, halfspace_slices.h5, "
                    "pictures/compare_cut_aa.png, pictures/compare_subsurface_aa.png"))
      BOOST_TEST(fs::exists(folder / file), std::string(file) + " is written");
    const std::string page = read_whole_file((folder / "compare.html").string());
    BOOST_TEST((page.find("data:image/png;base64,") != std::string::npos), "the page holds its pictures");
    BOOST_TEST((page.find("://") == std::string::npos), "the page needs no network");
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
    BOOST_TEST(near(get_figure(read_summary(path), "relative_difference_max_pressure"),
                    expected,
                    0.015,
                    "effect of the pose"));
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
      BOOST_TEST(same_text(test::message_of([&]() {
                             execute({"compare", folder.string()}, {}, out);
                           }),
                           "The file \"" + path + "\" " + end,
                           std::string(key) + " changed"));
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
    scene.friction.at_rest     = 0;
    scene.traction_coefficient = 0;
    write_run(scene, {});
    const std::string path = (folder / "summary.json").string();
    Summary           run  = read_summary(path);
    set_figure(run, "longitudinal_force_N", 0.527);
    set_figure(run, "creepage", 1e-5);
    write_summary(run, path);
    std::ostringstream out;
    BOOST_TEST(near(execute({"compare", folder.string(), "--no-pictures"}, {}, out),
                    0,
                    0,
                    "exit code of a frictionless comparison"));
    BOOST_TEST((out.str().find("nan") == std::string::npos), "no nan in it");
    BOOST_TEST(near(get_figure(read_summary(path), "relative_difference_max_pressure"), 0, 1e-3, "its peak"));
  }

  /// Another folder than that of a run, and a word that is none of the bodies.
  void
  test_refused()
  {
    std::ostringstream out;
    const std::string  other = (folder / "pictures").string();
    BOOST_TEST(same_text(test::message_of([&]() {
                           execute({"compare", other}, {}, out);
                         }),
                         "The folder " + other + " holds no summary.json; give the output folder of a run.",
                         "a folder without a run"));
    BOOST_TEST(same_text(test::message_of([&]() {
                           execute({"compare", folder.string(), "--bodies", "reel"}, {}, out);
                         }),
                         "--bodies reel: half-spaces or real is accepted",
                         "a misspelt word"));
  }

  /// A wheel on two rails at a time.
  void
  test_two_rails()
  {
    Scene scene;
    write_run(scene, {});
    const std::string path = (folder / "summary.json").string();
    Summary           run  = read_summary(path);
    set_figure(run, "second_rail_force_N", 30e3);
    set_figure(run, "patches", 2);
    write_summary(run, path);
    std::ostringstream out;
    BOOST_TEST(
      same_text(test::message_of([&]() {
                  execute({"compare", folder.string()}, {}, out);
                }),
                "The file \"" + path +
                  "\" holds 2 separate patches on two rails beside each other, which compare takes for one; "
                  "half-spaces at each place of these rails: \"./wheelrail halfspace FILE.prm --places\".",
                "patches on two rails"));
  }

  /// A wheel that flies where the means are taken.
  void
  test_off_the_rail()
  {
    Scene scene;
    scene.irregularities[0].kind  = IrregularKind::dent;
    scene.irregularities[0].place = 0.04;
    scene.irregularities[0].depth = 0.1e-3;
    write_run(scene, {});
    const std::string path = (folder / "summary.json").string();
    Summary           run  = read_summary(path);
    set_figure(run, "wheel_load_N", 80e3);
    set_figure(run, "vertical_force_N", 500);
    write_summary(run, path);
    std::ostringstream out;
    BOOST_TEST(same_text(
      test::message_of([&]() {
        execute({"compare", folder.string()}, {}, out);
      }),
      "The file \"" + path +
        "\" holds means of a wheel off the rail, which has no patch to be compared; compute it again with "
        "Run/Evaluate at = largest force.",
      "a wheel off the rail"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(compare_command)
{
  fs::remove_all(folder);
  test_same_solution();
  test_pose_is_used();
  test_changed_figures();
  test_frictionless();
  test_two_rails();
  test_off_the_rail();
  test_refused();
}
