// Friction laws: values of the laws, and the contact of a rigidly sliding wheel under each of them.

#include <wheelrail/material/friction.h>
#include <wheelrail/model/model.h>

#include "parallel.h"
#include "small_scene.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  BOOST_FIXTURE_TEST_CASE(values_of_the_laws, test::Parallel)
  {
    const FrictionLaw constant{0.5};
    BOOST_TEST(near(constant.at(0), 0.5, 0, "constant: at rest"));
    BOOST_TEST(near(constant.at(40), 0.5, 0, "constant: at 40 m/s"));
    const FrictionLaw exponential{0.5, FrictionKind::exponential, 0.2, 0.25};
    BOOST_TEST(near(exponential.at(0), 0.5, 1e-15, "exponential: at rest"));
    BOOST_TEST(near(exponential.at(4 * std::log(2.)), 0.35, 1e-15, "exponential: half way after ln 2 / c"));
    BOOST_TEST(near(exponential.at(1e3), 0.2, 1e-15, "exponential: far"));
    const FrictionLaw rational{0.5, FrictionKind::rational, 0.2, 0, 3};
    BOOST_TEST(near(rational.at(0), 0.5, 1e-15, "rational: at rest"));
    BOOST_TEST(near(rational.at(3), 0.35, 1e-15, "rational: half way at the half velocity"));
    BOOST_TEST(near(rational.at(9), 0.275, 1e-15, "rational: a quarter left at three times it"));
    const double d = 1e-6;
    for (const FrictionLaw &law : {exponential, rational})
      BOOST_TEST(near(law.steepest_fall(), (law.at(0) - law.at(d)) / d, 1e-6, "slope at rest"));
    BOOST_TEST(near(FrictionLaw{0.2, FrictionKind::rational, 0.5, 0, 3}.steepest_fall(),
                    0,
                    0,
                    "a rising law does not fall"));
    BOOST_TEST((FrictionLaw{}.frictionless() &&
                !FrictionLaw{0, FrictionKind::rational, 0.5, 0, 3}.frictionless() &&
                !exponential.frictionless()),
               "friction that is 0 at all speeds");
  }

  struct Sliding
  {
    double force = 0, friction_energy = 0, work = 0, excess = 0;
  };

  /// The wheel, lowered by 60 um, slides 100 um along the rail at a constant speed, without damping.
  Sliding
  slide(Model &model, const FrictionLaw &friction, const double speed)
  {
    ContactLaw law = model.contact->law();
    law.friction   = friction;
    law.damping    = 0;
    Contact contact(model.contact->surfaces(), law, 0.02, MPI_COMM_WORLD);
    contact.prepare(model.contact->rail(), model.contact->wheel());
    Solid       &solid = model.solid;
    const int    n     = 400;
    const double way = 100e-6, step = way / speed / n;
    Sliding      result;
    for (int k = 0; k <= n; ++k)
      {
        for (std::size_t m = 0; m < solid.mesh.n_nodes(); ++m)
          if (solid.mesh.node_body[m] == Body::wheel)
            {
              solid.displacement[4 * m + 1] = -60e-6;
              solid.displacement[4 * m + 2] = k * way / n;
              solid.velocity[4 * m + 2]     = k > 0 ? speed : 0;
            }
        contact.gather(solid.displacement.data(), solid.velocity.data());
        const ContactSums sums = contact.evaluate(step);
        result.force           = -sums.force[2] / sums.normal_force;
        result.friction_energy += step * sums.friction_power;
        result.work -= step * speed * sums.force[2];
        for (const ContactNode &node : contact.nodes())
          if (node.pressure > 0 && k > 0)
            {
              const Vector3 v       = {0, 0, speed};
              const double  sliding = norm(v - dot(v, node.normal) * node.normal);
              result.excess =
                std::max(result.excess, norm(node.traction) / node.pressure - friction.at(sliding));
            }
      }
    return result;
  }

  BOOST_FIXTURE_TEST_CASE(sliding_wheel, test::Parallel)
  {
    Model model = test::small_model(MPI_COMM_WORLD, 2e-3);
    struct Case
    {
      std::string name;
      FrictionLaw law;
      double      speed;
    };
    const std::vector<Case> cases = {{"constant", {0.5}, 2},
                                     {"constant, 0.8", {0.8}, 2},
                                     {"exponential", {0.5, FrictionKind::exponential, 0.2, 0.25}, 2},
                                     {"exponential, fast", {0.5, FrictionKind::exponential, 0.2, 0.25}, 20},
                                     {"rational", {0.5, FrictionKind::rational, 0.2, 0, 3}, 2},
                                     {"rising", {0.2, FrictionKind::rational, 0.5, 0, 3}, 2},
                                     {"none", {0}, 2}};
    for (const Case &c : cases)
      {
        const Sliding run = slide(model, c.law, c.speed);
        const double  mu  = c.law.at(c.speed);
        // pressures lean against the wheel's inclined surface as it moves off its lowest place
        BOOST_TEST(near(
          run.force, mu, 2e-3, c.name + " at " + std::to_string(int(c.speed)) + " m/s: force over load"));
        BOOST_TEST(near(run.excess, 0, 1e-12, c.name + ": no traction beyond the bound"));
        if (mu > 0)
          BOOST_TEST((run.friction_energy > 0.8 * run.work && run.friction_energy < run.work),
                     c.name + ": friction takes the work that the springs do not store");
        else
          BOOST_TEST(near(run.friction_energy, 0, 0, "none: no friction work"));
      }
  }
} // namespace
