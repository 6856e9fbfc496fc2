// ranks: 1
// label: long
// A wheel with a flat that leaves the rail and comes back: force over the path against a rigid wheel on the
// spring that its contact is at rest, and against the two masses on Hertz's spring.
#include "parallel.h"
#include "read_output.h"
#include "reduced_impact.h"
#include "silent_start.h"
#include "stopped_runs.h"

#include <wheelrail/model/model.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/run/run_start.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  /// A fresh flat of 30 mm at 100 km/h on cells of 2 mm.
  Scene
  flat_scene()
  {
    Scene scene;
    scene.title                    = "flat of 30 mm";
    scene.cell_size                = 2e-3;
    scene.rail_length              = 0.5;
    scene.velocity                 = 100 / 3.6;
    scene.traction_coefficient     = 0;
    scene.rolling_distance         = 65e-3;
    scene.averaging_distance       = 5e-3;
    scene.ticks                    = 1;
    scene.volume_fields            = false;
    scene.checkpoint_interval      = 1e4;
    scene.folder                   = "flat";
    scene.halfspace_element_size   = 0.8e-3;
    scene.irregularities[0].kind   = IrregularKind::flat;
    scene.irregularities[0].place  = 25e-3;
    scene.irregularities[0].length = 30e-3;
    return scene;
  }

  /// The bodies' elasticity far from the contact, from how far a static start lowers the axle [m/N].
  ReducedWheel
  wheel_of(const Scene &scene, const SceneGeometry &geometry)
  {
    Model              model = make_model(scene, geometry, MPI_COMM_SELF);
    const StaticResult start = silent_start(scene, model);
    ReducedWheel       wheel;
    wheel.load            = model.wheel_load;
    wheel.unsprung        = model.wheel_load / scene.gravity - scene.sprung_mass;
    wheel.suspension      = scene.suspension_stiffness;
    const double approach = solve_places(scene, geometry, model.wheel_load, {false, {0.}})[0].approach;
    wheel.hertz           = approach / std::pow(model.wheel_load, 2. / 3);
    wheel.compliance      = (-start.hub_displacement - approach) / model.wheel_load;
    return wheel;
  }

  struct Impact
  {
    double peak = 0, peak_at = 0; ///< [N], [m]
    double leaves_at = 0;         ///< where the wheel leaves the rail first [m]
  };

  Impact
  impact_of(const std::vector<double> &along, const std::vector<double> &force)
  {
    const auto top   = std::max_element(force.begin(), force.end());
    const auto leave = std::find_if(force.begin(), force.end(), [](const double f) { return f < 100; });
    return {*top, along[top - force.begin()], along[leave == force.end() ? 0 : leave - force.begin()]};
  }

  /// Of the reduced model on `spring`, a force over the path and the height.
  Impact
  reduced_impact(const ReducedWheel                          &wheel,
                 const Scene                                 &scene,
                 const std::function<double(double, double)> &spring)
  {
    const double        V      = scene.velocity;
    const ReducedMotion motion = reduced_motion(
      wheel,
      [&](const double t, const double height) { return spring(V * t, height); },
      -wheel.approach(wheel.load),
      0,
      scene.rolling_distance / V,
      5e-7);
    std::vector<double> along;
    for (const double t : motion.time)
      along.push_back(V * t);
    return impact_of(along, motion.force);
  }

  BOOST_FIXTURE_TEST_CASE(test_flat, test::Parallel)
  {
    const Scene         scene    = flat_scene();
    const SceneGeometry geometry = make_geometry(scene);
    const ReducedWheel  wheel    = wheel_of(scene, geometry);
    IrregularPlaces     places{false, {}};
    for (double place = 0; place < 70e-3; place += 1e-3)
      places.values.push_back(place);
    const ContactMap map(scene, geometry, wheel.compliance, places);

    BOOST_TEST(run(scene, false) == 0, "the run ends");
    const History history = read_history("flat/history.h5");
    const auto    find    = [&](const char *name) { return *find_column(history, name); };
    const Impact  found   = impact_of(find("rolled_distance"), find("vertical_force"));
    const Impact  at_rest = reduced_impact(
      wheel, scene, [&](const double x, const double height) { return map.force(x, -height); });
    std::cout << "        largest force " << 1e-3 * found.peak << " kN at " << 1e3 * found.peak_at
              << " mm, leaves the rail at " << 1e3 * found.leaves_at << " mm\n";
    BOOST_TEST(near_relative(found.peak, at_rest.peak, 0.05, "largest force by the contact at rest"));
    BOOST_TEST(near(1e3 * found.peak_at, 1e3 * at_rest.peak_at, 3, "its place [mm]"));
    BOOST_TEST(
      near(1e3 * found.leaves_at, 1e3 * at_rest.leaves_at, 0.5, "where the wheel leaves the rail [mm]"));

    // on Hertz's spring, along the way that the loaded wheel would take slowly
    const double load   = wheel.load;
    const double smooth = map.lowering(0, load);
    const Impact hertz  = reduced_impact(wheel, scene, [&](const double x, const double height) {
      return wheel.force(-height - (map.lowering(x, load) - smooth));
    });
    BOOST_TEST(near_relative(
      found.peak, hertz.peak, 0.1, "largest force by Hertz's spring on the loaded wheel's path"));
  }
} // namespace
