#include <wheelrail/base/errors.h>
#include <wheelrail/dynamics/start_tractions.h>
#include <wheelrail/dynamics/static_start.h>
#include <wheelrail/dynamics/static_system.h>
#include <wheelrail/solid/elastic_meanwhile.h>

#include <cmath>

namespace wheelrail
{
  namespace
  {
    using Vector = StaticSystem::Vector;

    /// Weight and centrifugal load of the wheel, per node.
    void
    add_wheel_loads(const Solid &solid, const AxleData &axle, const double rate, AlignedVector<double> &force)
    {
      for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
        if (solid.mesh.node_body[n] == Body::wheel)
          {
            const double *X      = &solid.mesh.reference[4 * n];
            const Vector3 arm    = Vector3{X[0], X[1], X[2]} - axle.centre;
            const Vector3 radial = arm - dot(arm, axle.axis) * axle.axis;
            for (int i = 0; i < 3; ++i)
              force[4 * n + i] += solid.mass[n] * rate * rate * radial[i];
            force[4 * n + 1] -= solid.mass[n] * axle.gravity;
          }
    }

    /// Contact, internal and external forces of the present displacement, condensed and summed.
    AlignedVector<double>
    out_of_balance(Solid          &solid,
                   Contact        &contact,
                   SharedSum      &sum,
                   const AxleData &axle,
                   const double    rate,
                   ContactSums    &sums)
    {
      AlignedVector<double> force(solid.force.size(), 0.);
      ElementEnergy         ignored;
      for (auto &blocks : solid.blocks)
        subtract_internal_force(
          blocks, solid.displacement.data(), force.data(), BulkViscosity(), false, ignored);
      condense(solid.mesh, force.data());
      sum(force.data());
      add_wheel_loads(solid, axle, rate, force);
      contact.gather(solid.displacement.data(), solid.velocity.data());
      sums = contact.evaluate(0);
      contact.add_forces(force.data());
      return force;
    }

    StartTractions
    wanted_tractions(const Solid &solid, const Contact &contact, const StaticLoads &loads, const double load)
    {
      const StartBodies bodies = {solid.blocks[0].material, solid.blocks[1].material};
      return loads.rate_held ? start_tractions_at_creepage(contact, loads.creepage, bodies)
                             : start_tractions(contact, loads.traction_coefficient * load, bodies);
    }
  } // namespace


  StaticResult
  static_start(const Forest                           &forest,
               Solid                                  &solid,
               Contact                                &contact,
               const StaticLoads                      &loads,
               const std::function<void(std::string)> &report)
  {
    const ElasticMeanwhile rail(solid.blocks[0]), wheel(solid.blocks[1]);
    MPI_Comm               communicator = forest.communicator();
    SharedSum              sum(solid.mesh, communicator);
    StaticResult           result;
    result.wheel_load = (loads.axle.sprung_mass + loads.axle.mass +
                         mass_properties(solid, Body::wheel, loads.axle.centre, communicator).mass) *
                        loads.axle.gravity;

    report("static start: assembling the stiffness");
    StaticSystem system(forest, solid, contact);

    // begin with the bodies pressed into each other rigidly; the part of the undeformed profiles that
    // dips in by some 0.55 of the approach is close to the true patch
    Vector increment = system.owned_vector(), lifted = system.owned_vector();
    result.lift = -0.55 * loads.first_approach;
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == Body::wheel)
        solid.displacement[4 * n + 1] = result.lift;

    std::vector<unsigned int> preconditioned; // contact points whose springs the preconditioner knows
    double                    rate = loads.axle.velocity / loads.rolling_radius;
    // rounds of tractions still to come: they change the pressures that bound them
    int rounds = frictionless(contact.law().friction) ? 0 : 4;
    // the given tractions, set in every step: an iterate that unloads a node must not erase its own for good
    StartTractions tractions;
    // the last step, to be shortened when it throws the wheel off or makes the balance much worse
    AlignedVector<double> before;
    double                lift = 0, last_residual = 0;
    int                   halvings = 0;
    for (int step = 0; step < 60; ++step)
      {
        for (std::size_t k = 0; k < tractions.shear.size(); ++k)
          contact.set_shear(k, tractions.shear[k]);
        ContactSums  sums;
        auto         force    = out_of_balance(solid, contact, sum, loads.axle, rate, sums);
        const Vector residual = system.to_dofs(solid.mesh, force);
        result.residual       = residual.linfty_norm() / result.wheel_load;
        result.contact_force  = sums.force;
        result.newton_steps   = step;
        const bool worse      = sums.nodes == 0 || result.residual > 4 * last_residual;
        if (step > 0 && worse && last_residual > 0 && halvings < 6)
          {
            ++halvings;
            solid.displacement = before;
            increment *= 0.5;
            result.lift -= 0.5 * lift;
            lift *= 0.5;
            system.add_to_nodes(solid.mesh, increment, lift, solid.displacement);
            continue;
          }
        if (sums.nodes == 0)
          throw RunError(
            "the static start lost the contact between wheel and rail; give a smaller first approach");
        halvings             = 0;
        last_residual        = result.residual;
        const double missing = result.wheel_load - sums.force[1];
        if (result.residual < 2e-6 && std::abs(missing) < 1e-5 * result.wheel_load)
          {
            const bool met = !tractions.shear.empty() &&
                             std::abs(sums.force[2] - tractions.force) < 2e-4 * result.wheel_load;
            if (rounds == 0 || met)
              break;
            // normal contact has settled: tractions for these pressures, and on
            tractions       = wanted_tractions(solid, contact, loads, result.wheel_load);
            result.creepage = tractions.creepage;
            rate            = loads.axle.velocity / loads.rolling_radius * (1 + result.creepage);
            --rounds;
            last_residual = 0;
            continue;
          }
        if (step == 59)
          throw RunError("the static start did not converge: after 60 steps " + std::to_string(missing) +
                         " N of the wheel load are missing; lower Contact/Penalty scale or refine the mesh");

        const auto springs = contact.springs();
        system.load_springs(springs);
        // a preconditioner of another patch costs three times the steps
        std::vector<unsigned int> active;
        for (const auto &spring : springs)
          active.push_back(spring.point);
        const bool changed = active != preconditioned;
        if (changed)
          system.make_preconditioner(solid.mesh);
        preconditioned = active;
        increment      = 0;
        // Newton's steps need no more than they can use while the patch still changes
        result.cg_steps += system.solve(residual, increment, result.residual > 1e-3 ? 1e-2 : 1e-3);
        result.cg_steps += system.solve(system.lift_load(), lifted, 1e-2);
        // the lift that restores the vertical balance
        const double by_increment = system.vertical_change(springs, increment);
        const double by_lift      = system.vertical_change(springs, lifted);
        lift                      = (missing - by_increment) / by_lift;
        increment.add(lift, lifted);
        // full steps can turn in circles between two patches, as in the flange root: shorter ones end that
        if (changed && step > 8)
          {
            const double part = std::max(0.15, 3. / (step - 5));
            increment *= part;
            lift *= part;
          }
        before = solid.displacement;
        system.add_to_nodes(solid.mesh, increment, lift, solid.displacement);
        result.lift += lift;
      }
    if (frictionless(contact.law().friction))
      result.creepage = loads.rate_held ? loads.creepage : 0;
    if (tractions.saturated)
      report("static start: the torque is beyond friction x wheel load; the wheel will spin up");
    if (!tractions.converged)
      report(
        "static start: the half-space solver did not reach its tolerance; the tractions of the start are "
        "less exact");
    return result;
  }
} // namespace wheelrail
