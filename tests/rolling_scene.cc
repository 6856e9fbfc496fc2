// ranks: 1 2

// A few millimetres of rolling on coarse cells, from the static start on: forces, energy, friction, and the
// same figures on any number of ranks.

#include <wheelrail/dynamics/rolling.h>
#include <wheelrail/dynamics/rolling_velocities.h>
#include <wheelrail/model/model.h>
#include <wheelrail/run/run_start.h>

#include "parallel.h"
#include "small_scene.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  /// What a run gives.
  struct Run
  {
    StaticResult  start;
    double        wheel_load = 0;
    Vector3       begin_force{}, mean_force{}, last_force{}; ///< on the wheel [N]
    double        spread       = 0; ///< largest departure of the vertical force from its mean [N]
    double        worst_energy = 0; ///< largest energy error
    EnergyBalance energy;
    double        last_pressure = 0, slip_share = 0, creepage = 0, axle_height = 0;
    bool          at_border = false;
    unsigned long steps     = 0;
  };

  Run
  roll(const Scene &scene, MPI_Comm communicator)
  {
    Run               run;
    Model             model = make_model(scene, make_geometry(scene), communicator);
    const StaticLoads loads = static_loads(scene, model);
    run.wheel_load          = model.wheel_load;
    run.start               = static_start(
      *model.discretization, model.solid, *model.contact, model.parts, loads, [](const std::string &) {});
    const double                rate = scene.velocity / loads.forward_radius * (1 + run.start.creepage);
    const AlignedVector<double> still(model.solid.displacement.size(), 0.);
    rolling_velocities(model.solid, model.parts, model.axle, rate, still);
    Axle    axle(model.axle, run.start.hub_displacement, rate, communicator);
    Rolling rolling(model.solid, *model.contact, model.parts, axle, time_scheme(scene, model), communicator);
    run.steps                       = std::lround(scene.rolling_distance / scene.velocity / model.time_step);
    constexpr unsigned long n_begin = 10;
    double                  low = 1e300, high = -1e300;
    for (unsigned long n = 1; n <= run.steps; ++n)
      {
        rolling.step(n % 5 == 0 || n == 1 || n == run.steps);
        const ContactSums &sums = rolling.contact_sums();
        if (n <= n_begin)
          add(run.begin_force, 1. / n_begin, sums.force);
        add(run.mean_force, 1. / run.steps, sums.force);
        low              = std::min(low, sums.force[1]);
        high             = std::max(high, sums.force[1]);
        run.worst_energy = std::max(run.worst_energy, rolling.energy().error());
        run.at_border    = run.at_border || sums.at_border;
      }
    run.spread        = std::max(high - run.mean_force[1], run.mean_force[1] - low);
    run.last_force    = rolling.contact_sums().force;
    run.last_pressure = rolling.contact_sums().largest_pressure;
    run.energy        = rolling.energy();
    run.creepage      = axle.pitch_rate() * model.geometry.rolling_radius / scene.velocity - 1;
    run.axle_height   = axle.height();
    return run;
  }

  void
  print(const Run &run)
  {
    std::cout << std::setprecision(6) << "        " << run.steps << " steps, Newton "
              << run.start.newton_steps << ", hub displacement " << 1e6 * run.start.hub_displacement
              << " um, wheel load " << run.wheel_load << " N\n        forces on the wheel [N] at the start "
              << run.begin_force[0] << ' ' << run.begin_force[1] << ' ' << run.begin_force[2] << ", mean "
              << run.mean_force[0] << ' ' << run.mean_force[1] << ' ' << run.mean_force[2] << ", end "
              << run.last_force[0] << ' ' << run.last_force[1] << ' ' << run.last_force[2]
              << "\n        energies [J]:";
    for (const EnergyTerm &term : run.energy.terms())
      std::cout << ' ' << term.name << ' ' << term.value;
    std::cout << ", residual " << run.energy.residual() << '\n';
  }

  Scene
  scene()
  {
    return small_scene(4e-3);
  }

  /// A run on several ranks against that of one: they differ by what the static start leaves unsolved.
  void
  compare(const Run &run, const Run &alone)
  {
    const auto same =
      [](const double value, const double expected, const double tolerance, const std::string &text) {
        BOOST_TEST(near(value / expected, 1, tolerance, text + " over that of one rank"));
      };
    BOOST_TEST((run.steps == alone.steps), "as many steps as on one rank");
    same(run.wheel_load, alone.wheel_load, 1e-12, "wheel load");
    same(run.start.hub_displacement, alone.start.hub_displacement, 1e-5, "vertical displacement of the axle");
    same(run.start.creepage, alone.start.creepage, 1e-5, "predicted creepage");
    same(run.creepage, alone.creepage, 2e-3, "creepage");
    same(run.axle_height, alone.axle_height, 1e-5, "height of the axle");
    same(run.mean_force[1], alone.mean_force[1], 1e-5, "vertical force");
    same(run.mean_force[2], alone.mean_force[2], 2e-4, "longitudinal force");
    same(run.last_pressure, alone.last_pressure, 1e-5, "largest pressure");
    same(run.energy["strain_energy"], alone.energy["strain_energy"], 1e-5, "strain energy");
    same(run.energy["friction_dissipation"], alone.energy["friction_dissipation"], 1e-3, "friction");
  }

  void
  driving(const int size)
  {
    const Run    run  = roll(scene(), MPI_COMM_WORLD);
    const double load = run.wheel_load, wanted = 0.25 * load;
    print(run);
    BOOST_TEST(!run.at_border, "the patch stays inside the fine cells");
    BOOST_TEST(
      near(run.start.contact_force[1] / load, 1, 2e-5, "static start: vertical force over the weight"));
    BOOST_TEST(near(run.begin_force[1] / load, 1, 0.01, "first ten steps: vertical force over the weight"));
    BOOST_TEST(near(
      run.start.contact_force[2] / wanted, 1, 0.005, "static start: longitudinal force over the wanted one"));
    // the velocities of the start are not those of the coarse cells: the first step alone has 5 % of damping
    BOOST_TEST(
      near(run.begin_force[2] / wanted, 1, 0.03, "first ten steps: longitudinal force over the wanted one"));
    BOOST_TEST(near(run.mean_force[1] / load, 1, 0.01, "mean vertical force over the weight"));
    BOOST_TEST(
      near(run.spread / load, 0, 0.03, "vertical force, largest departure from the mean over the weight"));
    BOOST_TEST(near(run.worst_energy, 0, 0.01, "energy error, largest"));
    BOOST_TEST((run.energy["friction_dissipation"] > 0 && run.energy["viscous_dissipation"] > 0 &&
                run.energy["contact_damping_dissipation"] >= 0),
               "dissipation is positive");
    BOOST_TEST((run.creepage > 0 && run.creepage < 0.02), "driving: creepage is positive");
    // with the creepage of a coarse half-space grid, 4 % would be lost
    BOOST_TEST(near(run.mean_force[2] / wanted, 1, 0.02, "mean longitudinal force over the wanted one"));

    if (size > 1)
      compare(run, roll(scene(), MPI_COMM_SELF));
  }

  void
  frictionless()
  {
    Scene smooth                = scene();
    smooth.friction.at_rest     = 0;
    smooth.traction_coefficient = 0;
    smooth.rolling_distance     = 3e-3;
    const Run run               = roll(smooth, MPI_COMM_WORLD);
    print(run);
    BOOST_TEST(near(run.energy["friction_dissipation"], 0, 0, "no friction: no friction work [J]"));
    // the normal force leans along the track only as far as the surface does
    BOOST_TEST(near(
      run.mean_force[2] / run.wheel_load, 0, 1e-3, "no friction: mean longitudinal force over the weight"));
    BOOST_TEST(
      near(run.mean_force[1] / run.wheel_load, 1, 0.015, "no friction: mean vertical force over the weight"));
    BOOST_TEST(near(run.worst_energy, 0, 0.01, "no friction: energy error, largest"));
    BOOST_TEST(near(run.creepage, 0, 1e-4, "no friction, no torque: the wheel keeps its rate"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(rolling_scene)
{
  const Parallel parallel;
  driving(parallel.size);
  if (parallel.size == 1)
    frictionless();
}
