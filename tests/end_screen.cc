// label: fast

// What a run says at its end: the verdict first, figures in groups, at most 25 lines.

#include <wheelrail/run/end_screen.h>

#include "near.h"

#include <algorithm>
#include <string>
#include <vector>

using namespace wheelrail;
using test::same_text;

namespace
{
  Summary
  finished_run()
  {
    Summary s;
    s.title                  = "a run";
    s.finished               = true;
    s.verdict                = "with care";
    s.vertical_force         = 100e3;
    s.lateral_force          = -2e3;
    s.longitudinal_force     = 25e3;
    s.max_pressure           = 1234.5e6;
    s.contact_area           = 176.6e-6;
    s.patch_lateral          = 0.02;
    s.patch_longitudinal     = 0.012;
    s.creepage               = 2e-3;
    s.stick_fraction         = 0.7;
    s.max_shear_traction     = 500e6;
    s.max_von_mises          = 480e6;
    s.max_plastic_strain     = 1e-3;
    s.max_residual_von_mises = 90e6;
    s.rolled_distance        = 0.06;
    s.energy_error           = 1e-4;
    s.elements               = 64789;
    s.time_steps             = 12000;
    s.wall_time              = 19.25;
    s.ranks                  = 2;
    s.peak_memory            = 5e8;
    set_figure(s, "wheel_load_N", 101e3);
    set_figure(s, "t_gamma_N", 44.9);
    set_figure(s, "patches", 2);
    set_figure(s, "normal_force_std_N", 321);
    return s;
  }

  std::size_t
  place_of(const std::vector<std::string> &lines, const std::string &part)
  {
    return std::find_if(lines.begin(),
                        lines.end(),
                        [&](const std::string &line) { return line.find(part) != std::string::npos; }) -
           lines.begin();
  }

  /// The first line that holds `part` is this one.
  void
  check_line(const std::vector<std::string> &lines,
             const std::string              &part,
             const std::string              &expected,
             const std::string              &text)
  {
    BOOST_TEST(same_text(lines[place_of(lines, part)], expected, text));
  }
} // namespace


BOOST_AUTO_TEST_CASE(screens)
{
  Summary run = finished_run();
  for (int k = 0; k < 9; ++k)
    run.doubts +=
      (k > 0 ? " " : "") + std::string("Reason ") + std::to_string(k) + " is off by 3.2 %; do this.";
  run.note                             = "a note";
  const std::vector<std::string> lines = end_screen(run, "out put");
  BOOST_TEST((lines.size() <= 25 && lines.size() > 15), std::to_string(lines.size()) + " lines");
  BOOST_TEST(same_text(lines[1], "  verdict: with care", "the verdict comes first"));
  BOOST_TEST(
    same_text(lines[2], "    - Reason 0 is off by 3.2 %; do this.", "its reasons follow, one a line"));
  BOOST_TEST(same_text(lines[5], "    - 6 more in summary.json.", "of many reasons the first"));
  check_line(
    lines, "Y/Q", "            Y/Q                                  -0.0200", "lateral over vertical force");
  const std::vector<std::string> order = {
    "verdict", "vertical force Q", "peak pressure", "von Mises", "energy error", "next: "};
  for (std::size_t k = 1; k < order.size(); ++k)
    BOOST_TEST(
      (place_of(lines, order[k - 1]) < place_of(lines, order[k]) && place_of(lines, order[k]) < lines.size()),
      order[k] + " after " + order[k - 1]);
  BOOST_TEST((place_of(lines, "_std_") == lines.size() && place_of(lines, "nan") == lines.size()),
             "no raw keys, no missing figures");
  BOOST_TEST(
    same_text(lines.back(),
              "  next: ./wheelrail compare \'out put\' (against half-spaces), ./wheelrail report \'out put\' "
              "(pictures and a page)",
              "what to do next"));

  BOOST_TEST((place_of(lines, "impact") == lines.size()), "nothing of impacts where surfaces are smooth");
  set_figure(run, "largest_vertical_force_N", 242.4e3);
  set_figure(run, "largest_vertical_force_at_m", 72.3e-3);
  set_figure(run, "impact_factor", 2.348);
  set_figure(run, "von_mises_on_way_Pa", 1461.1e6);
  set_figure(run, "von_mises_on_way_at_m", 76.1e-3);
  set_figure(run, "axle_acceleration_up_m_per_s2", 305.5);
  set_figure(run, "axle_acceleration_down_m_per_s2", 237.6);
  const std::vector<std::string> irregular = end_screen(run, "out");
  check_line(irregular,
             "largest vertical force",
             "  impact    largest vertical force                242.40 kN at 72.3 mm",
             "a run over irregular surfaces says the largest force and where it acts");
  check_line(irregular,
             "at 76.1 mm",
             "            largest von Mises stress              1461.1 MPa at 76.1 mm",
             "and the largest stress of the whole way");
  check_line(irregular,
             "axle box",
             "            acceleration of the axle box    -237.6 to 305.5 m/s2",
             "and how the axle box is shaken");

  set_figure(run, "foot_deflection_m", 0.512e-3);
  set_figure(run, "largest_pad_force_N", 41.23e3);
  const std::vector<std::string> on_pads = end_screen(run, "out");
  check_line(on_pads,
             "foot sinks",
             "  track     rail's foot sinks                      0.512 mm",
             "how far the foot sinks on its pads");
  check_line(on_pads,
             "force of a pad",
             "            largest force of a pad                 41.23 kN",
             "and what they carry");

  Summary halfspaces = finished_run();
  set_figure(halfspaces, "contact_angle_rad", 47.7e-3);
  set_figure(halfspaces, "archard_depth_m", 17.345e-9);
  set_figure(halfspaces, "reference_lateral_m", 4.2e-3);
  const std::vector<std::string> still = halfspace_screen(halfspaces);
  BOOST_TEST((still.size() <= 30 && still.size() > 12),
             std::to_string(still.size()) + " lines of half-spaces");
  BOOST_TEST(same_text(still[0], "a run", "half-spaces begin with the title, too"));
  BOOST_TEST(same_text(still[1], "  verdict: with care", "and their verdict"));
  check_line(still,
             "contact angle",
             "  position  contact angle                          47.70 mrad",
             "and how their plane lies");
  BOOST_TEST((place_of(still, "wear depth") < still.size() && place_of(still, "reference") == still.size()),
             "the wear of a passage, and no reference point");

  Summary stopped;
  stopped.stop_reason                 = "interrupted";
  const std::vector<std::string> part = end_screen(stopped, "out");
  BOOST_TEST(same_text(part[0], "  verdict: not trusted", "a run that did not finish is not trusted"));
  BOOST_TEST(
    same_text(part[1], "    - It did not finish: interrupted; this is what it has.", "and says what it has"));
  BOOST_TEST(
    same_text(part.back(), "  next: ./wheelrail report out (pictures and a page)", "it cannot be compared"));
}
