// ranks: 3
// label: long

// A yawed wheel on a rail that yields: forces and work of friction are the same on any number of ranks. The
// way to the static start differs by round-off, which flow must not keep.

#include <wheelrail/dynamics/rolling.h>
#include <wheelrail/run/run_start.h>

#include "parallel.h"
#include "small_scene.h"

#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  struct Figures
  {
    Vector3 start{};      ///< force of the first step [N]
    Vector3 end{};        ///< and of the last
    double  friction = 0; ///< work of friction [J]
  };

  Figures
  roll(const Scene &scene, MPI_Comm communicator)
  {
    Model          model = make_model(scene, make_geometry(scene), communicator);
    Log            log;
    const RunStart start = start_from_rest(scene, model, {}, log);
    Axle           axle(model.axle, start.hub_displacement, start.rate, communicator);
    Rolling rolling(model.solid, *model.contact, model.parts, axle, time_scheme(scene, model), communicator);
    constexpr int steps = 100;
    Figures       figures;
    for (int n = 1; n <= steps; ++n)
      {
        rolling.step(n == 1 || n == steps);
        if (n == 1)
          figures.start = rolling.contact_sums().force;
      }
    figures.end      = rolling.contact_sums().force;
    figures.friction = rolling.energy()["friction_dissipation"];
    return figures;
  }

  BOOST_FIXTURE_TEST_CASE(test_ranks, test::Parallel)
  {
    Scene scene                      = small_scene(4e-3);
    scene.yaw                        = 5e-3;
    scene.rail_material.yield_stress = 300e6;
    const Figures    alone = roll(scene, MPI_COMM_SELF), together = roll(scene, MPI_COMM_WORLD);
    constexpr double bound = 5e-4; // as doc/manual/run.md says
    for (int i = 0; i < 3; ++i)
      {
        const std::string axis(1, "XYZ"[i]);
        BOOST_TEST(
          near(together.start[i], alone.start[i], bound * 1e5, "force along " + axis + ", first step [N]"));
        BOOST_TEST(
          near(together.end[i], alone.end[i], bound * 1e5, "force along " + axis + ", last step [N]"));
      }
    BOOST_TEST(alone.friction > 0, "friction works");
    BOOST_TEST(near(together.friction, alone.friction, bound * alone.friction, "work of friction [J]"));
  }
} // namespace
