// The command compare: a run that is the half-space solution itself, in a pose, differs from it by nothing;
// forces and pose come from its files; sentences on trust.

#include "check.h"

#include <wheelrail/application/commands.h>
#include <wheelrail/application/compare_command.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/output/hdf5_file.h>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace wheelrail;
using test::check;
using test::check_near;

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
    load.longitudinal              = 20e3;
    const WheelRailSolution result = solve_wheel_rail(scene, make_geometry(scene), load, offsets);
    Summary                 run    = halfspace_summary(scene, result);
    set_figure(run, "relative_lateral_m", offsets.lateral);
    set_figure(run, "rail_head_roll_rad", offsets.rail_roll);
    set_figure(run, "wheel_rim_roll_rad", offsets.wheel_roll);
    set_figure(run, "vertical_force_std_N", 950);
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
    execute({"compare", folder.string()}, {}, out);
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
    other             = good;
    other.cells       = 7;
    other.penetration = 0.08;
    has(other, true, "7 cells of 1 mm over the shorter extent of the patch are too few");
    other.cells = 1.3;
    has(other, true, "1 cell of 1 mm over the shorter extent of the patch is too few");
    has(other, true, "raise Contact/Penalty scale");
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
  }
} // namespace

int
main()
{
  fs::remove_all(folder);
  test_same_solution();
  test_pose_is_used();
  test_sentences();
  return test::report();
}
