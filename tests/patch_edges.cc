// label: fast

// What no elements resolve, and how the verdict knows: edges in the patch, under which pressure grows without
// bound, patches that slide as a whole, elements that are too large for creep,
// cells whose nodes miss the peak.

#include "near.h"

#include <wheelrail/input/parameters.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/sampling/patch_measures.h>
#include <wheelrail/wheel/given_distance.h>
#include <wheelrail/wheel/irregular_places.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;

namespace
{
  std::vector<PlaceContact>
  places(std::vector<std::string> sets, const std::string &element, const std::vector<double> &at)
  {
    sets.push_back("Half-space/Element size = " + element);
    sets.push_back("Wheelset/Traction coefficient = 0");
    const SceneInput    input    = scene_from_text("", "x.prm", sets);
    const SceneGeometry geometry = require_computable(input);
    return solve_places(input.scene, geometry, 103e3, {false, at});
  }

  /// A fresh flat of 30 mm turns the surface by 15 mm/R at each edge. Under a wedge pressure grows by E* edge
  /// ln 2/(2 pi) where elements are halved (Johnson 1985, equation 5.4).
  BOOST_AUTO_TEST_CASE(test_flat)
  {
    const std::vector<std::string> sets{
      "Irregularity 1/Kind = flat", "Irregularity 1/Place = 45 mm", "Irregularity 1/Length = 30 mm"};
    const auto coarse = places(sets, "0.4 mm", {0.020, 0.034, 0.045}), fine = places(sets, "0.2 mm", {0.034});
    const Scene  scene;
    const double growth = contact_modulus(scene) * 0.015 / 0.46 * std::log(2.) / (2 * M_PI);
    BOOST_TEST(
      near((fine[0].peak_pressure - coarse[1].peak_pressure) / growth, 1, 0.05, "growth at an edge"));
    BOOST_TEST((coarse[0].verdict.grade() == Grade::trusted), "before the flat: trusted");
    BOOST_TEST(
      (coarse[1].verdict.grade() == Grade::not_trusted && fine[0].verdict.grade() == Grade::not_trusted),
      "on its edge: " + coarse[1].verdict.doubts());
  }

  /// Rail ends that dip leave a notch, beside which pressure is known and as sharp as the notch.
  BOOST_AUTO_TEST_CASE(test_joint)
  {
    const std::vector<std::string> sets{"Irregularity 1/Kind = dipped joint",
                                        "Irregularity 1/Place = 70 mm",
                                        "Irregularity 1/Length = 100 mm",
                                        "Irregularity 1/Angle = 10 mrad"};
    const auto                     at = places(sets, "0.4 mm", {0.060, 0.068});
    BOOST_TEST((at[0].verdict.grade() == Grade::trusted), "beside the joint: trusted");
    BOOST_TEST((at[1].verdict.grade() == Grade::with_care &&
                at[1].verdict.doubts().find("sharp notch of 10 mrad") != std::string::npos),
               "on it: " + at[1].verdict.doubts());
  }

  Summary
  sphere(const std::string &element, const std::vector<std::string> &drive)
  {
    std::vector<std::string> sets{"Half-space/Undeformed distance = hertz",
                                  "Half-space/Radius along = 500 mm",
                                  "Half-space/Radius across = 500 mm",
                                  "Half-space/Approach = 0.008 mm", // its radius is 2 mm
                                  "Half-space/Element size = " + element};
    sets.insert(sets.end(), drive.begin(), drive.end());
    const SceneInput input = scene_from_text("", "x.prm", sets);
    return halfspace_summary(input.scene, solve_given_distance(input.scene, nullptr));
  }

  /// Creep forces against 27.6 N, Kalker's coefficient 4.27 times G a b xi.
  BOOST_AUTO_TEST_CASE(test_elements)
  {
    const std::vector<std::string> held{
      "Wheelset/Drive = rate", "Wheelset/Traction coefficient = 0", "Wheelset/Creepage = 0.00002"};
    const Summary coarse = sphere("0.4 mm", held), fine = sphere("0.1 mm", held);
    BOOST_TEST((std::abs(coarse.longitudinal_force / 27.6 - 1) > 0.1 && grade_of(coarse) != Grade::trusted),
               "five elements over the radius: " + coarse.doubts);
    BOOST_TEST((std::abs(fine.longitudinal_force / 27.6 - 1) < 0.025 && grade_of(fine) == Grade::trusted),
               "twenty: " + fine.doubts);
    for (const char *const friction : {"0.25", "0.2499", "0.2"})
      BOOST_TEST(
        (grade_of(sphere("0.1 mm",
                         {"Wheelset/Traction coefficient = 0.25",
                          std::string("Contact/Friction coefficient = ") + friction})) != Grade::trusted),
        "a patch that slides as a whole at a friction of " + std::string(friction));
  }

  /// Each fourth node along and across, from one on in both.
  PatchFields
  thinned(const PatchFields &patch, const unsigned int along, const unsigned int lateral)
  {
    PatchFields thin;
    const auto  take = [&](std::vector<double> PatchFields::*field) {
      for (unsigned int i = along; i < patch.n_along; i += 4)
        for (unsigned int j = lateral; j < patch.n_lateral; j += 4)
          (thin.*field).push_back((patch.*field)[i * std::size_t(patch.n_lateral) + j]);
    };
    for (const auto field : {&PatchFields::along,
                             &PatchFields::lateral,
                             &PatchFields::gap,
                             &PatchFields::pressure,
                             &PatchFields::traction_along,
                             &PatchFields::traction_lateral,
                             &PatchFields::state,
                             &PatchFields::area})
      take(field);
    thin.n_along   = (patch.n_along - along + 3) / 4;
    thin.n_lateral = (patch.n_lateral - lateral + 3) / 4;
    return thin;
  }

  /// A worn wheel presses a narrow peak into a wide patch: nodes 1.2 mm apart miss up to 3 % of it, and what
  /// is said to lie between them is that; a wide patch of new profiles is missed by nothing.
  BOOST_AUTO_TEST_CASE(test_between_nodes)
  {
    const std::string worn =
      "Profiles/Wheel = " + std::string(WHEELRAIL_TEST_DIR) + "/profiles/worn_S1002.prw";
    for (const bool narrow : {true, false})
      {
        const PatchFields patch =
          places({narrow ? worn : "Profiles/Wheel = S1002",
                  narrow ? "Wheelset/Lateral shift = 2 mm" : "Wheelset/Lateral shift = 3 mm"},
                 "0.3 mm",
                 {0})
            .front()
            .patch;
        const double peak        = measure_patch(patch).peak_pressure;
        double       most_missed = 0, largest_rise = 0;
        for (unsigned int along = 0; along < 4; ++along)
          for (unsigned int lateral = 0; lateral < 4; ++lateral)
            {
              const PatchMeasures seen   = measure_patch(thinned(patch, along, lateral));
              const double        missed = peak / seen.peak_pressure - 1;
              most_missed                = std::max(most_missed, missed);
              largest_rise               = std::max(largest_rise, seen.between_nodes);
              BOOST_TEST(near(seen.between_nodes, missed, narrow ? 0.02 : 3e-3, "between the nodes"));
            }
        std::printf("missed %.4f, found %.4f\n", most_missed, largest_rise);
        BOOST_TEST(
          (narrow ? most_missed > 0.03 && largest_rise > 0.03 : most_missed < 0.01 && largest_rise < 0.01),
          "narrow and wide peaks");
      }
  }
} // namespace
