// Wheelset/Wheel load: the load that is asked for stands on the rail, in a run and in half-spaces.

#include <wheelrail/wheel/halfspace_case.h>
#include <wheelrail/wheel/wheel_load.h>

#include "messages.h"
#include "parallel.h"
#include "small_scene.h"

#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  BOOST_FIXTURE_TEST_CASE(test_load, test::Parallel)
  {
    Scene scene                  = small_scene(8e-3);
    scene.wheel_load             = 100e3;
    const SceneGeometry geometry = make_geometry(scene);
    const Model         model    = make_model(scene, geometry, MPI_COMM_SELF);
    BOOST_TEST(near(model.wheel_load, 100e3, 1e-6, "load on the rail [N]"));
    const double wheel = mass_properties(model.solid, Body::wheel, model.axle.centre, MPI_COMM_SELF).mass;
    BOOST_TEST(near((model.axle.sprung_mass + model.axle.mass + wheel) * scene.gravity,
                    100e3,
                    1e-6,
                    "weight of sprung mass, half axle and wheel [N]"));
    BOOST_TEST(near(model.axle.torque,
                    0.25 * 100e3 * geometry.contact.rolling_radius,
                    1e-3,
                    "the torque follows the load [N m]"));
    BOOST_TEST(near(scene_load(scene, geometry).force, 100e3, 1e-9, "load of the half-spaces [N]"));
    // half-spaces weigh the wheel by its outline, runs by their cells, here of 8 mm, whose faces cut arcs
    // short
    Scene weighed      = scene;
    weighed.wheel_load = 0;
    BOOST_TEST(near(static_wheel_load(weighed, geometry.wheel) /
                      ((weighed.sprung_mass + weighed.axle_mass + wheel) * weighed.gravity),
                    1,
                    5e-4,
                    "weight of half-spaces over that of a run"));
    scene.wheel_load          = 2e3;
    const std::string message = message_of([&]() { make_model(scene, geometry, MPI_COMM_SELF); });
    BOOST_TEST(
      (message.find("Wheelset/Wheel load = 2 kN: less than the weight of wheel and half axle, ") == 0 &&
       message.find("give more, or a lighter Wheelset/Axle mass") != std::string::npos),
      "a load below the unsprung weight is refused: " + message);
  }
} // namespace
