// label: fast

// The verdict on half-spaces: elements, edges, parts that no file holds, true bodies that judge them.

#include <wheelrail/geometry/made_up_part.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/verdict/verdict.h>

#include "near.h"

#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  /// Parts of a profile that no file holds: where a measured head is joined to a standard body.
  BOOST_AUTO_TEST_CASE(test_made_up)
  {
    const SceneInput input = scene_from_text(
      "", "worn", {"Profiles/Rail = " + std::string(WHEELRAIL_TEST_DIR) + "/profiles/worn_54E1.prr"});
    const SceneGeometry geometry = require_touching(input);
    const Curve        &head     = geometry.rail.head;
    const auto          part_at  = [&](const double t) {
      return made_up_part(geometry, geometry.contact.rail.to_track(head.at(t).position));
    };
    std::vector<double> joined;
    for (std::size_t k = 0; k < head.segments().size(); ++k)
      if (head.segments()[k].name == "joined side")
        joined.push_back(k + 0.5);
    BOOST_TEST(joined.size() == 2, "a measured head is joined on both sides");
    BOOST_TEST(same_text(part_at(joined.front()), "the joined side of the rail head", "on the field side"));
    BOOST_TEST(same_text(part_at(joined.back()), "the joined side of the rail head", "on the gauge side"));
    BOOST_TEST(
      same_text(part_at(0.5), "the joined side of the rail head", "below the joint, on the body's side"));
    BOOST_TEST(same_text(part_at(joined.front() + 1), "", "on what was measured beside it"));
    BOOST_TEST(same_text(made_up_part(geometry, geometry.contact.frame.origin), "", "at the contact point"));
    Segment tip                 = geometry.wheel.tread.segments().back();
    tip.name                    = "continued flange";
    std::vector<Segment> pieces = geometry.wheel.tread.segments();
    pieces.back()               = tip;
    TouchingProfiles changed    = geometry;
    changed.wheel.tread         = Curve(pieces);
    BOOST_TEST(same_text(made_up_part(changed, geometry.contact.wheel.to_track(point_on(tip, 0.5).position)),
                         "the continued flange of the wheel",
                         "the flange of a wheel that was cut off"));
  }

  BOOST_AUTO_TEST_CASE(test_halfspaces)
  {
    Measures m;
    m.cells         = 20;
    m.peak_pressure = 1.2e9;
    BOOST_TEST(judge_halfspaces(m).findings.empty(), "half-spaces are trusted");
    m.peak_pressure = 4.1e9;
    BOOST_TEST((judge_halfspaces(m).grade() == Grade::not_trusted), "but for pressures that no steel bears");
    m.peak_pressure = 1.2e9;
    m.element       = 0.4e-3;
    m.peak          = {0.065, "elements"};
    BOOST_TEST(
      same_text(judge_halfspaces(m).doubts(),
                "Too few elements: they leave the peak pressure uncertain by 6.5 %; take Half-space/Element "
                "size = 0.35 mm.",
                "few elements"));
    m.peak.within = 0.03;
    m.creep       = {0.12, "elements"};
    BOOST_TEST(same_text(judge_halfspaces(m).doubts(),
                         "Too few elements: they leave creepage and creep forces uncertain by 12.0 %; take "
                         "Half-space/Element size = 0.16 mm.",
                         "few elements for creep"));
    BOOST_TEST((judge_halfspaces(m).grade() == Grade::not_trusted), "more than twice of what is wanted");
    m.creep.within = 0.04;
    m.slides       = sliding_note(1, false);
    BOOST_TEST((judge_halfspaces(m).grade() == Grade::with_care), "a patch that slides as a whole");
    m.slides.clear();
    m.contact_modulus = 115.4e9;
    m.edge            = 32.6e-3;
    BOOST_TEST(same_text(
      judge_halfspaces(m).doubts(),
      "The peak pressure does not hold, forces do: in the patch lies an edge of 32.6 mrad, where elastic "
      "pressure has no bound: each halving of the elements adds 415 MPa; round the edge.",
      "an edge"));
    BOOST_TEST((judge_halfspaces(m).grade() == Grade::not_trusted), "under which no pressure is trusted");
    m.edge  = 0.5e-3;
    m.notch = 10e-3;
    BOOST_TEST(same_text(
      judge_halfspaces(m).doubts(),
      "In the patch lies a sharp notch of 10 mrad: peak pressure is that of an edge that stays sharp; "
      "forces hold.",
      "a notch; joints of profiles that are rounded numbers are none"));
    m.notch = 0;
    m.turn  = 0.51;
    BOOST_TEST(same_text(
      judge_halfspaces(m).doubts(),
      "The surfaces turn by 29 degrees across the contact, as in the flange root, which half-spaces "
      "do not know: the peak pressure may be off by 10 % and more.",
      "the flange root, without advice of true bodies that were not solved"));
    m.unheld                 = "Rail 'groove' is a crown without sides: give a head with its sides.";
    const std::string doubts = judge_halfspaces(m).doubts();
    BOOST_TEST(
      (doubts.find("10 % and more.") != std::string::npos && doubts.find("sides..") == std::string::npos),
      "no advice of true bodies that have no answer: " + doubts);
    m.unheld.clear();
    m.turn         = 0.1;
    m.shift_effect = 0.2;
    BOOST_TEST(judge_halfspaces(m).findings.empty(), "a peak that hardly depends on the shift");
    m.bodies_effect = 0.21;
    BOOST_TEST(same_text(
      judge_halfspaces(m).doubts(),
      "The peak pressure is 21 % above that of the true bodies, whose head and rim turn and move under "
      "these forces, which half-spaces do not include; take Half-space/Bodies = real.",
      "half-spaces that a lateral force would move"));
    m.peak          = {0.0005, "elements"};
    m.bodies_effect = -0.049;
    m.unheld        = "Half-space/Lateral offset = 0.1 mm: a position given by hand";
    BOOST_TEST(same_text(
      judge_halfspaces(m).doubts(),
      "True bodies do not confirm these half-spaces: Half-space/Lateral offset = 0.1 mm: a position "
      "given by hand.",
      "half-spaces that nothing confirms"));
    m.unheld.clear();
    BOOST_TEST((judge_halfspaces(m).grade() == Grade::trusted), "half-spaces within 5 % of the true bodies");
    m.peak = {0.02, "measured input"};
    BOOST_TEST(same_text(
      judge_halfspaces(m).doubts(),
      "The peak pressure is 4.9 % below that of the true bodies, and noise in measured points leaves 2.0 % "
      "of it open; take Half-space/Bodies = real.",
      "half-spaces that are trusted for neither cause alone"));
    m.peak = {0.006, "elements"};
    BOOST_TEST(same_text(
      judge_halfspaces(m).doubts(),
      "The peak pressure is 4.9 % below that of the true bodies, and the elements leave 0.6 % of it "
      "open; take Half-space/Bodies = real.",
      "the main scene by half-spaces"));
    m.bodies_effect = 0.04;
    m.shift_effect  = 0.68;
    BOOST_TEST(
      same_text(judge_halfspaces(m).doubts(),
                "The peak pressure changes by 68 % within the lateral shift by which wheel and rail give way "
                "under this load (0.2 mm per 100 kN to either side), which half-spaces do not include; take "
                "Half-space/Bodies = real.",
                "one that does"));
  }
} // namespace
