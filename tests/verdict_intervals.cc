// label: fast

// Intervals of results and what the verdict makes of them; a run judged as at its end.

#include <wheelrail/bodies/run_intervals.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/run/run_end.h>
#include <wheelrail/sampling/creep_scale.h>
#include <wheelrail/verdict/verdict.h>

#include "good_measures.h"
#include "near.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

using namespace wheelrail;
using namespace test;

namespace
{
  /// Intervals reach as far as Run/Wanted accuracy says.
  BOOST_AUTO_TEST_CASE(test_intervals)
  {
    const auto judged = [](const Known &known, const double wanted) {
      Measures m        = good();
      m.wanted          = wanted;
      m.peak            = known;
      m.peak_difference = 0;
      return judge_run(Scene(), m);
    };
    BOOST_TEST(same_text(judged({0.07, "measured input"}, 0.05).doubts(),
                         "The noise in measured points leaves the peak pressure uncertain by 7.0 %; "
                         "take points with less noise, more digits or no gaps.",
                         "noise"));
    BOOST_TEST(judged({0.07, "measured input"}, 0.07).findings.empty(), "what was wanted");
    BOOST_TEST((judged({0.07, "measured input"}, 0.03).grade() == Grade::not_trusted),
               "more than twice of it");
    holds(judged({INFINITY, "measured input"}, 0.05).doubts(), "uncertain by an unknown part", "no bound");
    BOOST_TEST(
      same_text(judged({0.02, "cells and penalty layer"}, 0.01).doubts(),
                "Too few cells: 12.8 of 1 mm lie across the patch, and leave the peak pressure uncertain by "
                "2.0 %; take Mesh/Solution cell size = 0.5 mm.",
                "cells"));
    BOOST_TEST(judged({0.04, "cells and penalty layer"}, 0.05).findings.empty(),
               "an interval within what is wanted");
    Measures slow = good();
    slow.creep    = {0.14, "noise and trend"};
    BOOST_TEST(same_text(judge_run(Scene(), slow).doubts(),
                         "Noise and trend leave creepage or T-gamma uncertain by 14.0 %; roll until steady "
                         "(Run/Rolling distance = until steady).",
                         "T-gamma of the quick start"));
    BOOST_TEST((judge_run(Scene(), slow).grade() == Grade::with_care), "the peak is known");
    const Contributions causes{{"max_pressure", "cells", 10, 0},
                               {"max_pressure", "elements", -2, 3},
                               {"max_pressure", "noise", 0, 4},
                               {"contact_area", "noise", 0, INFINITY}};
    const Interval      interval = interval_of("max_pressure", 100, causes);
    BOOST_TEST(near(interval.low, 100, 1e-12, "shifts of 8 add up, and the value lies within"));
    BOOST_TEST(near(interval.high, 113, 1e-12, "spreads of 3 and 4 by their squares"));
    BOOST_TEST(near(
      interval_of("max_pressure", 100, {{"max_pressure", "cells", 1, 5}}).low, 96, 1e-12, "the other side"));
    BOOST_TEST((interval_of("t_gamma", 1, {{"t_gamma", "noise", 0, 2}}).low == 0), "friction gives no work");
    BOOST_TEST((interval_of("stick_fraction", 0.9, {{"stick_fraction", "noise", 0, 0.2}}).high == 1),
               "nor more than all sticks");
    BOOST_TEST((known_within("max_pressure", 100, 1, causes).cause == "cells"), "the largest cause");
    BOOST_TEST(near(known_within("max_pressure", 100, 1, causes).within, 0.13, 1e-12, "the farther side"));
    BOOST_TEST(std::isnan(interval_of("contact_area", 1, causes).low),
               "no number where a cause has no bound");
    BOOST_TEST(std::isinf(known_within("contact_area", 1, 1, causes).within), "and it is known badly");
    BOOST_TEST(std::isnan(known_within("creepage", 1, 1, causes).within), "of which no cause is known");
    const Contributions wide{{"max_pressure", "elements", 0, 4.9e8},
                             {"contact_area", "elements", 0, 6e-5},
                             {"creepage", "elements", 0, 1e-4}};
    Summary             sizes;
    sizes.max_pressure = 1e9;
    sizes.contact_area = 1e-4;
    sizes.creepage     = 1e-5;
    set_intervals(wide, sizes);
    BOOST_TEST(
      same_text(shown_interval(sizes, "max_pressure"), "510.0 to 1490.0", "an interval as wide as the peak"));
    BOOST_TEST(
      same_text(shown_interval(sizes, "contact_area"), "", "of an area that is narrower there is none"));
    BOOST_TEST(!shown_interval(sizes, "creepage").empty(), "a creepage may be nought");
    BOOST_TEST(near(
      known_within("contact_area", 1e-4, 1e-9, wide).within, 0.6, 1e-9, "how far it is off is known still"));
  }

  /// Results that err with a power of the cells: the end they tend to lies in the interval.
  BOOST_AUTO_TEST_CASE(test_two_meshes)
  {
    Summary run, coarser;
    run.max_pressure           = 1200 - 1;
    coarser.max_pressure       = 1200 - 4; // second order
    run.max_plastic_strain     = 4e-3 - 1e-3;
    coarser.max_plastic_strain = 4e-3 - 2e-3; // first
    run.creepage = coarser.creepage = 2e-3;
    run.patch_lateral = coarser.patch_lateral = 14e-3;
    Scene               rate;
    const Contributions causes = two_mesh_contributions(rate, run, coarser, 1e9);
    const auto          shift  = [](const Contributions &contributions, const std::string &name) {
      double sum = 0;
      for (const Contribution &one : contributions)
        sum += one.result == name ? one.shift : 0;
      return sum;
    };
    BOOST_TEST(near(shift(causes, "max_pressure"), 1, 1e-9, "the second order ends there"));
    BOOST_TEST(near(shift(causes, "max_plastic_strain"), 1e-3, 1e-12, "and the first"));
    const Interval strain = interval_of("max_plastic_strain", run.max_plastic_strain, causes);
    BOOST_TEST(near(strain.low, 3e-3, 1e-11, "from the run"));
    BOOST_TEST(near(strain.high, 5e-3, 1e-11, "to the change beyond the end"));
    const Contributions few = two_mesh_contributions(rate, run, coarser, 10);
    BOOST_TEST(
      near(interval_of("creepage", 2e-3, few).high, 2.1e-3, 1e-9, "two that agree may do so by chance"));
    BOOST_TEST(near(interval_of("patch_lateral", 14e-3, few).high,
                    15.26e-3,
                    1e-9,
                    "of a width by a cell: nodes are in or out"));
    rate.drive = Drive::rate;
    BOOST_TEST(std::isnan(interval_of("creepage", 2e-3, two_mesh_contributions(rate, run, coarser, 10)).low),
               "a creepage that is given has no error");
    BOOST_TEST(!std::isfinite(interval_of("lateral_force", 0, few).low), "nor what neither run has");
  }

  /// Cells see less of the stress below them: true bodies, which are solved for the surface, do not tell it.
  BOOST_AUTO_TEST_CASE(test_stress_below)
  {
    Summary run;
    set_figure(run, "von_mises_below_cell_Pa", 6e8);
    Measures m = good();
    m.cells    = 6;
    const Contributions bodies =
      run_contributions(Scene(), run, m, {}, {{"max_pressure", "cells and penalty layer", 1e7, 1e6}}, {});
    const Interval stress = interval_of("von_mises_below_cell", 6e8, bodies);
    BOOST_TEST(near(stress.low, 5.9e8, 1, "a tenth over n below"));
    BOOST_TEST(near(stress.high, 7.7e8, 1, "to 1.7/n above"));
  }

  /// Plastic strain has an estimate where enough cells lie across the patch; the area lies too high, the
  /// width, too; creepage and T-gamma near nought have the error of a quarter of half saturation.
  BOOST_AUTO_TEST_CASE(test_yielding)
  {
    Summary run;
    run.max_pressure       = 1e9;
    run.max_plastic_strain = 4e-3;
    run.contact_area       = 1e-4;
    run.patch_lateral = run.patch_longitudinal = 12e-3;
    run.normal_force                           = 1e5;
    run.lateral_force                          = 5e3;
    run.longitudinal_force                     = 25e3;
    run.creepage                               = 2e-3;
    run.stick_fraction                         = 0.97;
    const double t_gamma                       = 50;
    set_figure(run, "t_gamma_N", t_gamma);
    Scene scene;
    scene.cell_size  = 1.5e-3;
    Measures m       = good();
    m.plastic_strain = 4e-3;
    for (const auto &[cells, high, known] :
         {std::tuple<double, double, const char *>{
            10, 5.4e-3, "area, extents, creep, plastic strain and residual stress by"},
          {5, std::nan(""), "Intervals: peak pressure, area, extents, creep by estimate"}})
      {
        m.cells                    = cells;
        const Contributions causes = run_contributions(scene, run, m, {}, {}, {});
        const Interval      strain = interval_of("max_plastic_strain", run.max_plastic_strain, causes);
        BOOST_TEST((std::isnan(high) ? std::isnan(strain.high) : std::abs(strain.high - high) < 1e-9),
                   "3.5/n above the strain of n cells, of few none");
        const Interval area = interval_of("contact_area", run.contact_area, causes);
        const double   lost = 0.5 * m.lost(false) * run.contact_area;
        BOOST_TEST(near((area.low - run.contact_area) / lost, -1.75, 1e-9, "area from 1.75 L below"));
        BOOST_TEST(near((area.high - run.contact_area) / lost, 0.25, 1e-9, "to 0.25 L above"));
        const auto reaches = [&](const char *name, const double value, const double low, const double high) {
          const Interval interval = interval_of(name, value, causes);
          BOOST_TEST(near(interval.low - value, low, 1e-9 * std::abs(value), std::string(name) + " from"));
          BOOST_TEST(near(interval.high - value, high, 1e-9 * std::abs(value), std::string(name) + " to"));
        };
        reaches("patch_longitudinal", 12e-3, -0.45 * 1.5e-3, 0.45 * 1.5e-3);
        reaches("patch_lateral", 12e-3, -1.3 * 1.5e-3, 0.5 * 1.5e-3);
        reaches("lateral_force", 5e3, -0.1e5 / cells, 0.1e5 / cells);
        reaches("stick_fraction", 0.97, -0.5 / cells, 0.03);
        reaches("creepage", 2e-3, -2.2e-3 / cells, 2.2e-3 / cells);
        reaches("t_gamma", t_gamma, -1.4 * t_gamma / cells, t_gamma / cells);
        holds(without_intervals(scene, m, {}, {}), known, "what has an interval");
      }
    // near nought, and where the creepage is given: slope of the creep curve at its start
    const CreepScale patch =
      creep_scale(0.5e5, elasticity(scene.rail_material).shear_modulus(), 12e-3, 12e-3);
    run.creepage           = 1e-6;
    run.longitudinal_force = 1e-3;
    m.cells                = 10;
    const double open      = 0.11 * 0.25 * patch.half_saturation();
    BOOST_TEST(near(interval_of("creepage", 1e-6, run_contributions(scene, run, m, {}, {}, {})).high - 1e-6,
                    open,
                    1e-6 * open,
                    "a creepage near nought"));
    scene.drive               = Drive::rate;
    const Contributions given = run_contributions(scene, run, m, {}, {}, {});
    BOOST_TEST(std::isnan(interval_of("creepage", 1e-6, given).low), "a given creepage has no interval");
    BOOST_TEST(near(interval_of("longitudinal_force", 1e-3, given).high,
                    patch.stiffness * open,
                    1e-4 * patch.stiffness * open,
                    "its force has"));
  }

  /// A quiet run whose figures are those of half-spaces, judged as a run is at its end.
  BOOST_AUTO_TEST_CASE(test_run)
  {
    const SceneInput    input    = scene_from_text("", "driving", {"Wheelset/Traction coefficient = 0.25"});
    const SceneGeometry geometry = require_touching(input);
    Summary             summary;
    Contributions       causes;
    summary.finished     = true;
    summary.energy_error = 4e-4;
    for (const auto &[key, value] : {std::pair<const char *, double>{"normal_force_N", 1e5},
                                     {"vertical_force_N", 1e5},
                                     {"wheel_load_N", 1e5},
                                     {"vertical_force_std_N", 30.},
                                     {"longitudinal_force_std_N", 30.},
                                     {"max_pressure_fitted_Pa", 1.2e9},
                                     {"max_pressure_fitted_std_Pa", 1e6},
                                     {"patch_lateral_m", 20e-3},
                                     {"patch_longitudinal_m", 13e-3},
                                     {"cells_across_peak", 6.5},
                                     {"patch_centre_lateral_m", -7.3e-3},
                                     {"largest_swing", 2e-3},
                                     {"means_from_m", 40e-3},
                                     {"settled_after_m", 5e-3}})
      set_figure(summary, key, value);
    summary.max_pressure = 1.2e9;
    judge(input.scene, geometry, summary, causes);
    BOOST_TEST(near(
      get_figure(summary, "max_pressure_low_Pa"), 1.2e9, 20e6, "whose interval begins at the peak, about"));
    const auto cells = std::find_if(causes.begin(), causes.end(), [](const Contribution &one) {
      return one.result == "max_pressure" && one.cause == "cells and penalty layer";
    });
    BOOST_TEST((cells != causes.end()), "the true bodies say what the cells make of the peak");
    BOOST_TEST((std::count_if(causes.begin(),
                              causes.end(),
                              [&](const Contribution &one) {
                                return one.result == "max_pressure" && one.cause == "cells and penalty layer";
                              }) == 1),
               "once");
    const double bodies  = cells == causes.end() ? 1 : 1.2e9 + cells->shift;
    summary.max_pressure = bodies;
    BOOST_TEST((judge(input.scene, geometry, summary, causes).empty() && summary.doubts.empty()),
               "the peak of true bodies is trusted [" + summary.doubts + "]");
    BOOST_TEST(same_text(summary.verdict, "trusted", "its word"));
    set_figure(summary, "plastic_band_depth_m", 5.9e-3); // five cells of 1 mm are fine, and one more
    BOOST_TEST(judge(input.scene, geometry, summary, causes).empty(),
               "steel that flows in fine cells is no matter");
    set_figure(summary, "plastic_band_depth_m", 8.6e-3);
    const auto deep = judge(input.scene, geometry, summary, causes);
    holds(deep.empty() ? "" : deep[0],
          "steel has flowed down to 8.6 mm, below the fine cells, which are 5.0 mm deep: the depth of the "
          "plastic zone and the "
          "stresses left there are those of coarser cells; raise Mesh/Fine depth to 10 mm",
          "flow below the fine cells");
    BOOST_TEST(summary.doubts.empty(), "is said, and leaves the figures of the patch trusted");
    set_figure(summary, "plastic_band_depth_m", std::nan(""));
    summary.max_pressure = 0.7 * bodies;
    BOOST_TEST(judge(input.scene, geometry, summary, causes).empty(), "a peak 30 % lower is told once");
    holds(summary.doubts, "The peak pressure is 30 % below", "and written into the summary");
    BOOST_TEST(same_text(summary.verdict, "not trusted", "its word"));
    summary.max_pressure = bodies;
    set_figure(summary, "settled_after_m", std::nan("")); // null in the file: never
    judge(input.scene, geometry, summary, causes);
    BOOST_TEST(same_text(summary.verdict, "with care", "figures that never settle"));
  }
} // namespace
