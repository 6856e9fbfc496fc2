// needs: vehicle

// The command halfspace: files it writes, balance of forces, figures of CONTACT, both kinds of spin.

#include "messages.h"
#include "near.h"
#include "read_output.h"

#include <wheelrail/application/command_line.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/sampling/patch_measures.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;

namespace
{
  namespace fs = std::filesystem;

  const fs::path folder = "halfspace_command_output";

  /// Runs the command on the default scene with changes; the summary it wrote.
  Summary
  solve(const std::string &spin, const std::string &traction)
  {
    fs::create_directories(folder);
    std::ofstream(folder / "scene.prm")
      << "set Title = half-spaces\nsubsection Wheelset\n  set Traction coefficient = 0.25\nend\n"
         "subsection Half-space\n  set Bodies = half-spaces\nend\n";
    std::ostringstream out;
    const int          code = execute({"halfspace",
                                       (folder / "scene.prm").string(),
                                       "--set",
                                       "Output/Folder = " + (folder / "scene").string(),
                                       "--set",
                                       "Half-space/Spin = " + spin,
                                       "--set",
                                       "Wheelset/Traction coefficient = " + traction},
                             {},
                             out);
    BOOST_TEST(near(code, 0, 0, spin + ": exit code"));
    BOOST_TEST(out.str().rfind(
                 "  wheel and rail  S1002 wheel on 54E1 rail, inclination 1:40\n"
                 "  running         wheel load 103.2 kN, 140 km/h, lateral shift 0 mm, yaw 0 mrad\n" +
                   std::string(traction[0] == '-' ? "  drive           braking, traction coefficient -0.25"
                                                  : "  drive           driving, traction coefficient 0.25") +
                   " of friction 0.5\n"
                   "  elements        of 0.4 mm\n",
                 0) == 0,
               spin + ": begins with what is computed");
    BOOST_TEST((out.str().find("peak pressure") != std::string::npos), spin + ": prints a table");
    return read_summary((folder / "scene-halfspace" / "summary.json").string());
  }

  void
  check_files(const Summary &s)
  {
    const PatchFields   patch = test::read_patch((folder / "scene-halfspace" / "halfspace.h5").string(), 0);
    const PatchMeasures m     = measure_patch(patch);
    BOOST_TEST(near(m.normal_force / s.normal_force, 1, 1e-6, "sum of the pressures over normal force"));
    BOOST_TEST(
      near(m.traction_force_along / -s.longitudinal_force, 1, 1e-3, "sum of the tractions over the force"));
    BOOST_TEST(near(m.peak_pressure, s.max_pressure, 1, "peak pressure of the file"));
    double worst = 0;
    for (std::size_t k = 0; k < patch.state.size(); ++k)
      if (patch.state[k] == 2) // friction on the rail acts along the slip of the wheel
        worst = std::max(worst,
                         std::hypot(patch.slip_along[k], patch.slip_lateral[k]) *
                             std::hypot(patch.traction_along[k], patch.traction_lateral[k]) -
                           (patch.slip_along[k] * patch.traction_along[k] +
                            patch.slip_lateral[k] * patch.traction_lateral[k]));
    BOOST_TEST(near(worst, 0, 1e-3 * 5e8 * 1e-3, "tractions on the rail against slip of the wheel"));
    for (const char *file :
         {"parameters.prm", "pictures/sheet.png", "pictures/cut_aa.png", "pictures/subsurface_bb.png"})
      BOOST_TEST(fs::exists(folder / "scene-halfspace" / file), std::string(file) + " is written");
  }
  /// Friction that falls with the slip to a tenth cannot carry a traction of 0.25: the wheel spins up.
  void
  too_much_force()
  {
    std::ostringstream out;
    const int          code = execute({"halfspace",
                                       (folder / "scene.prm").string(),
                                       "--no-pictures",
                                       "--set",
                                       "Half-space/Element size = 1 mm",
                                       "--set",
                                       "Contact/Friction law = rational",
                                       "--set",
                                       "Contact/Dynamic friction coefficient = 0.05",
                                       "--set",
                                       "Contact/Friction half velocity = 0.01 m/s"},
                             {},
                             out);
    BOOST_TEST(
      (code == 0 && out.str().find("The whole patch slides: the wheel spins up") != std::string::npos),
      "more force than falling friction carries: the wheel spins up");
  }

  /// The command at places along rails by slices: its screen, and the column `trusted` of its table.
  std::string
  roll_on_slices(const std::string &scene,
                 const std::string &place,
                 const std::string &shift,
                 const double       trusted)
  {
    std::ostringstream out;
    const fs::path     at = folder / "slices";
    execute({"halfspace",
             WHEELRAIL_SOURCE_DIR "/prm/" + scene,
             "--places",
             place,
             "--no-pictures",
             "--set",
             "Output/Folder = " + at.string(),
             "--set",
             "Wheelset/Lateral shift = " + shift},
            {},
            out);
    const std::string table = read_whole_file(at.string() + "-halfspace/places.csv");
    const std::string what  = scene + ", shift " + shift + ": trusted";
    for (std::size_t end = table.find('\n', table.find('\n') + 1); end != std::string::npos;
         end             = table.find('\n', end + 1))
      BOOST_TEST(near(table[end - 1] - '0', trusted, 0, what));
    return out.str();
  }

  void
  test_slices()
  {
    const auto holds = [](const std::string &text, const std::string &part) {
      BOOST_TEST((text.find(part) != std::string::npos), part);
    };
    holds(roll_on_slices("crossing.prm", "150 mm", "-5 mm", 0),
          "   150.000 not trusted: The peak pressure of 5.1 GPa is more than any rail steel bears (4 GPa)");
    const std::string joint = roll_on_slices("insulated_joint.prm", "0 mm", "0 mm", 1);
    BOOST_TEST((joint.find("not trusted") == std::string::npos), "wheel and rail that lie into each other");
  }

  /// Half-spaces have no run beside them.
  void
  compared()
  {
    const std::string  results = (folder / "scene-halfspace").string();
    std::ostringstream out;
    BOOST_TEST(test::same_text(test::message_of([&]() {
                                 execute({"compare", results}, {}, out);
                               }),
                               results +
                                 ": half-spaces, which have no run to be compared with; compare needs the "
                                 "output folder of a run",
                               "compare of a folder of halfspace"));
    const std::string other = (folder / "receptance").string();
    fs::create_directories(other);
    std::ofstream(other + "/receptance.csv") << "frequency_Hz\n";
    BOOST_TEST(test::same_text(
      test::message_of([&]() {
        execute({"compare", other}, {}, out);
      }),
      other + ": receptance.csv is there, which no run leaves; compare needs the output folder of a run",
      "compare of a folder of another command"));
    BOOST_TEST(out.str().empty(), "and nothing is compared");
  }

  /// All commands that draw at their end fail when that fails; the results are there.
  void
  not_drawn()
  {
    std::ofstream(folder / "rows.csv") << "distance [m],lateral shift [mm]\n0,0\n";
    const std::string scene = (folder / "scene.prm").string(), rows = (folder / "rows.csv").string();
    struct Case
    {
      Arguments   arguments;
      std::string script, results, file;
    };
    const std::vector<Case> cases = {{{"halfspace", scene}, "halfspace.py", "-halfspace", "halfspace.h5"},
                                     {{"halfspace", scene, "--creep-curve", "longitudinal 0:1:1 %"},
                                      "creep_curve.py",
                                      "-halfspace",
                                      "creep_curve.csv"},
                                     {{"vehicle", scene, rows}, "vehicle.py", "-vehicle", "vehicle.csv"},
                                     {{"material", scene, "--set", "Material test/Axial = 0.001"},
                                      "material.py",
                                      "-material",
                                      "material.csv"}};
    ::setenv("PYTHONHOME", "/nowhere", 1); // with which Python ends at its start
    for (Case one : cases)
      {
        const std::string whole = (folder / "not_drawn").string();
        for (const std::string &set :
             {"Output/Folder = " + whole, std::string("Half-space/Element size = 1 mm")})
          one.arguments.insert(one.arguments.end(), {"--set", set});
        std::ostringstream out;
        BOOST_TEST(test::same_text(test::message_of([&]() { execute(one.arguments, {}, out); }),
                                   "The results in " + whole + one.results + " are whole, but " + one.script +
                                     " could not draw them; mend what it says above, or leave pictures out "
                                     "(--no-pictures).",
                                   one.script + " fails"));
        BOOST_TEST(fs::exists(fs::path(whole + one.results) / one.file), one.file + " is there");
      }
    ::unsetenv("PYTHONHOME");
  }
} // namespace


BOOST_AUTO_TEST_CASE(halfspace_command)
{
  fs::remove_all(folder);
  const Summary s = solve("local radius", "0.25");
  BOOST_TEST(s.finished, "converged");
  // CONTACT at 103 kN (contact_pose_54E1.csv); the load of the scene is 103.2 kN
  BOOST_TEST(near(s.max_pressure / 1300.1e6, 1, 0.004, "peak pressure over that of CONTACT"));
  BOOST_TEST(
    near(get_figure(s, "area_of_whole_elements_m2") / 181.92e-6, 1, 0.01, "area over that of CONTACT"));
  BOOST_TEST(near(s.max_shear_traction / 582e6, 1, 0.02, "peak shear over that of CONTACT"));
  BOOST_TEST(near(s.longitudinal_force / s.vertical_force, 0.25, 1e-4, "traction coefficient"));
  BOOST_TEST(near(s.vertical_force, 103.2e3, 100, "wheel load"));
  // whole elements count half an element around the edge too many
  BOOST_TEST(s.contact_area < get_figure(s, "area_of_whole_elements_m2"), "the edge line lies inside");
  check_files(s);

  const Summary c = solve("contact", "0.25");
  // The tread is hollow (radius 0.3 m): over +-9 mm its mean radius exceeds the one in the middle by about
  // 5e-3^2 / (2 * 0.3) m, 1e-4 of the rolling radius, so that the wheel needs less creepage.
  BOOST_TEST(near(c.creepage - s.creepage, 1e-4, 0.6e-4, "creepage of one spin less that of local radii"));
  BOOST_TEST(near(c.max_shear_traction / s.max_shear_traction, 1, 0.03, "peak shear with one spin"));
  const Summary b = solve("local radius", "-0.25");
  BOOST_TEST(near(b.longitudinal_force / s.longitudinal_force, -1, 0.002, "braking force"));
  BOOST_TEST(b.creepage < 0, "braking creepage");
  too_much_force();
  compared();
  not_drawn();
  test_slices();
}
