// ranks: 1
// label: long
// Finite elements at rest on a rounded wheel flat of 0.9 mm: peak pressure, area and drop of the wheel
// against half-spaces.
#include "parallel.h"
#include "silent_start.h"

#include <wheelrail/bodies/run_reference.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/model.h>
#include <wheelrail/planes/contact_sections.h>
#include <wheelrail/run/run_start.h>
#include <wheelrail/run/run_texts.h>
#include <wheelrail/sampling/fields.h>
#include <wheelrail/sampling/patch_measures.h>
#include <wheelrail/wheel/irregular_places.h>
#include <wheelrail/wheelset/axle.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  constexpr double no_flat = 1e3; // angle of the smooth wheel

  /// Where the wheel has turned by `pitch` [deg], falling in rolling, with the flat below the axle at 0.
  Scene
  flat_scene(const double cell, const double pitch)
  {
    Scene scene;
    scene.cell_size              = cell;
    scene.rail_length            = 0.5;
    scene.rolling_distance       = 1e-3;
    scene.traction_coefficient   = 0;
    scene.halfspace_element_size = 0.4e-3;
    if (pitch == no_flat)
      return scene;
    IrregularityData &flat = scene.irregularities[0];
    flat.kind              = IrregularKind::rounded_flat;
    flat.length            = 110e-3;
    flat.depth             = 0.9e-3;
    flat.place             = scene.track.nominal_radius * pitch * M_PI / 180;
    return scene;
  }

  struct Rest
  {
    double         peak = 0, area = 0, lowered = 0;
    SectionOffsets pose; ///< that the elastic bodies take
  };

  Rest
  at_rest(const double cell, const double pitch)
  {
    const Scene         scene    = flat_scene(cell, pitch);
    const SceneGeometry geometry = make_geometry(scene);
    Model               model    = make_model(scene, geometry, MPI_COMM_SELF);
    const StaticResult  start    = silent_start(scene, model);
    BOOST_TEST((start.converged && !start.at_border), "the start converges within the fine cells");
    const Axle          axle(model.axle, start.hub_displacement, 0, MPI_COMM_SELF);
    const PatchMeasures patch = measure_patch(patch_fields(*model.contact, axle, 0));
    Summary             summary;
    add_pose(summary, scene, model, axle, MPI_COMM_SELF);
    return {patch.peak_pressure, patch.area, -start.hub_displacement, offsets_of_run(summary)};
  }

  /// Half-spaces in the pose of the finite elements.
  PlaceContact
  half_spaces(const double cell, const double pitch, const SectionOffsets &pose)
  {
    Scene scene                 = flat_scene(cell, pitch);
    scene.halfspace_lateral     = pose.lateral;
    scene.halfspace_inclination = pose.wheel_roll - pose.rail_roll;
    return solve_places(scene, make_geometry(scene), expected_load(scene), {false, {0.}})[0];
  }

  void
  test_flat(const double cell)
  {
    const Rest         round = at_rest(cell, no_flat);
    const PlaceContact even  = half_spaces(cell, no_flat, round.pose);
    std::cout << "        round wheel: peak " << round.peak / even.peak_pressure << ", area "
              << round.area / even.area << " of half-spaces\n";
    for (const double pitch : {0., 3., 5., 7.})
      {
        const Rest         found    = at_rest(cell, pitch);
        const PlaceContact expected = half_spaces(cell, pitch, found.pose);
        const std::string  at =
          std::to_string(1e3 * cell).substr(0, 3) + " mm, " + std::to_string(pitch).substr(0, 1) + " deg: ";
        BOOST_TEST(near_relative(found.peak, expected.peak_pressure, 0.03, at + "peak pressure"));
        BOOST_TEST(near_relative(found.area, expected.area, 0.03, at + "area"));
        // rim and head tilt otherwise on the flat, where the patch lies elsewhere: a quarter of a millimetre
        // across, on a contact inclined by 4 deg
        BOOST_TEST(near(
          1e6 * (found.lowered - round.lowered), 1e6 * expected.drop, 10, at + "drop of the wheel [um]"));
        std::cout << "        pose: " << 1e6 * found.pose.lateral << " um, "
                  << 1e3 * (found.pose.wheel_roll - found.pose.rail_roll) << " mrad\n";
      }
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(irregular_rest, test::Parallel)
{
  const auto &all = boost::unit_test::framework::master_test_suite();
  test_flat(all.argc > 1 ? 1e-3 * std::atof(all.argv[1]) : 1e-3);
}
