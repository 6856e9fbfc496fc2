// Tractions to start from, by the half-space solver: Kalker's linear theory for small creepage and spin,
// saturation, signs.

#include <wheelrail/halfspace/problem.h>
#include <wheelrail/statics/facing_surfaces.h>
#include <wheelrail/statics/start_tractions.h>

#include "elliptic_contact.h"
#include "parallel.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;
using namespace test::elliptic;

namespace
{
  /// C11: Kalker's coefficient (1990, table E.3), interpolated to Poisson's ratio 0.3.
  void
  linear_theory(const double along, const double across, const double C11)
  {
    const Contact     contact = elliptic_contact(along, across);
    const double      N       = normal_force(contact);
    const std::string name    = "a/b = " + std::to_string(along / across).substr(0, 4) + ": ";
    BOOST_TEST(near(
      N / (2. / 3 * M_PI * along * across * largest_pressure), 1, 0.01, name + "elliptic pressure is there"));

    const double slope = shear_modulus * along * across * C11;
    const double small = 0.02 * friction * N / slope;
    const auto   start = start_tractions_at_creepage(contact, small, steel, {velocity});
    // elements of a sixteenth of the semi-axis
    BOOST_TEST(near(
      start.force / (slope * small), 1, 0.015, name + "force at small creepage over G a b C11 creepage"));

    // Vermeulen and Johnson's curve of saturation is known to 10 % of the bound; the
    // exact theory must come as near to it
    double worst = 0;
    for (const double k : {0.1, 0.4, 0.7, 0.95, 1.3, 1.8})
      {
        const double expected = k < 1 ? 1 - std::pow(1 - k, 3) : 1;
        const auto at = start_tractions_at_creepage(contact, 3 * k * friction * N / slope, steel, {velocity});
        worst         = std::max(worst, std::abs(at.force / (friction * N) - expected));
      }
    BOOST_TEST(near(worst, 0, 0.06, name + "largest distance from the curve of Vermeulen and Johnson"));

    const auto full = start_tractions_at_creepage(contact, 0.05, steel, {velocity});
    BOOST_TEST(near(full.force / (friction * N), 1, 1e-3, name + "saturation at friction x normal force"));
    double excess = 0;
    for (std::size_t k = 0; k < full.traction.size(); ++k)
      excess = std::max(excess, norm(full.traction[k]) - friction * contact.nodes()[k].pressure);
    BOOST_TEST(near(excess / largest_pressure, 0, 1e-12, name + "no traction exceeds friction x pressure"));
  }

  void
  wanted_force()
  {
    Contact      contact = elliptic_contact(6e-3, 4e-3);
    const double bound   = friction * normal_force(contact);
    const auto   driving = start_tractions(contact, 0.5 * bound, steel, {velocity}),
               braking   = start_tractions(contact, -0.5 * bound, steel, {velocity});
    BOOST_TEST(near(driving.force / bound, 0.5, 1e-6, "the wanted force is met"));
    BOOST_TEST((driving.creepage > 0 && !driving.saturated), "driving: creepage positive, not saturated");
    BOOST_TEST(near(braking.creepage / driving.creepage, -1, 1e-6, "braking mirrors driving"));
    double largest = 0, mirror = 0;
    for (std::size_t k = 0; k < driving.traction.size(); ++k)
      {
        largest = std::max(largest, driving.traction[k][2]);
        mirror  = std::max(mirror, std::abs(driving.traction[k][2] + braking.traction[k][2]));
      }
    BOOST_TEST(near(largest, 0, 0, "driving: tractions on the rail point backwards"));
    BOOST_TEST(near(mirror / largest_pressure, 0, 1e-6, "braking: tractions mirrored"));

    // traction builds up from the leading edge, which is ahead of the axle
    const Lattice     &lattice = contact.lattice();
    const unsigned int row = lattice.n_lateral / 2, middle = lattice.n_along / 2;
    const double       ahead = driving.traction[lattice.index(middle + 16, row)][2],
                 behind      = driving.traction[lattice.index(middle - 8, row)][2];
    BOOST_TEST(std::abs(ahead) < std::abs(behind), "traction grows from the leading edge to the rear");

    for (std::size_t k = 0; k < driving.traction.size(); ++k)
      contact.set_traction(k, driving.traction[k]);
    const ContactSums sums = contact.evaluate(0);
    BOOST_TEST(near(sums.force[2] / driving.force,
                    1,
                    1e-3,
                    "the contact with these tractions drives the wheel forward by the force"));

    const auto beyond = start_tractions(contact, 1.2 * bound, steel, {velocity});
    BOOST_TEST(beyond.saturated, "a force beyond the bound is flagged");
    BOOST_TEST(near(beyond.force / bound, 0.98, 1e-3, "and the bound less two per cent is given"));
    const auto none = start_tractions(contact, 0, steel, {velocity});
    BOOST_TEST(near(none.force / bound, 0, 1e-6, "no force wanted: no force"));
    BOOST_TEST(near(none.creepage, 0, 1e-9, "no force wanted: no creepage"));
  }

  /// A cone that rolls freely slides sideways ahead of and behind the axle: spin.
  void
  spin()
  {
    const double  a = 4e-3, angle = 0.025, rate = std::sin(angle) / radius;
    const Contact contact = elliptic_contact(a, a, angle);
    const auto    start   = start_tractions(contact, 0, steel, {velocity});
    double        lateral = 0, inner = 0, outer = 0;
    for (std::size_t k = 0; k < start.traction.size(); ++k)
      {
        const double f = contact.rail().area[k] / std::cos(angle);
        lateral -= f * start.traction[k][0];
        (contact.rail().reference[k][0] > 0 ? inner : outer) += f * start.traction[k][2];
      }
    // C23 of a circle at Poisson's ratio 0.3 is 1.5 (Kalker 1990, table E.3)
    BOOST_TEST(near(lateral / (1.5 * shear_modulus * std::pow(a, 3) * rate),
                    1,
                    0.1,
                    "spin: lateral force on the wheel over G (ab)^1.5 C23 spin"));
    BOOST_TEST((inner > 0 && outer < 0),
               "spin: the smaller radius drags the rail forward, the larger one backward");
    BOOST_TEST(near(start.creepage, 0, 1e-4, "spin: no creepage without force"));
  }

  /// Two patches on the sides of a ridge, in planes of their own: each has the tractions that it would have
  /// alone, and the creepage is that of both.
  void
  several_planes()
  {
    constexpr double a = 5e-3, b = 3e-3, side = 0.4;
    const Contact    one = elliptic_contact(a, b, side),
                  both   = elliptic_contact(a, b, 0, {friction}, {side, 8e-3});
    const double bound   = friction * normal_force(both);
    BOOST_TEST(
      near(bound / (2 * friction * normal_force(one)), 1, 2e-3, "ridge: twice the load of one side"));
    for (const double creepage : {0.2e-3, 1e-3, 3e-3})
      BOOST_TEST(
        near(start_tractions_at_creepage(both, creepage, steel, {velocity}).force /
               start_tractions_at_creepage(one, creepage, steel, {velocity}).force,
             2,
             0.01,
             "ridge: force of both sides over that of one at the creepage " + std::to_string(creepage)));
    for (const double share : {-0.3, 0.6})
      {
        const auto start = start_tractions(both, share * bound, steel, {velocity});
        BOOST_TEST(near(start.force / bound, share, 1e-5, "ridge: the wanted force is met"));
        BOOST_TEST(
          near(start.creepage / start_tractions(one, 0.5 * share * bound, steel, {velocity}).creepage,
               1,
               0.01,
               "ridge: creepage over that of one side with half the force"));
        double lateral = 0;
        for (std::size_t k = 0; k < start.traction.size(); ++k)
          lateral += both.rail().area[k] * start.traction[k][0];
        BOOST_TEST(near(lateral / bound, 0, 1e-3, "ridge: lateral forces of both sides balance"));
      }
    const auto beyond = start_tractions(both, 1.2 * bound, steel, {velocity});
    BOOST_TEST(beyond.saturated, "ridge: a force beyond the bound is flagged");
    BOOST_TEST(near(beyond.force / bound, 0.98, 2e-3, "ridge: and the bound less two per cent is given"));
  }

  /// A tread that is longer than the head turns slower by as much under the same tractions; a rail that was
  /// stretched before the wheel came does not count.
  void
  stretched_tread()
  {
    constexpr double of_tread = 1.2e-4, of_head = 0.4e-4, of_old_rail = 3e-4;
    Contact          contact = elliptic_contact(6e-3, 4e-3);
    const double     bound   = friction * normal_force(contact);
    const auto       alike   = start_tractions(contact, 0.5 * bound, steel, {velocity});
    const auto       longer  = start_tractions(contact, 0.5 * bound, steel, {velocity, 0, of_tread});
    BOOST_TEST(
      near(longer.creepage - alike.creepage, -of_tread, 1e-3 * of_tread, "a longer tread turns slower"));
    double change = 0;
    for (std::size_t k = 0; k < alike.traction.size(); ++k)
      change = std::max(change, norm(longer.traction[k] - alike.traction[k]));
    BOOST_TEST(near(change / largest_pressure, 0, 1e-4, "under the same tractions"));

    // displacements along the track in proportion to the place, besides those that press
    const auto          &rail = contact.rail().reference, &wheel = contact.wheel().reference;
    std::vector<double>  displacement(4 * (rail.size() + wheel.size()), 0.), still(displacement.size(), 0.);
    std::vector<Vector3> before(rail.size());
    for (std::size_t k = 0; k < rail.size(); ++k)
      {
        displacement[4 * k + 1] = contact.displacement(Body::rail, k)[1];
        displacement[4 * k + 2] = (of_head + of_old_rail) * rail[k][2];
        before[k]               = {0, 0, of_old_rail * rail[k][2]};
      }
    for (std::size_t k = 0; k < wheel.size(); ++k)
      {
        const double arc                        = radius * std::asin(wheel[k][2] / radius);
        displacement[4 * (rail.size() + k) + 2] = (1 + of_tread) * arc - wheel[k][2];
      }
    contact.gather(displacement.data(), still.data());
    contact.evaluate(0);
    BOOST_TEST(normal_force(contact) > 0, "stretched surfaces: still in contact");
    BOOST_TEST(near(tread_stretch(contact, before),
                    of_tread - of_head,
                    1e-2 * of_tread,
                    "stretched surfaces: tread less head, without what the rail had"));
  }

  /// Bodies that a lateral force yaws against each other slide aside, as under a lateral creepage in
  /// proportion to the force. Steel that is moved aside lies elsewhere on its profile.
  void
  bodies_move_aside()
  {
    constexpr double       eta = 1.5e-4, away = 3e-5;
    Contact                contact = elliptic_contact(6e-3, 4e-3);
    const double           bound = friction * normal_force(contact), yaw = 2e-4 / bound; // [rad/N]
    const BeyondHalfspaces beyond = [&](const StartGrid &start) {
      const HalfspaceGrid                    &grid = start.grid;
      const std::vector<RowsInfluence::Basis> bases(grid.my, {{0, 1, 0, 0, 0, -1, 1, 0, 0}});
      const auto                              lever = [&](const double ahead) {
        RowInfluence influence{1, std::vector<double>(grid.my, 1.), {}};
        for (const double lag : RowsInfluence::lags(grid, ahead))
          {
            influence.by_lag.resize(influence.by_lag.size() + 9, 0.);
            influence.by_lag[influence.by_lag.size() - 9] = yaw * lag;
          }
        return influence;
      };
      auto added = std::make_shared<RowsInfluence>(grid, bases);
      added->add_body(lever(0), lever(grid.dx), grid.dx);
      return added;
    };
    const auto yawed = start_tractions(contact, 0.5 * bound, steel, {velocity, eta}, beyond);
    double     force = 0;
    for (std::size_t k = 0; k < yawed.traction.size(); ++k)
      force += yawed.traction[k][0] * contact.rail().area[k];
    BOOST_TEST(std::abs(force) > 0.01 * bound, "a lateral creepage makes a lateral force");
    const auto creeping = start_tractions(contact, 0.5 * bound, steel, {velocity, eta + yaw * force});
    double     change   = 0;
    for (std::size_t k = 0; k < yawed.traction.size(); ++k)
      change = std::max(change, norm(yawed.traction[k] - creeping.traction[k]));
    BOOST_TEST(near(change / largest_pressure, 0, 1e-4, "a yaw of the bodies is a lateral creepage"));
    BOOST_TEST(
      near(creeping.creepage, yawed.creepage, 1e-4 * yawed.creepage, "with the same longitudinal creepage"));

    const auto         &rail = contact.rail().reference, &wheel = contact.wheel().reference;
    std::vector<double> displacement(4 * (rail.size() + wheel.size()), 0.), still(displacement.size(), 0.);
    for (std::size_t k = 0; k < rail.size(); ++k)
      displacement[4 * k + 1] = contact.displacement(Body::rail, k)[1];
    for (std::size_t k = 0; k < wheel.size(); ++k)
      displacement[4 * (rail.size() + k)] = away;
    contact.gather(displacement.data(), still.data());
    contact.evaluate(0);
    BOOST_TEST(near(facing_after_shift(contact, start_grids(contact).front()),
                    -away,
                    1e-2 * away,
                    "steel from farther in lies where the wheel was moved out"));
  }

  /// Friction that falls with the slip velocity: the tractions are those of the half-space problem with that
  /// law, and a force that it does not carry is cut to the largest that it does.
  void
  falling_friction()
  {
    // edges half an element beyond the middles of the last ones, as they lie on the average
    const double      a = 6.125e-3, b = 4.125e-3;
    const FrictionLaw exponential{friction, FrictionKind::exponential, 0.15, 3},
      rational{friction, FrictionKind::rational, 0.1, 0, 0.2};
    for (const FrictionLaw &law : {exponential, rational})
      {
        const std::string name    = law.kind == FrictionKind::rational ? "rational: " : "exponential: ";
        const Contact     contact = elliptic_contact(a, b, 0, law);
        const double      load    = normal_force(contact);
        HalfspaceProblem  problem;
        problem.grid           = centred_grid(a, b, 2.5e-4, 2.5e-4);
        const Lattice &lattice = contact.lattice();
        const auto     node    = [&](const int i, const int j) {
          return lattice.index(i + (int(lattice.n_along) - problem.grid.mx) / 2,
                               j + (int(lattice.n_lateral) - problem.grid.my) / 2);
        };
        for (int j = 0; j < problem.grid.my; ++j)
          for (int i = 0; i < problem.grid.mx; ++i)
            problem.pressure.push_back(contact.nodes()[node(i, j)].pressure);
        problem.friction                 = law;
        problem.velocity                 = velocity;
        problem.coupling_tolerance       = 1e-6;
        problem.longitudinal_force_given = true;
        problem.fx                       = -0.4 * friction * load;
        const HalfspaceSolution solution = solve_rolling(problem);
        const auto              start    = start_tractions(contact, -problem.fx, steel, {velocity});
        BOOST_TEST((solution.converged() && start.converged && !start.saturated), name + "both converged");
        // steps of an element make the problem too stiff by half of one, some 2 %; the start does without
        BOOST_TEST(
          near(start.creepage / solution.xi, 1.02, 5e-3, name + "creepage of the half-space problem"));
        double error = 0, slipping = 0, inside = 0;
        for (int j = 0; j < problem.grid.my; ++j)
          for (int i = 0; i < problem.grid.mx; ++i)
            {
              const std::size_t e = i + std::size_t(problem.grid.mx) * j, k = node(i, j);
              if (problem.pressure[e] <= 0)
                continue;
              ++inside;
              error += std::pow(start.traction[k][2] - solution.traction_x[e], 2) +
                       std::pow(start.traction[k][0] - solution.traction_y[e], 2);
              slipping +=
                solution.state[e] == HalfspaceSolution::slip && solution.friction[e] < 0.97 * friction;
            }
        // half an element along the track lies between both
        BOOST_TEST(
          near(std::sqrt(error / inside) / largest_pressure,
               0,
               0.01,
               name + "root mean square of the distance to the tractions of the half-space problem"));
        BOOST_TEST(slipping > 20, name + "slip that lowers friction by three per cent and more");
        const auto constant = start_tractions(elliptic_contact(a, b), -problem.fx, steel, {velocity});
        BOOST_TEST(start.creepage > 1.01 * constant.creepage,
                   name + "more creepage than with friction at rest");

        // half the size, since this takes many solutions
        const Contact small   = elliptic_contact(0.5 * a, 0.5 * b, 0, law);
        const double  bound   = friction * normal_force(small);
        const auto    most    = start_tractions(small, bound, steel, {velocity});
        double        largest = 0;
        for (double creepage = 0.5 * most.creepage; creepage < 3 * most.creepage; creepage *= 1.2)
          largest = std::max(largest, start_tractions_at_creepage(small, creepage, steel, {velocity}).force);
        BOOST_TEST((most.saturated && largest < 0.97 * bound), name + "the force at full slip is beyond it");
        BOOST_TEST(near(most.force / largest, 1, 0.02, name + "the largest force over all creepages"));
      }
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(tractions_at_start, test::Parallel)
{
  linear_theory(6e-3, 4e-3, 4.78);
  linear_theory(4e-3, 4e-3, 4.30);
  linear_theory(3e-3, 6e-3, 3.81);
  wanted_force();
  spin();
  several_planes();
  stretched_tread();
  bodies_move_aside();
  falling_friction();
}
