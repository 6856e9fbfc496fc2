// What is expected of a scene before it is computed: patch and number of cells, against CONTACT, Hertz's
// theory and meshes that were made.

#include "parallel.h"
#include "reference_table.h"

#include <wheelrail/input/parameters.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/model.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;

namespace
{
  ExpectedPatch
  patch_of(const Scene &scene)
  {
    return expected_patch(scene, make_geometry(scene));
  }

  /// The scene under this load on one rail [N].
  Scene
  loaded(const double load)
  {
    Scene scene;
    scene.sprung_mass += (load - expected_load(scene)) / scene.gravity;
    return scene;
  }

  /// What the rule of Kik and Piotrowski makes of the long and the short extent of an elliptic contact whose
  /// extents have this ratio (Hertz; K. L. Johnson, Contact Mechanics, 1985, section 4.2): with p0/E* = 1 and
  /// the short semi-axis 1 the undeformed distance is A x^2 + B y^2 and the approach K, the surfaces dip into
  /// each other where A x^2 or B y^2 is below 0.55 of it.
  std::array<double, 2>
  rule_over_hertz(const double ratio)
  {
    const double e2 = 1 - 1 / (ratio * ratio), K = std::comp_ellint_1(std::sqrt(e2)),
                 E = std::comp_ellint_2(std::sqrt(e2));
    const double A = (K - E) / (e2 * ratio * ratio), B = (ratio * ratio * E - K) / (e2 * ratio * ratio);
    return {std::sqrt(0.55 * K / A) / ratio, std::sqrt(0.55 * K / B)};
  }

  void
  test_patch()
  {
    double width = 0, length = 0;
    for (const auto &row : test::read_table("contact_wheel_rail_54E1.csv"))
      if (row[0] == "Fx=0" && row[1] == "0.25" && row[2] == "0")
        width = 1e-3 * std::stod(row[15]), length = 1e-3 * std::stod(row[16]);
    BOOST_TEST((width > length && length > 0), "CONTACT's patch of this pair under 100 kN");

    // wider than long; 5 %, since the curvature of the profiles changes across the patch
    const auto          rule  = rule_over_hertz(width / length);
    const ExpectedPatch patch = patch_of(loaded(1e5));
    BOOST_TEST(near(patch.width / width, rule[0], 0.05, "width over CONTACT's: as the rule over Hertz"));
    BOOST_TEST(near(patch.length / length, rule[1], 0.05, "length over CONTACT's: as the rule over Hertz"));
    BOOST_TEST(length < 2 * half_length_bound(patch.approach, 0.46), "no patch is longer than the bound");

    // Hertz (1882): the approach goes with the load to the power 2/3, with E to -2/3
    BOOST_TEST(near(patch_of(loaded(8e5)).approach / patch.approach,
                    4,
                    1e-9,
                    "eight times the load, four times the approach"));
    Scene soft = loaded(1e5);
    soft.rail_material.youngs_modulus /= 8;
    soft.wheel_material.youngs_modulus /= 8;
    BOOST_TEST(
      near(patch_of(soft).approach / patch.approach, 4, 1e-9, "an eighth of the stiffness, the same"));
  }

  void
  test_elements(const std::vector<std::string> &sets)
  {
    const Scene scene = scene_from_text("", "none", sets).scene;
    const Model model = make_model(scene, make_geometry(scene), MPI_COMM_SELF);
    BOOST_TEST(near(expected_elements(scene, patch_of(scene)) / double(model.solid.quality.elements),
                    1,
                    1. / 3,
                    "to a third: expected over actual number of cells, " + sets.front()));
  }

  void
  test_ranks()
  {
    BOOST_TEST(near(useful_ranks(65e3, 2), 2, 0, "all cores of a small machine"));
    BOOST_TEST(near(useful_ranks(65e3, 64), 16, 0, "as many as have cells to work on"));
    BOOST_TEST(near(useful_ranks(3e3, 64), 1, 0, "one for a small mesh"));
    BOOST_TEST(near(useful_ranks(1e9, 16), 16, 0, "never more than cores"));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(patches_of_loads, test::Parallel)
{
  test_patch();
  test_ranks();
  for (const char *cell : {"4 mm", "2 mm"})
    test_elements({std::string("Mesh/Solution cell size = ") + cell,
                   "Mesh/Fine margin = 4 mm",
                   "Run/Rolling distance = 30 mm",
                   "Output/Ticks = 5",
                   "Track/Rail length = 600 mm"});
  test_elements(
    {"Mesh/Solution cell size = 1 mm", "Run/Rolling distance = 15 mm", "Run/Averaging distance = 5 mm"});
}
