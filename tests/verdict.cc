// label: fast

// The verdict on a finished run and on old summaries: rules, grades, words.

#include <wheelrail/input/parameters.h>
#include <wheelrail/verdict/agreement.h>
#include <wheelrail/verdict/verdict.h>

#include "good_measures.h"
#include "near.h"

#include <cmath>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  /// One measure at a value, and what is then said.
  void
  test_rule(double Measures::*const measure, const double value, const Grade grade, const std::string &part)
  {
    Measures m            = good();
    m.*measure            = value;
    const Verdict verdict = judge_run(Scene(), m);
    BOOST_TEST((verdict.grade() == grade), "\"" + part + "\": " + grade_word(verdict.grade()));
    holds(verdict.doubts(), part, "what is off");
    BOOST_TEST((grade == Grade::trusted || verdict.findings.size() == 1), "it alone is told");
  }

  BOOST_AUTO_TEST_CASE(test_rules)
  {
    BOOST_TEST(judge_run(Scene(), good()).findings.empty(), "the main scene is trusted");
    const Grade care = Grade::with_care, no = Grade::not_trusted;
    test_rule(
      &Measures::cells,
      6.4,
      care,
      "Too few cells: 6.4 of 1 mm lie across the patch, and leave the peak pressure uncertain by 7.7 %; "
      "take Mesh/Solution cell size = 0.5 mm.");
    test_rule(&Measures::cells, 4.5, no, "leave the peak pressure uncertain by 14.2 %");
    test_rule(
      &Measures::cells, 2.1, no, "2.1 of 1 mm lie across the patch; take Mesh/Solution cell size = 0.25 mm.");
    test_rule(
      &Measures::cells_across_peak, 3.2, care, "3.2 of 1 mm lie across the highest pressure, and leave");
    test_rule(&Measures::cells_across_peak,
              2.3,
              no,
              "2.3 of 1 mm lie across the highest pressure; take Mesh/Solution cell size = 0.5 mm.");
    test_rule(&Measures::cells_across_peak,
              2.99,
              no,
              "3.0 of 1 mm lie across the highest pressure; take Mesh/Solution cell size = 0.5 mm.");
    test_rule(
      &Measures::between_nodes,
      0.019,
      care,
      "lie across the patch, its peak between two nodes, and leave the peak pressure uncertain by 6.7 %; "
      "take Mesh/Solution cell size = 0.5 mm.");
    test_rule(&Measures::beside,
              0.04,
              care,
              "The true bodies carry 4.0 % of the load beside the patch of the run, whose solution cells may "
              "end there; take Mesh/Fine margin = 23 mm.");
    test_rule(&Measures::penetration,
              0.04,
              care,
              "The penalty contact, which sinks in by 4.0 % of the approach, and the cells leave the peak "
              "pressure uncertain by 8.1 %; raise Contact/Penalty scale.");
    test_rule(&Measures::penetration, 0.08, no, "uncertain by 14.2 %");
    test_rule(&Measures::unsteadiness, 0.009, Grade::trusted, "");
    test_rule(&Measures::unsteadiness, 0.03, care, "The forces vary by 3.0 % of the load");
    test_rule(&Measures::unsteadiness, 0.085, no, "The forces vary by 8.5 % of the load");
    test_rule(&Measures::unsteadiness,
              std::nan(""),
              no,
              "The forces vary by"); // a value that is no number is doubted
    test_rule(&Measures::pressure_noise, 0.075, care, "The peak pressure fluctuates by 7.5 %");
    test_rule(&Measures::pressure_noise, 0.15, no, "The peak pressure fluctuates by 15.0 %");
    test_rule(&Measures::swing, 0.3, no, "Creepage fluctuates by 30.0 % in the means over 2 mm");
    test_rule(&Measures::drift, 0.03, care, "Contact area still changes, by 3.0 %");
    test_rule(&Measures::drift, 0.069, no, "Contact area still changes, by 6.9 %");
    test_rule(&Measures::settled_after, 50e-3, care, "Not all results have come within 1 %");
    test_rule(&Measures::energy_error, 0.007, care, "The energy balance is off by 0.7 %");
    test_rule(&Measures::energy_error, 0.015, no, "The energy balance is off by 1.5 %");
    test_rule(&Measures::load_miss, -0.02, care, "The mean vertical force is 2.0 % below the wheel load");
    test_rule(&Measures::torque_miss, -0.02, care, "The longitudinal force is off by 2.0 %");
    test_rule(
      &Measures::torque_miss, -0.11, no, "The longitudinal force is off by 11.0 % from what the torque");
    test_rule(&Measures::force_difference, 0.019, Grade::trusted, "");
    test_rule(
      &Measures::force_difference,
      -0.03,
      care,
      "The longitudinal force is 3.0 % of the load below that of the true bodies with the same creepage");
    test_rule(&Measures::force_difference, 0.1, no, "The longitudinal force is 10.0 % of the load above");
    test_rule(&Measures::peak_difference, -0.07, care, "The peak pressure is 7 % below that of half-spaces");
    test_rule(&Measures::peak_difference, 0.12, no, "do not explain it");
    test_rule(&Measures::edge_on_path, 20e-3, care, "The largest pressure of the path does not hold");
    test_rule(&Measures::edge, 20e-3, care, "The peak pressure does not hold, forces do");
    test_rule(
      &Measures::peak_pressure, 6.1e9, no, "The peak pressure of 6.1 GPa is more than any rail steel bears");
  }

  /// Cells and penalty are judged whatever half-spaces know of the scene.
  BOOST_AUTO_TEST_CASE(test_without_reference)
  {
    Measures m        = good();
    m.plastic_strain  = 2.9e-3;
    m.peak_difference = -0.123;
    Verdict verdict   = judge_run(Scene(), m);
    BOOST_TEST(verdict.findings.empty(), "yielding is no fault");
    BOOST_TEST(same_text(
      verdict.limits, "steel has yielded (plastic strain up to 2.9e-3)", "and takes the reference away"));
    BOOST_TEST(same_text(
      difference_of_models(m, verdict),
      "the peak pressure is 12 % below that of half-spaces under the same force and in the same position: "
      "the half-space solution is not a reliable reference here, since steel has yielded (plastic strain up "
      "to 2.9e-3)",
      "which is said"));
    m.cells_across_peak = 1.3;
    BOOST_TEST((judge_run(Scene(), m).grade() == Grade::not_trusted), "cells are judged where steel flows");
    m.plastic_strain = 0;
    m.turn           = 0.5;
    verdict          = judge_run(Scene(), m);
    BOOST_TEST((verdict.grade() == Grade::not_trusted), "and where the surfaces turn");
    BOOST_TEST(
      same_text(verdict.limits, "the surfaces turn by 29 degrees across the patch", "with the limit"));
    m.turn    = 0.1;
    m.patches = 2;
    verdict   = judge_run(Scene(), m);
    BOOST_TEST(verdict.findings.size() == 1, "cells, with two patches");
    BOOST_TEST(same_text(verdict.limits, "the run has 2 patches", "with the limit"));
    m              = good();
    m.no_reference = "the peak pressure could not be held against half-spaces: no contact";
    BOOST_TEST((judge_run(Scene(), m).grade() == Grade::with_care), "without a reference care is needed");
  }

  /// The wear of the main scene and of the quick start, whose sections are 15 and 34 % larger than those of
  /// half-spaces, and of a patch of which all slides.
  BOOST_AUTO_TEST_CASE(test_wear)
  {
    Scene   scene;
    Summary run;
    run.patch_longitudinal = 12.9e-3;
    run.stick_fraction     = 0.712;
    scene.cell_size        = 1e-3;
    holds(wear_doubt(scene, run), "Wear is with care: 3.7 cells of 1 mm lie across", "main scene");
    scene.cell_size = 2e-3;
    holds(wear_doubt(scene, run), "Wear is not trusted: 1.9 cells of 2 mm lie across", "quick start");
    scene.cell_size    = 1e-3;
    run.stick_fraction = 0;
    BOOST_TEST(same_text(wear_doubt(scene, run), "", "wear of a patch that slides"));
    scene.traction_coefficient = 0.25;
    holds(measures_of_run(scene, run).slides, "the wheel spins up", "friction does not carry the torque");
    set_figure(run, "torque_miss", 0.01);
    holds(measures_of_run(scene, run).slides, "friction just carries", "it does, across the track under yaw");
  }

  /// Over irregular surfaces: means where the wheel flies, and a force that still rises at the end.
  BOOST_AUTO_TEST_CASE(test_way)
  {
    Scene scene;
    scene.irregularities[0].kind = IrregularKind::dent;
    scene.support.kind           = RailSupport::sleepers;
    scene.rail_length            = 8;
    Summary run;
    run.patch_lateral = run.patch_longitudinal = 12e-3;
    run.max_pressure = run.max_pressure_fitted = 1e9;
    run.energy_error                           = 1e-3;
    run.vertical_force                         = 120e3;
    run.rolled_distance                        = 0.12;
    set_figure(run, "wheel_load_N", 80e3);
    set_figure(run, "largest_vertical_force_at_m", 0.072);
    set_figure(run, "cells_across_peak", 6);
    BOOST_TEST(
      same_text(judge_run(scene, measures_of_run(scene, run)).doubts(), "", "a run over a dent is trusted"));
    set_figure(run, "largest_vertical_force_at_m", 0.1198);
    BOOST_TEST(
      same_text(judge_run(scene, measures_of_run(scene, run)).doubts(),
                "The largest vertical force acts at the end of the path, 119.8 mm, so that a larger one may "
                "come behind it; roll farther (Run/Rolling distance).",
                "a force that still rises"));
    set_figure(run, "largest_vertical_force_at_m", 0.072);
    Summary crossing = run;
    set_figure(crossing, "second_rail_force_at_m", 0.1199);
    BOOST_TEST(same_text(
      judge_run(scene, measures_of_run(scene, crossing)).doubts(),
      "The largest vertical force on the second rail acts at the end of the path, 119.9 mm, so that a "
      "larger one may come behind it; roll farther (Run/Rolling distance).",
      "a force that still rises on one of two rails"));
    set_figure(crossing, "second_rail_force_at_m", 0.1);
    BOOST_TEST(
      same_text(judge_run(scene, measures_of_run(scene, crossing)).doubts(), "", "one that has fallen"));
    Summary two       = run;
    two.patch_lateral = 72e-3;
    set_figure(two, "patches", 2);
    BOOST_TEST(
      near(measures_of_run(scene, two).cells, 6, 0, "cells of the patch with the peak, not of two together"));
    run.vertical_force     = 0.8e3;
    run.patch_longitudinal = 0;
    const Verdict verdict  = judge_run(scene, measures_of_run(scene, run));
    BOOST_TEST(same_text(
      verdict.doubts(),
      "The wheel carries 1.0 % of its load where the means are taken: it is off the rail there, and "
      "they say nothing of the contact; take Run/Evaluate at = largest force.",
      "a wheel off the rail, and nothing of its cells"));
    BOOST_TEST((verdict.grade() == Grade::with_care), "is no fault of the run");

    set_figure(run, "largest_vertical_force_at_m", 0.072);
    run.vertical_force     = 120e3;
    run.patch_longitudinal = 12e-3;
    scene.support.kind     = RailSupport::clamped_foot;
    const Verdict clamped  = judge_run(scene, measures_of_run(scene, run));
    BOOST_TEST(
      same_text(clamped.doubts(),
                "The rail's foot is clamped: the largest force may be twice that of a rail on sleepers; take "
                "Track/Support = sleepers, as prm/sleepers.prm does.",
                "an impact on a clamped foot"));
    BOOST_TEST((clamped.grade() == Grade::with_care), "is never trusted");
    scene.irregularities[0].kind = IrregularKind::none;
    BOOST_TEST(judge_run(scene, good()).findings.empty(), "a smooth surface on it is");
    scene.support.kind = RailSupport::sleepers;
    scene.rail_length  = 1.8;
    BOOST_TEST(
      same_text(judge_run(scene, good()).doubts(),
                "The rail of 1.8 m is short for its support: its free ends make it sink and tilt more than a "
                "long one; take Track/Rail length = 3.1 m.",
                "a short rail on sleepers"));
  }

  BOOST_AUTO_TEST_CASE(test_words)
  {
    Measures m     = good();
    m.made_up      = "the wheel's flange tip";
    m.place        = place_in_words(0.0312);
    m.energy_error = 0.007;
    Summary summary;
    summary.finished = true;
    set_verdict(summary, judge_run(Scene(), m));
    BOOST_TEST(same_text(verdict_of(summary), "not trusted", "the lowest grade counts"));
    holds(verdict_line(summary),
          "verdict: not trusted: The patch, 31.2 mm from the running circle to the gauge side, lies on the "
          "wheel's "
          "flange tip, which no file holds",
          "worst first, with its place");
    holds(summary.doubts, " The energy balance is off", "then the others");
    BOOST_TEST((grade_of(summary) == Grade::not_trusted), "read back as a grade");
    summary.finished = false;
    BOOST_TEST(same_text(
      verdict_line(summary).substr(0, 43), "verdict: not trusted: it did not finish", "what did not finish"));

    // summaries of before there were three words
    Summary old;
    old.finished = true;
    BOOST_TEST((grade_of(old) == Grade::trusted), "an old summary without doubts");
    old.doubts = "the energy balance is off.";
    BOOST_TEST((grade_of(old) == Grade::not_trusted), "an old summary with doubts");
  }

  BOOST_AUTO_TEST_CASE(test_agreement)
  {
    const auto has = [](const Measures &m, const std::string &part) {
      holds(agreement_sentence(Scene(), m, judge_run(Scene(), m)), part, "agreement");
    };
    Measures m = good();
    has(m,
        "The run agrees with the half-spaces within 1.5 % in peak pressure: 12.8 cells of 1 mm lie over the");
    m.peak_difference = -0.04;
    has(m, "The run differs from the half-spaces by 4.0 % in peak pressure");
    m       = good();
    m.cells = 6.4;
    has(m, "by 1.5 % in peak pressure, which may be chance");
    m.plastic_strain = 2.9e-3;
    m.turn           = 0.5;
    has(
      m,
      "The half-space solution is not a reliable reference here, since steel has yielded (plastic strain up "
      "to 2.9e-3) "
      "and the "
      "surfaces turn by 29 degrees");
    m.bodies_difference = -0.031;
    has(m, "The half-space solution is not a reliable reference here, since steel has yielded");
    m.plastic_strain = 0;
    has(m,
        "The run differs from the true bodies by 3.1 % in peak pressure, from half-spaces, which are no "
        "reference here "
        "since the surfaces turn by 29 degrees across the patch, by 1.5 %");
    m.bodies_difference = -0.3;
    BOOST_TEST(
      (judge_run(Scene(), m).doubts().find("30 % below that of the true bodies under the same forces") !=
       std::string::npos),
      "true bodies judge where half-spaces cannot");
    m        = good();
    m.beyond = {"creepage by +6.20 % (limit 5 % or 0.15 1e-3)", "contact area by -7.00 % (limit 5 %)"};
    has(
      m,
      " Beyond their limits: creepage by +6.20 % (limit 5 % or 0.15 1e-3), contact area by -7.00 % (limit 5 "
      "%).");
    BOOST_TEST(judge_run(Scene(), m).findings.empty(), "which the verdict leaves to the reader");
    m       = good();
    m.cells = 2;
    BOOST_TEST(
      (agreement_sentence(Scene(), m, judge_run(Scene(), m)).find("Of the difference") == std::string::npos),
      "no rule of parts is known for so few cells");
    // the parts of doc/manual/compare.md: 13 cells, f = 10
    BOOST_TEST(near(good().penalty_part(), -0.0067, 2e-4, "what the penalty contact takes from the peak"));
    BOOST_TEST(near(good().mesh_part(), -0.0079, 2e-4, "what the cells take"));
    BOOST_TEST(near(good().lost(), 0.0146, 2e-4, "and both, as bodies confirm it"));
  }

  /// Elastic bodies beyond the shakedown of their steel: of the weaker, of the given yield stress, of the
  /// hardest listed.
  BOOST_AUTO_TEST_CASE(test_steels)
  {
    const auto doubt = [](const std::vector<std::string> &settings,
                          const double                    peak,
                          const double                    traction,
                          const bool                      computed = false) {
      return steel_doubt(scene_from_text("", "x.prm", settings).scene, peak, traction, computed);
    };
    holds(doubt({}, 2421e6, 0), "R350HT, the hardest listed, 1764 MPa", "no steel is named");
    BOOST_TEST(doubt({}, 1300e6, 0.25).empty(), "the main scene is below");
    // 4 k, k = 0.55 880 MPa/sqrt(3)
    holds(doubt({"Rail material/Steel = R260"}, 1200e6, 0), "of R260 1118 MPa at a traction of 0.00", "R260");
    BOOST_TEST(doubt({"Rail material/Steel = R260"}, 1100e6, 0).empty(), "R260 below its limit");
    holds(
      doubt({"Rail material/Steel = R260"}, 1000e6, 0.25), "of R260 851 MPa", "traction lowers the limit");
    holds(doubt({"Rail material/Steel = R350HT", "Wheel material/Steel = ER7"}, 1300e6, 0),
          "of ER7",
          "the wheel");
    holds(doubt({"Rail material/Steel = R200", "Rail material/Yield stress = 600 MPa"}, 1500e6, 0),
          "of a yield stress of 600 MPa 1386 MPa",
          "a given yield stress goes before the name");
    BOOST_TEST(
      doubt({"Rail material/Steel = R200", "Rail material/Yield stress = 600 MPa"}, 1500e6, 0, true).empty(),
      "a run computes it");
    Measures m       = good();
    m.plastic_strain = 4.2e-3;
    BOOST_TEST((judge_run(Scene(), m).grade() == Grade::trusted), "plastic strain on 12.8 cells");
    m.cells = 9.5;
    holds(
      judge_run(Scene(), m).doubts(), "about 26 % below that of the steel", "plastic strain on 9.5 cells");
    m.cells = 2;
    holds(judge_run(Scene(), m).doubts(), " mm, far below that of the steel", "plastic strain on 2 cells");
    m        = good();
    m.yields = "this steel yields.";
    BOOST_TEST((judge_run(Scene(), m).grade() == Grade::with_care), "a run is then with care");
    BOOST_TEST((judge_halfspaces(m).grade() == Grade::with_care), "and half-spaces are");
  }
} // namespace
