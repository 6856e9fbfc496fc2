// Contact of rigidly placed bodies: true gap, no cogging, action and reaction, Coulomb friction, energy.

#include <wheelrail/model/model.h>

#include "parallel.h"
#include "small_scene.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

using namespace wheelrail;
using namespace test;

namespace
{
  /// Rigid motion of the wheel: lowered [m], moved along and turned [rad].
  struct Motion
  {
    double down = 0, along = 0, angle = 0;
  };

  Vector3
  moved(const Model &model, const Vector3 &X, const Motion &motion)
  {
    return model.axle.centre + Vector3{0, -motion.down, motion.along} +
           Rotation(model.axle.axis, motion.angle)(X - model.axle.centre);
  }

  /// Places the wheel and gives its nodes the velocities `linear` and `rate` about the axle.
  void
  place(Model &model, const Motion &motion, const Vector3 &linear = {}, const double rate = 0)
  {
    Solid &solid = model.solid;
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == Body::wheel)
        {
          const double *R = &solid.mesh.reference[4 * n];
          const Vector3 X = {R[0], R[1], R[2]}, x = moved(model, X, motion);
          const Vector3 centre = moved(model, model.axle.centre, motion);
          const Vector3 v      = linear + rate * cross(model.axle.axis, x - centre);
          for (int i = 0; i < 3; ++i)
            {
              solid.displacement[4 * n + i] = x[i] - X[i];
              solid.velocity[4 * n + i]     = v[i];
            }
        }
    const double radius = model.geometry.rolling_radius;
    model.contact->move_window(motion.along, radius * motion.angle - motion.along);
    model.contact->gather(solid.displacement.data(), solid.velocity.data());
  }

  /// Distance of a rail node from the exact wheel surface in its place, along that surface's normal [m].
  double
  exact_gap(const Model &model, const Vector3 &x, const Motion &motion)
  {
    return -model.contact->surfaces().wheel.offset(x - Vector3{0, -motion.down, motion.along});
  }

  /// Gaps against the exact ones for all nodes that should be nearer than `limit`.
  struct GapErrors
  {
    double largest = 0;
    int    nodes = 0, lost = 0;
  };

  GapErrors
  gap_errors(const Model &model, const Motion &motion, const double limit)
  {
    const Contact &contact = *model.contact;
    const Lattice &lattice = contact.lattice();
    GapErrors      errors;
    // on the outermost lines the surface filter is one-sided; a loaded node there stops a run
    for (int i = contact.window().rail.first + 1; i + 1 < contact.window().rail.last; ++i)
      for (unsigned int j = 1; j + 1 < lattice.n_lateral; ++j)
        {
          const std::size_t k     = lattice.index(i, j);
          const double      exact = exact_gap(model, contact.rail_position(k), motion);
          if (exact > limit)
            continue;
          ++errors.nodes;
          if (contact.nodes()[k].gap == 1)
            ++errors.lost;
          else
            errors.largest = std::max(errors.largest, std::abs(contact.nodes()[k].gap - exact));
        }
    return errors;
  }

  void
  undeformed_distance_is_met(Model &model)
  {
    const double       down    = 60e-6;
    const Contact     &contact = *model.contact;
    const Lattice     &lattice = contact.lattice();
    const auto        &frame   = model.geometry.frame;
    const FrameProfile rail(rail_profile("54E1").head, model.geometry.rail, frame);
    const FrameProfile wheel(wheel_profile("S1002").tread, model.geometry.wheel, frame);
    place(model, {down, 0, 0});
    model.contact->evaluate(0);
    double error = 0, lowest = 0;
    int    nodes = 0;
    for (int i = contact.window().rail.first; i < contact.window().rail.last; ++i)
      for (unsigned int j = 1; j + 1 < lattice.n_lateral; ++j)
        {
          const double s     = lattice.s_begin + j * lattice.spacing_lateral,
                       z     = (lattice.first_station + i) * lattice.spacing_along;
          const double slope = wheel.at(s).slope;
          const double gap =
            (undeformed_distance(wheel, rail, s) + z * z / (2 * contact.surfaces().local_radius(s)) -
             down * std::cos(frame.angle)) /
            std::sqrt(1 + slope * slope);
          if (gap > 60e-6)
            continue;
          ++nodes;
          lowest = std::min(lowest, gap);
          error  = std::max(error, std::abs(contact.nodes()[lattice.index(i, j)].gap - gap));
        }
    BOOST_TEST((lowest < -50e-6 && nodes > 40), std::to_string(nodes) + " nodes nearer than 60 um");
    // the parabola and the cosine of the slope are not exact themselves, see no_cogging()
    BOOST_TEST(near(1e6 * error, 0, 0.5, "gap against undeformed distance d(s) + z^2/2r [um]"));
  }

  void
  no_cogging(Model &model)
  {
    const double spacing = model.contact->lattice().spacing_along, radius = model.geometry.rolling_radius;
    double       still = 0, rolling = 0;
    int          lost = 0, nodes = 0;
    for (int k = 0; k <= 32; ++k)
      {
        const double way = k * spacing / 32;
        const Motion turned{60e-6, 0, way / radius}, rolled{60e-6, way, way / radius};
        for (const auto &[motion, worst] : {std::pair<Motion, double *>{turned, &still}, {rolled, &rolling}})
          {
            place(model, motion);
            model.contact->evaluate(0);
            const GapErrors errors = gap_errors(model, motion, 60e-6);
            *worst                 = std::max(*worst, errors.largest);
            lost += errors.lost;
            nodes += errors.nodes;
          }
      }
    BOOST_TEST(lost == 0,
               std::to_string(lost) + " of " + std::to_string(nodes) + " near nodes found no facet");
    BOOST_TEST(near(
      1e6 * still, 0, 0.02, "wheel turned in place by parts of a cell: gap against the exact surface [um]"));
    BOOST_TEST(
      near(1e6 * rolling, 0, 0.02, "wheel rolled by parts of a cell: gap against the exact surface [um]"));
    std::cout << "        the chords themselves: " << 1e6 * spacing * spacing / 8 / radius << " um\n";
  }

  /// Every node finds the wheel from anywhere, also across more facets than one search may walk.
  void
  many_rows()
  {
    Scene scene            = small_scene(5e-4);
    scene.rolling_distance = 1e-3;
    Model model            = make_model(scene, make_geometry(scene), MPI_COMM_WORLD);
    BOOST_TEST(model.contact->lattice().n_lateral > 61,
               std::to_string(model.contact->lattice().n_lateral) + " rows of 0.5 mm");
    const Motion motion{60e-6, 0, 0};
    place(model, motion);
    model.contact->evaluate(0);
    const GapErrors errors = gap_errors(model, motion, 60e-6);
    BOOST_TEST(errors.lost == 0,
               std::to_string(errors.lost) + " of " + std::to_string(errors.nodes) +
                 " near nodes found no facet");
    BOOST_TEST(near(1e6 * errors.largest, 0, 0.02, "cells of 0.5 mm: gap against the exact surface [um]"));
  }

  /// Sums of forces and of moments about the first contact point over the nodes of a body.
  struct ForceSum
  {
    Vector3 force{}, moment{};
  };

  ForceSum
  force_sum(const Model &model, const Body body)
  {
    const Solid          &solid = model.solid;
    AlignedVector<double> nodal(solid.force.size(), 0.);
    model.contact->add_forces(nodal.data());
    const Vector3 about = {model.geometry.frame.origin.x, model.geometry.frame.origin.y, 0};
    ForceSum      sum;
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == body)
        {
          const Vector3 f = {nodal[4 * n], nodal[4 * n + 1], nodal[4 * n + 2]};
          sum.force       = sum.force + f;
          sum.moment      = sum.moment + cross(solid.position(n) - about, f);
        }
    return sum;
  }

  /// Power of the forces of the last evaluation at the velocities of now [W].
  double
  contact_power(const Model &model)
  {
    const Solid          &solid = model.solid;
    AlignedVector<double> nodal(solid.force.size(), 0.);
    model.contact->add_forces(nodal.data());
    double power = 0;
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.owns(n) == 1)
        for (int i = 0; i < 3; ++i)
          power += nodal[4 * n + i] * solid.velocity[4 * n + i];
    MPI_Allreduce(MPI_IN_PLACE, &power, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return power;
  }

  void
  action_and_reaction(Model &model)
  {
    const double spacing = model.contact->lattice().spacing_along, radius = model.geometry.rolling_radius;
    const Motion motion{60e-6, 0.3 * spacing, 0.4 * spacing / radius};
    place(model, motion, {0.1, 0, 0.2});
    const ContactSums sums  = model.contact->evaluate(1e-7);
    const ForceSum    wheel = force_sum(model, Body::wheel), rail = force_sum(model, Body::rail);
    const double      F = norm(sums.force);
    std::cout << "        force " << 1e-3 * F << " kN on " << sums.nodes << " nodes\n";
    BOOST_TEST(near(
      norm(wheel.force - sums.force) / F, 0, 1e-12, "force on the wheel's nodes is the sum of the contact"));
    BOOST_TEST(
      near(norm(wheel.force + rail.force) / F, 0, 1e-12, "forces on both bodies are equal and opposite"));
    // they act at both ends of the gap: what is left is the gap's tangential part and the shear over the gap
    BOOST_TEST(near(1e6 * norm(wheel.moment + rail.moment) / F,
                    0,
                    0.2,
                    "lever that the sum of both moments leaves, at 60 um of penetration [um]"));
    BOOST_TEST((sums.force[1] > 0 && sums.force[2] < 0), "the wheel is pushed up and held back");
    double twice = 0;
    for (const auto &spring : model.contact->springs())
      {
        const ContactNode &node = model.contact->nodes()[spring.point];
        const double       p    = node.pressure - -model.contact->law().stiffness * node.gap;
        const Vector3      v    = {0.1, 0, 0.2};
        twice                   = std::max(
          twice, std::abs(p + model.contact->law().damping * dot(v, node.normal)) / sums.largest_pressure);
      }
    BOOST_TEST(near(twice, 0, 1e-12, "pressure is stiffness x penetration + damping x closing speed"));
  }

  /// A wheel moved by many cells, as friction bends it aside in the static start, presses all the same.
  void
  springs_reach_any_foot(Model &model)
  {
    for (const double cells : {0., 1.6, 5.3})
      {
        place(model, {60e-6, cells * model.contact->lattice().spacing_along, 0});
        const ContactSums sums    = model.contact->evaluate(0);
        const auto        springs = model.contact->springs();
        double            normal  = 0; // largest sum of the weights: a rigid motion must not stretch a spring
        for (const auto &spring : springs)
          {
            double sum = 0;
            for (const auto &[node, weight] : spring.nodes)
              sum += weight;
            normal = std::max(normal, std::abs(sum));
          }
        BOOST_TEST((sums.nodes > 40 && springs.size() == std::size_t(sums.nodes) && normal < 1e-12),
                   std::to_string(springs.size()) + " springs at " + std::to_string(sums.nodes) +
                     " pressed nodes, the wheel " + std::to_string(cells) + " cells ahead");
      }
  }

  void
  coulomb_friction(Model &model)
  {
    const ContactLaw &law  = model.contact->law();
    const double      step = 1e-7;
    for (const double down : {-1e-3, 60e-6}) // lifted, so that no history is left
      {
        place(model, {down, 0, 0});
        model.contact->evaluate(0);
      }
    // slow enough to stick everywhere but at the very edge: the shear grows by stiffness x way
    const double slow   = 1e-3 * law.friction.at_rest * 60e-6 / step;
    double       excess = 0, stick = 0, tilt = 0;
    ContactSums  sums;
    for (int n = 1; n <= 20; ++n)
      {
        place(model, {60e-6, 0, 0}, {0, 0, slow});
        sums = model.contact->evaluate(step);
        for (const auto &node : model.contact->nodes())
          {
            excess = std::max(excess, norm(node.traction) - law.friction.at_rest * node.pressure);
            tilt   = std::max(tilt, std::abs(dot(node.elastic, node.normal)));
            if (node.pressure > 0.2 * sums.largest_pressure)
              {
                const double along = slow * (1 - node.normal[2] * node.normal[2]);
                stick              = std::max(stick,
                                 std::abs(node.elastic[2] / (law.stiffness * n * step * along) - 1) +
                                   (node.slipping ? 1 : 0));
              }
          }
      }
    BOOST_TEST(near(stick, 0, 1e-3, "small slip sticks: shear is stiffness x way"));
    BOOST_TEST(
      near(excess / sums.largest_pressure, 0, 1e-12, "shear traction never exceeds friction x pressure"));
    BOOST_TEST(near(tilt / sums.largest_pressure, 0, 1e-12, "the shear history lies in the tangent plane"));
    BOOST_TEST(near(
      sums.friction_power / (-sums.force[2] * slow), 0, 0.02, "sticking: share of friction in the work"));

    for (int n = 1; n <= 200; ++n)
      {
        place(model, {60e-6, 0, 0}, {0, 0, 100 * slow});
        sums = model.contact->evaluate(step);
        for (const auto &node : model.contact->nodes())
          excess = std::max(excess, norm(node.traction) - law.friction.at_rest * node.pressure);
      }
    BOOST_TEST(near(excess / sums.largest_pressure, 0, 1e-12, "full slip: the bound holds"));
    BOOST_TEST(near(-sums.force[2] / (law.friction.at_rest * sums.normal_force),
                    1,
                    1e-3,
                    "full slip: force is friction x normal force"));
    BOOST_TEST(
      near(sums.friction_power / (-sums.force[2] * 100 * slow), 1, 1e-3, "full slip: all work is friction"));

    // lowered further and tilted: history must follow the new normals
    place(model, {70e-6, 0, 0.002}, {0, 0, -slow});
    model.contact->evaluate(step);
    for (const auto &node : model.contact->nodes())
      tilt = std::max(tilt, std::abs(dot(node.elastic, node.normal)));
    BOOST_TEST(near(
      tilt / sums.largest_pressure, 0, 1e-12, "turned wheel: the shear history lies in the tangent plane"));
  }

  /// A wheel pressed on, dragged, turned and lifted along a given path: contact work against energy.
  void
  work_is_energy(Model &model)
  {
    Contact     &contact = *model.contact;
    const int    n_steps = 800;
    const double step = 2e-7, spacing = contact.lattice().spacing_along,
                 radius = model.geometry.rolling_radius;
    const auto at       = [&](const double t) {
      return Motion{60e-6 * std::pow(std::sin(M_PI * t), 2) - 5e-6,
                    0.5 * spacing * t,
                    0.5 * spacing * (t + 0.1 * t * t) / radius};
    };
    const auto velocity = [&](double t, Vector3 &linear, double &rate) {
      const double d = 1e-6;
      const Motion a = at(t - d), b = at(t + d);
      const double f = 1 / (2 * d * n_steps * step);
      linear         = {0, -f * (b.down - a.down), f * (b.along - a.along)};
      rate           = f * (b.angle - a.angle);
    };
    double      work = 0, dissipated = 0, stored = 0, half_work = 0, half_energy = 0, friction = 0;
    ContactSums sums;
    for (int n = 0; n <= n_steps; ++n)
      {
        // the place at the full step, the velocities at the half steps around it
        for (const double half : {-0.5, 0.5})
          {
            Vector3 linear;
            double  rate;
            velocity((n + half) / n_steps, linear, rate);
            place(model, at(double(n) / n_steps), linear, rate);
            if (half < 0)
              sums = contact.evaluate(step);
            work += 0.5 * step * contact_power(model);
          }
        dissipated += step * (sums.friction_power + sums.damping_power);
        friction += step * sums.friction_power;
        if (n == n_steps / 2)
          {
            half_work   = work;
            half_energy = sums.stored_energy + dissipated;
          }
      }
    stored = sums.stored_energy;
    std::cout << "        work up to the middle " << half_work << " J, friction " << friction << " J, in all "
              << work << " J\n";
    BOOST_TEST(near(
      -half_work / half_energy, 1, 0.01, "pressed on and dragged: work over stored and dissipated energy"));
    BOOST_TEST(near(-work / (stored + dissipated), 1, 0.02, "lifted again: work over dissipated energy"));
    BOOST_TEST(near(stored, 0, 0, "nothing stays stored [J]"));
    BOOST_TEST(friction > 0.1 * dissipated, "friction takes part");
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(contact, test::Parallel)
{
  Model model = test::small_model(MPI_COMM_WORLD, 2e-3);
  undeformed_distance_is_met(model);
  no_cogging(model);
  action_and_reaction(model);
  springs_reach_any_foot(model);
  coulomb_friction(model);
  work_is_energy(model);
  many_rows();
}
