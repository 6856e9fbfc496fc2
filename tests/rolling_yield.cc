// ranks: 2
// long ranks: 1

// Rolling on steel that yields: the static start has flowed already. From an elastic one the wheel falls into
// a patch that gives way in the first steps, and the vertical force loses a sixth.

#include <wheelrail/dynamics/rolling.h>
#include <wheelrail/run/run_start.h>

#include "parallel.h"
#include "small_scene.h"

#include <algorithm>
#include <cmath>

using namespace wheelrail;
using namespace test;

namespace
{
  BOOST_FIXTURE_TEST_CASE(yielding, test::Parallel)
  {
    Scene scene = small_scene(4e-3);
    for (MaterialData *material : {&scene.rail_material, &scene.wheel_material})
      {
        material->yield_stress    = 280e6;
        material->tangent_modulus = 21e9;
      }
    scene.rolling_distance = 5e-3;
    Model          model   = make_model(scene, make_geometry(scene), MPI_COMM_WORLD);
    Log            log;
    const RunStart start = start_from_rest(scene, model, {}, log);
    Axle           axle(model.axle, start.hub_displacement, start.rate, MPI_COMM_WORLD);
    Rolling        rolling(
      model.solid, *model.contact, model.parts, axle, time_scheme(scene, model), MPI_COMM_WORLD);
    const unsigned long steps = std::lround(scene.rolling_distance / scene.velocity / model.time_step);
    double              low = 1e300, high = -1e300, worst_energy = 0, first_plastic = 0;
    for (unsigned long n = 1; n <= steps; ++n)
      {
        rolling.step(n % 5 == 0 || n == 1 || n == steps);
        const double share = rolling.contact_sums().force[1] / model.wheel_load;
        low                = std::min(low, share);
        high               = std::max(high, share);
        worst_energy       = std::max(worst_energy, rolling.energy().error());
        if (n == 1)
          {
            BOOST_TEST(near(share, 1, 0.005, "first step: vertical force over the weight"));
            first_plastic = rolling.energy()["plastic_work"];
          }
      }
    BOOST_TEST(first_plastic > 0, "the static start has done plastic work");
    BOOST_TEST(rolling.energy()["plastic_work"] > first_plastic, "rolling does more of it");
    BOOST_TEST(near(low, 1, 0.05, "smallest vertical force over the weight"));
    BOOST_TEST(near(high, 1, 0.05, "largest vertical force over the weight"));
    BOOST_TEST(near(worst_energy, 0, 0.01, "energy error, largest"));
  }
} // namespace
