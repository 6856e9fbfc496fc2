// ranks: 1
// label: long
// A wheel that falls on the rail from half a millimetre: speed of the fall, momentum, and the impact against
// a rigid mass on Hertz's spring.
#include "parallel.h"
#include "reduced_impact.h"
#include "silent_start.h"
#include "small_scene.h"

#include <wheelrail/dynamics/rolling.h>
#include <wheelrail/model/model.h>
#include <wheelrail/wheel/irregular_places.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  constexpr double fall = 0.5e-3; // [m]

  Scene
  drop_scene()
  {
    Scene scene                = small_scene(2e-3);
    scene.traction_coefficient = 0;
    scene.friction.at_rest     = 0;
    scene.rail_length          = 0.5;
    scene.fine_margin          = 8e-3; // for a patch of three times the load
    scene.fine_depth           = 8e-3;
    return scene;
  }

  /// Hertz's part from half-spaces under two loads, the rest of the bodies from how far a static start lowers
  /// the axle.
  ReducedWheel
  reduced(const Scene &scene, const SceneGeometry &geometry, const Model &model, const double lowered)
  {
    ReducedWheel wheel;
    wheel.load            = model.wheel_load;
    wheel.unsprung        = model.wheel_load / scene.gravity - scene.sprung_mass;
    wheel.suspension      = scene.suspension_stiffness;
    const double force[2] = {model.wheel_load, 3 * model.wheel_load};
    double       hertz    = 0;
    for (const double f : force)
      hertz += 0.5 * solve_places(scene, geometry, f, {false, {0.}})[0].approach / std::pow(f, 2. / 3);
    wheel.hertz      = hertz;
    wheel.compliance = (lowered - wheel.approach(model.wheel_load)) / model.wheel_load;
    return wheel;
  }

  /// Vertical momentum of the wheel without its bore, of the half step behind [N s].
  double
  momentum_of_rim(const Solid &solid)
  {
    double sum = 0;
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == Body::wheel)
        sum += (solid.mass[n] + solid.added_mass[n]) * solid.velocity[4 * n + 1];
    return sum;
  }

  double
  moving_mass(const Solid &solid)
  {
    double sum = 0;
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == Body::wheel)
        sum += solid.mass[n] + solid.added_mass[n];
    return sum;
  }

  BOOST_FIXTURE_TEST_CASE(test_drop, test::Parallel)
  {
    const Scene         scene    = drop_scene();
    const SceneGeometry geometry = make_geometry(scene);
    Model               model    = make_model(scene, geometry, MPI_COMM_SELF);
    const StaticResult  start    = silent_start(scene, model);
    const ReducedWheel  wheel    = reduced(scene, geometry, model, -start.hub_displacement);
    std::cout << "        unsprung " << wheel.unsprung << " kg, load " << wheel.load << " N, lowered "
              << -1e6 * start.hub_displacement << " um, of which Hertz "
              << 1e6 * wheel.approach(wheel.load) - 1e6 * wheel.compliance * wheel.load << " um\n";

    // at rest, above the rail
    std::fill(model.solid.displacement.begin(), model.solid.displacement.end(), 0.);
    std::fill(model.solid.velocity.begin(), model.solid.velocity.end(), 0.);
    for (std::size_t n = 0; n < model.solid.mesh.n_nodes(); ++n)
      if (model.solid.mesh.node_body[n] == Body::wheel)
        model.solid.displacement[4 * n + 1] = fall;
    model.axle.velocity = 0;
    model.axle.torque   = 0;
    Axle    axle(model.axle, fall, 0, MPI_COMM_SELF);
    Rolling rolling(model.solid, *model.contact, model.parts, axle, time_scheme(scene, model), MPI_COMM_SELF);

    const double gravity_speed = std::sqrt(2 * wheel.load / wheel.unsprung * fall);
    // with the mass that keeps the step on the running surface
    const double wheel_mass = moving_mass(model.solid),
                 axle_mass =
                   wheel.unsprung - mass_properties(model.solid, Body::wheel, Vector3{}, MPI_COMM_SELF).mass;
    const double duration = 5e-3, dt = model.time_step;
    double       peak = 0, begin = 0, end = 0, speed = 0, impulse = 0, weights = 0, before = fall;
    double       momentum_begin = 0, momentum_end = 0, energy_error = 0;
    bool         at_border = false;
    for (double t = 0; t < duration && end == 0; t += dt)
      {
        rolling.step(true);
        const ContactSums &sums       = rolling.contact_sums();
        const double       axle_speed = (axle.height() - before) / dt;
        // bore nodes have the speed of the axle and their share of the mass
        const double momentum = momentum_of_rim(model.solid) + axle_mass * axle_speed;
        if (begin == 0 && sums.force[1] > 0)
          {
            begin          = t;
            speed          = -momentum / (axle_mass + wheel_mass);
            momentum_begin = momentum;
            impulse = weights = 0;
          }
        else if (begin > 0)
          {
            impulse += dt * sums.force[1];
            weights += dt * (wheel.load + wheel.suspension * (before - fall));
            // waves may part the surfaces for a moment after first touch
            if (sums.force[1] == 0 && peak > wheel.load)
              {
                end          = t;
                momentum_end = momentum;
              }
          }
        before = axle.height();
        peak   = std::max(peak, sums.force[1]);
        if (end > 0)
          energy_error = std::abs(rolling.energy().residual()) / (wheel.load * fall);
        at_border = at_border || sums.at_border;
      }
    BOOST_TEST(!at_border, "the patch stays within the fine cells");
    BOOST_TEST(energy_error < 0.01,
               "energy closes within 1 % of that of the fall: " + std::to_string(100 * energy_error));
    BOOST_TEST((end > begin && begin > 0), "it falls, presses and leaves the rail");
    BOOST_TEST(near_relative(speed, gravity_speed, 0.01, "speed of the fall, v^2 = 2 g h (M + m)/m"));
    BOOST_TEST(near_relative(
      momentum_end - momentum_begin, impulse - weights, 0.005, "change of momentum by impulse"));

    const ReducedMotion impact = reduced_motion(
      wheel, [&](double, const double height) { return wheel.force(-height); }, fall, 0, duration);
    BOOST_TEST(near_relative(peak, impact.peak(), 0.05, "largest force by two masses on Hertz's spring"));
    BOOST_TEST(near_relative(end - begin, impact.longest_contact(), 0.05, "duration by the same"));
  }
} // namespace
