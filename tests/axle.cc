// The rigid axle by itself: free fall, suspension, pitch under torque, energy, and bore nodes that follow.

#include <wheelrail/solid/boundary_nodes.h>
#include <wheelrail/wheelset/axle.h>

#include "parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

using namespace wheelrail;
using namespace test;

namespace
{
  /// A ring of hexahedra whose inner faces are the bore; its outer nodes take no part.
  Solid
  hub(const AxleData &data)
  {
    constexpr unsigned int n = 24;
    LocalMesh              mesh;
    for (unsigned int s = 0; s < n; ++s)
      for (unsigned int r = 0; r < 2; ++r)
        for (unsigned int x = 0; x < 2; ++x)
          {
            const double  radius = r == 0 ? 0.0925 : 0.13, angle = 2 * M_PI * s / n;
            const Vector3 down = {data.axis[1], -data.axis[0], 0};
            Vector3       X    = data.centre;
            add(X, 0.175 * (x - 0.5), data.axis);
            add(X, radius * std::cos(angle), down);
            X[2] += radius * std::sin(angle);
            mesh.global_node.push_back(mesh.n_nodes());
            mesh.reference.insert(mesh.reference.end(), {X[0], X[1], X[2], 0.});
          }
    const auto node = [](unsigned int s, unsigned int r, unsigned int x) { return (s % n * 2 + r) * 2 + x; };
    for (unsigned int s = 0; s < n; ++s)
      {
        std::array<unsigned int, 8> cell;
        for (unsigned int a = 0; a < 8; ++a)
          cell[a] = node(s + (a >> 2), 1 - (a >> 1 & 1), a & 1);
        mesh.cells.push_back(cell);
        mesh.faces.push_back({{node(s, 0, 0), node(s, 0, 1), node(s + 1, 0, 0), node(s + 1, 0, 1)},
                              Boundary::bore,
                              Body::wheel,
                              static_cast<unsigned int>(mesh.cells.size() - 1),
                              false,
                              false});
      }
    mesh.cell_body.assign(n, Body::wheel);
    mesh.cell_level.assign(n, 0);
    mesh.node_body.assign(mesh.n_nodes(), Body::wheel);
    mesh.owned.assign(mesh.n_nodes(), 1);
    mesh.hanging_begin = {0};
    return make_solid(mesh, Elasticity(), Elasticity(), 0, MPI_COMM_WORLD);
  }

  Axle
  make_axle(const AxleData &data, const Solid &solid, const double lift, const double rate)
  {
    Axle                     axle(data, lift, rate, MPI_COMM_WORLD);
    std::vector<NodeInertia> inertia = node_inertia(solid);
    axle.prepare(solid, inertia);
    return axle;
  }

  void
  make_step(Axle &axle, Solid &solid, const double step, const bool first)
  {
    axle.constrain({0, step, make_kick(first ? step / 2 : step), first, false}, solid, {});
  }

  /// Mass of the bore nodes and their inertia about the axis, by their places.
  struct BoreMass
  {
    double mass = 0, inertia = 0;
  };

  BoreMass
  bore_mass(const Solid &solid)
  {
    BoreMass sum;
    for (const unsigned int n : boundary_nodes(solid.mesh, Boundary::bore))
      {
        sum.mass += solid.mass[n];
        sum.inertia += solid.mass[n] * 0.0925 * 0.0925;
      }
    return sum;
  }

  /// Weight of the bore nodes as nodal forces, and a force `up` and a moment about the axis shared by them.
  void
  load(Solid &solid, const Axle &axle, const double gravity, const double up, const double moment)
  {
    std::fill(solid.force.begin(), solid.force.end(), 0.);
    const double  n   = axle.bore().size();
    const Vector3 now = axle.data().centre + Vector3{0, axle.height(), axle.travelled()};
    for (const unsigned int b : axle.bore())
      {
        const Vector3 arm    = solid.position(b) - now;
        const Vector3 around = cross(axle.data().axis, arm);
        solid.force[4 * b + 1] += up / n - solid.mass[b] * gravity;
        for (int i = 0; i < 3; ++i)
          solid.force[4 * b + i] += moment / n / dot(around, around) * around[i];
      }
  }

  /// Largest distance of the bore nodes from the rigid motion of the axle.
  double
  distance_from_axle(const Solid &solid, const Axle &axle)
  {
    double        largest = 0;
    const Vector3 now     = axle.data().centre + Vector3{0, axle.height(), axle.travelled()};
    for (const unsigned int n : axle.bore())
      {
        const double *R   = &solid.mesh.reference[4 * n];
        const Vector3 arm = Vector3{R[0], R[1], R[2]} - axle.data().centre;
        largest           = std::max(
          largest, norm(solid.position(n) - now - rotated(arm, axle.data().axis, axle.pitch_angle())));
      }
    return largest;
  }

  AxleData
  inclined_axle()
  {
    AxleData data;
    data.centre   = {0.1, 0.46, 0};
    data.axis     = {std::cos(0.01), std::sin(0.01), 0};
    data.velocity = 140 / 3.6;
    return data;
  }

  void
  free_fall()
  {
    AxleData data    = inclined_axle();
    data.sprung_mass = data.stiffness = data.damping = 0;
    Solid        solid                               = hub(data);
    Axle         axle                                = make_axle(data, solid, 0, 0);
    const double step = 1e-5, t = 1000 * step;
    double       worst = 0;
    for (int n = 0; n < 1000; ++n)
      {
        load(solid, axle, data.gravity, 0, 0);
        make_step(axle, solid, step, n == 0);
        worst = std::max(worst, distance_from_axle(solid, axle));
      }
    check(axle.bore().size() == 48, "bore nodes are found by their faces");
    check_near(axle.height() / (-0.5 * data.gravity * t * t), 1, 1e-9, "free fall: height");
    check_near(axle.travelled(), data.velocity * t, 1e-12, "free fall: way along the track [m]");
    check_near(worst, 0, 1e-14, "free fall: bore nodes follow [m]");
    check_near(axle.reaction()[1] / (-bore_mass(solid).mass * data.gravity),
               1,
               1e-12,
               "reaction is the weight of the bore nodes");
    const AxleEnergy e = axle.energy();
    // kinetic energy half a step behind, potential energy of axle without the bore nodes
    const double v = data.gravity * (t - step / 2), total = data.mass + bore_mass(solid).mass;
    check_near(e.kinetic / (0.5 * total * v * v), 1, 1e-9, "free fall: kinetic energy with the bore nodes");
    check_near(e.potential / (-data.mass * data.gravity * 0.5 * data.gravity * t * t),
               1,
               1e-9,
               "free fall: potential energy");
  }

  /// Axle on a spring c (as a contact would be) under its suspension: two frequencies and their damping.
  void
  suspension()
  {
    const AxleData data  = inclined_axle();
    Solid          solid = hub(data);
    const double   lift = -1e-4, c = 1e9, step = 2e-5;
    Axle           axle        = make_axle(data, solid, lift, 0);
    const double   axle_mass   = data.mass + bore_mass(solid).mass;
    const double   static_load = (data.sprung_mass + axle_mass) * data.gravity;
    for (int n = 0; n < 100; ++n)
      {
        load(solid, axle, data.gravity, static_load, 0);
        make_step(axle, solid, step, n == 0);
      }
    check_near(axle.height() - lift, 0, 1e-15, "static load: the axle stays [m]");

    // kicked by a force for one step, the axle swings on c and the suspension
    double    start = 0, before = 0, worst = 0, largest = 0, crossings = 0, first = 0, last = 0, height = 0;
    const int n_steps           = 40000;
    const double constant_force = static_load - bore_mass(solid).mass * data.gravity;
    for (int n = 0; n < n_steps; ++n)
      {
        const double     q   = axle.height() - lift;
        const AxleEnergy old = axle.energy();
        load(solid, axle, data.gravity, static_load - c * q + (n == 0 ? 1e5 : 0.), 0);
        make_step(axle, solid, step, false);
        // all at the full step before: kinetic energy and damper from the half steps around it
        const AxleEnergy e     = axle.energy();
        const double     Q     = axle.height() - lift;
        const double     total = 0.5 * (before + e.kinetic) + old.potential + 0.5 * (old.damped + e.damped) +
                             0.5 * c * q * q - constant_force * q;
        if (n == 1)
          start = total;
        largest = std::max(largest, e.kinetic);
        if (n > 1)
          worst = std::max(worst, std::abs(total - start));
        before = e.kinetic;
        if (height < 0 && Q >= 0)
          {
            const double at = n + 1 - Q / (Q - height);
            if (crossings == 0)
              first = at;
            last = at;
            ++crossings;
          }
        height = Q;
      }
    const double period = step * (last - first) / (crossings - 1);
    const double omega  = std::sqrt((c + data.stiffness) / axle_mass);
    check_near(2 * M_PI / period / omega, 1, 5e-4, "frequency on contact spring and suspension");
    const double decay = data.damping / (2 * axle_mass);
    std::cout << "        decay " << decay << " 1/s over " << n_steps * step << " s\n";
    check_near(worst / largest,
               0,
               0.005,
               "suspension: largest error of the energy balance over the largest kinetic energy");
    check(axle.energy().damped > 0, "suspension: the damper takes energy");
  }

  /// Sprung mass against axle: relative swing of the two without a contact.
  void
  sprung_mass()
  {
    AxleData data          = inclined_axle();
    data.sprung_mass       = 300;
    data.damping           = 0;
    Solid        solid     = hub(data);
    Axle         axle      = make_axle(data, solid, 0, 0);
    const double axle_mass = data.mass + bore_mass(solid).mass,
                 load_up   = (data.sprung_mass + axle_mass) * data.gravity;
    const double omega = std::sqrt(data.stiffness * (1 / axle_mass + 1 / data.sprung_mass)), step = 2e-5;
    const int    n_steps = static_cast<int>(10 * 2 * M_PI / omega / step);
    const double impulse = 1e5 * step;
    for (int n = 0; n < n_steps; ++n)
      {
        load(solid, axle, data.gravity, load_up + (n == 1 ? 1e5 : 0.), 0);
        make_step(axle, solid, step, n == 0);
      }
    // after ten periods the relative motion is back; both have moved on with the common velocity
    const double t = step * (n_steps - 1), together = impulse / (axle_mass + data.sprung_mass);
    const double own = impulse * data.sprung_mass / (axle_mass * (axle_mass + data.sprung_mass)) / omega;
    check_near(axle.height(),
               together * t + own * std::sin(omega * t),
               0.005 * own,
               "axle and sprung mass: height after ten swings [m]");
  }

  void
  pitch()
  {
    AxleData data      = inclined_axle();
    data.torque        = 11500;
    Solid        solid = hub(data);
    const double rate = 84.5, step = 1e-5,
                 load_up = (data.sprung_mass + data.mass + bore_mass(solid).mass) * data.gravity;
    Axle         axle    = make_axle(data, solid, 0, rate);
    const double moment = -4000, inertia = data.pitch_inertia + bore_mass(solid).inertia, t = 1000 * step;
    double       worst = 0;
    const double start = axle.energy().kinetic;
    for (int n = 0; n < 1000; ++n)
      {
        load(solid, axle, data.gravity, load_up, moment);
        make_step(axle, solid, step, n == 0);
        worst = std::max(worst, distance_from_axle(solid, axle));
      }
    // the rate belongs to half a step before
    const double gain = (data.torque + moment) / inertia * (t - step / 2);
    check_near(axle.pitch_rate() - rate, gain, 1e-9 * gain, "pitch rate under torque and moment [rad/s]");
    check_near(
      axle.pitch_angle(), rate * t + (data.torque + moment) / inertia * t * t / 2, 1e-9, "pitch angle [rad]");
    check_near(worst, 0, 1e-13, "pitch: bore nodes follow [m]");
    const AxleEnergy e = axle.energy();
    check_near((e.kinetic - start) / (e.torque_work * (1 + moment / data.torque)),
               1,
               1e-9,
               "pitch: kinetic energy is the work of torque and moment");
    check_near(axle.reaction()[2], 0, 1e-9, "pitch: the moment pushes nowhere [N]");

    data.rate_held = true;
    std::fill(solid.displacement.begin(), solid.displacement.end(), 0.);
    Axle held = make_axle(data, solid, 0, rate);
    for (int n = 0; n < 100; ++n)
      {
        load(solid, held, data.gravity, load_up, moment);
        for (const unsigned int b : held.bore())
          solid.force[4 * b + 2] += 10;
        make_step(held, solid, step, n == 0);
      }
    check_near(held.pitch_rate() - rate, 0, 0, "held rate stays [rad/s]");
    check_near(held.applied_torque() / -moment, 1, 1e-9, "held rate: torque balances the moment");
    check_near(
      held.energy().torque_work / (-moment * rate * (99.5 * step)), 1, 1e-9, "held rate: work of the torque");
    check_near(held.energy().hold_work / (-480 * data.velocity * 99.5 * step),
               1,
               1e-9,
               "work of the force that holds the speed");
  }
} // namespace

int
main(int argc, char **argv)
{
  Parallel parallel(argc, argv);
  free_fall();
  suspension();
  sprung_mass();
  pitch();
  return parallel.report();
}
