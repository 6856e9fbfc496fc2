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

    StartTractions
    wanted_tractions(const Solid &solid, const Contact &contact, const StaticLoads &loads, const double load)
    {
      const StartBodies bodies = {solid.blocks[0].material, solid.blocks[1].material};
      return loads.rate_held ? start_tractions_at_creepage(contact, loads.creepage, bodies)
                             : start_tractions(contact, loads.traction_coefficient * load, bodies);
    }

    /// What is out of balance in one position.
    struct Balance
    {
      Vector      residual; ///< forces on the free unknowns [N]
      double      bore = 0; ///< vertical force on bore and axle [N]
      ContactSums sums;     ///< of the contact
    };

    /// A change of position: of the free unknowns and of the height of the bore.
    struct Step
    {
      Vector increment;
      double lift = 0; ///< [m]
    };

    /// The search for the position in which the forces balance.
    class Search
    {
    public:
      Search(const Forest &forest, Solid &solid, Contact &contact, const StaticLoads &loads)
        : solid_(solid)
        , contact_(contact)
        , loads_(loads)
        , sum_(solid.mesh, forest.communicator())
        , system_(forest, solid, contact)
        , lifted_(system_.owned_vector())
      {
        wheel_mass_ = mass_properties(solid, Body::wheel, loads.axle.centre, forest.communicator()).mass;
        rate_       = loads.axle.velocity / loads.rolling_radius;
        press();
      }

      double
      wheel_load() const
      {
        return (loads_.axle.sprung_mass + loads_.axle.mass + wheel_mass_) * loads_.axle.gravity;
      }
      Balance
      balance();
      Step
      newton_step(const Balance &balance, bool coarse);
      double
      power(const Balance &balance, const Step &step) const;
      void
      move(const Step &step, double factor);
      Balance
      search_along(const Step &step, const Balance &start);
      bool
      renew_tractions();
      void
      set_tractions();

      StartTractions tractions; ///< the given ones; none before the first renewal
      double         lift     = 0;
      unsigned int   cg_steps = 0;

    private:
      void
      press();
      ContactSums
      contact_forces(const std::vector<Vector3> *shear, AlignedVector<double> &force);

      Solid                    &solid_;
      Contact                  &contact_;
      const StaticLoads        &loads_;
      SharedSum                 sum_;
      StaticSystem              system_;
      Vector                    lifted_;         ///< increment per metre of lift with the present springs
      std::vector<unsigned int> preconditioned_; ///< contact points whose springs the preconditioner knows
      double                    wheel_mass_ = 0, rate_ = 0;
      AlignedVector<double>     drag_;       ///< nodal forces of the tractions [N]
      Vector3                   drag_sum_{}; ///< on the wheel [N]
    };


    /// Presses the bodies into each other rigidly: the part of the undeformed profiles that dips in by some
    /// 0.55 of the approach is close to the true patch.
    void
    Search::press()
    {
      lift = -0.55 * loads_.first_approach;
      for (unsigned int n = 0; n < solid_.mesh.n_nodes(); ++n)
        if (solid_.mesh.node_body[n] == Body::wheel)
          solid_.displacement[4 * n + 1] = lift;
    }


    /// Contact, internal and external forces of the present displacement, condensed and summed. The
    /// tractions are loads here, whatever the pressures: a bound that follows them would leave no potential.
    Balance
    Search::balance()
    {
      AlignedVector<double> force(solid_.force.size(), 0.);
      ElementEnergy         ignored;
      for (auto &blocks : solid_.blocks)
        subtract_internal_force(
          blocks, solid_.displacement.data(), force.data(), BulkViscosity(), false, ignored);
      condense(solid_.mesh, force.data());
      sum_(force.data());
      add_wheel_loads(solid_, loads_.axle, rate_, force);
      contact_.gather(solid_.displacement.data(), solid_.velocity.data());
      Balance balance;
      balance.sums = contact_forces(nullptr, force);
      for (std::size_t k = 0; k < drag_.size(); ++k)
        force[k] += drag_[k];
      balance.sums.force = balance.sums.force + drag_sum_;
      balance.residual   = system_.to_dofs(solid_.mesh, force);
      balance.bore       = system_.bore_force(solid_.mesh, force) -
                     (loads_.axle.sprung_mass + loads_.axle.mass) * loads_.axle.gravity;
      return balance;
    }


    /// Adds the forces of contact with these tractions, bounded by friction; null: without.
    ContactSums
    Search::contact_forces(const std::vector<Vector3> *shear, AlignedVector<double> &force)
    {
      for (std::size_t k = 0; k < contact_.nodes().size(); ++k)
        contact_.set_shear(k, shear ? (*shear)[k] : Vector3{});
      const ContactSums sums = contact_.evaluate(0);
      contact_.add_forces(force.data());
      return sums;
    }


    /// Newton's step with the springs of the moment; `coarse` while the patch still changes, when the step
    /// needs no more than can be used of it. The lift restores the vertical balance.
    Step
    Search::newton_step(const Balance &balance, const bool coarse)
    {
      const auto springs = contact_.springs();
      system_.load_springs(springs);
      // a preconditioner of another patch costs three times the steps
      std::vector<unsigned int> active;
      for (const auto &spring : springs)
        active.push_back(spring.point);
      if (active != preconditioned_)
        system_.make_preconditioner(solid_.mesh);
      preconditioned_ = active;
      Step step{system_.owned_vector(), 0};
      cg_steps += system_.solve(balance.residual, step.increment, coarse ? 1e-2 : 1e-3);
      cg_steps += system_.solve_lift(solid_.mesh, lifted_, 1e-2);
      const double missing = wheel_load() - balance.sums.force[1];
      step.lift            = (missing - system_.vertical_change(springs, step.increment)) /
                  system_.vertical_change(springs, lifted_);
      step.increment.add(step.lift, lifted_);
      return step;
    }


    /// Work of the forces out of balance along a step [J]: minus the slope of the potential energy.
    double
    Search::power(const Balance &balance, const Step &step) const
    {
      return balance.residual * step.increment + balance.bore * step.lift;
    }


    void
    Search::move(const Step &step, const double factor)
    {
      Vector increment = step.increment;
      increment *= factor;
      system_.add_to_nodes(solid_.mesh, increment, factor * step.lift, solid_.displacement);
      lift += factor * step.lift;
    }


    /// Goes along the step to where the potential energy no longer falls: regula falsi (Illinois) for the
    /// work of the forces, which the closing and opening of nodes bends. Full steps can turn in circles
    /// between two patches, as in the flange root; the energy of penalty contact is convex, so that steps
    /// to its minimum do not.
    Balance
    Search::search_along(const Step &step, const Balance &start)
    {
      const double first = power(start, step), before = start.residual.linfty_norm();
      double       at = 0, low = 0, high = 1, power_low = first, power_high = 0;
      double       next = 1, last = 0;
      Balance      balance;
      for (int trial = 0; trial < 12; ++trial)
        {
          move(step, next - at);
          at                 = next;
          balance            = this->balance();
          const double value = power(balance, step);
          const bool   good  = trial == 0 && (value > 0 || balance.residual.linfty_norm() < 0.5 * before);
          if (good || first <= 0 || std::abs(value) < 0.1 * first)
            break;
          const bool same_end = value * last > 0;
          if (value > 0)
            {
              low = at, power_low = value;
              power_high *= same_end ? 0.5 : 1;
            }
          else
            {
              high = at, power_high = value;
              power_low *= same_end ? 0.5 : 1;
            }
          last = value;
          next = low + (high - low) * power_low / (power_low - power_high);
        }
      return balance;
    }


    /// Tractions for the present pressures as loads, and the rate of turning that goes with them. Whether
    /// creepage or force have changed by more than 1e-5.
    bool
    Search::renew_tractions()
    {
      const StartTractions before = std::move(tractions);
      tractions                   = wanted_tractions(solid_, contact_, loads_, wheel_load());
      rate_                       = loads_.axle.velocity / loads_.rolling_radius * (1 + tractions.creepage);
      if (!loads_.tractions)
        tractions.shear.assign(tractions.shear.size(), Vector3{});
      drag_.assign(solid_.force.size(), 0.);
      AlignedVector<double> pressures(solid_.force.size(), 0.);
      drag_sum_ = contact_forces(&tractions.shear, drag_).force - contact_forces(nullptr, pressures).force;
      for (std::size_t k = 0; k < drag_.size(); ++k)
        drag_[k] -= pressures[k];
      return std::abs(tractions.creepage - before.creepage) > 1e-5 * std::abs(tractions.creepage) ||
             std::abs(tractions.force - before.force) > 1e-5 * wheel_load();
    }


    /// Sets the tractions in the contact, bounded by its pressures.
    void
    Search::set_tractions()
    {
      AlignedVector<double> ignored(solid_.force.size(), 0.);
      if (!tractions.shear.empty())
        contact_forces(&tractions.shear, ignored);
    }
  } // namespace


  StaticResult
  static_start(const Forest                           &forest,
               Solid                                  &solid,
               Contact                                &contact,
               const StaticLoads                      &loads,
               const std::function<void(std::string)> &report)
  {
    constexpr int          most_steps = 60;
    const ElasticMeanwhile rail(solid.blocks[0]), wheel(solid.blocks[1]);
    report("static start: assembling the stiffness");
    Search       search(forest, solid, contact, loads);
    StaticResult result;
    result.wheel_load = search.wheel_load();

    // rounds of tractions still to come: they change the pressures that bound them
    int     rounds  = frictionless(contact.law().friction) ? 0 : 12;
    Balance balance = search.balance();
    for (int step = 0;; ++step)
      {
        result.residual      = balance.residual.linfty_norm() / result.wheel_load;
        const double missing = result.wheel_load - balance.sums.force[1];
        const bool   settled = result.residual < 2e-6 && std::abs(missing) < 1e-5 * result.wheel_load;
        if (settled || (rounds > 0 && result.residual < 1e-3))
          {
            const bool changed = rounds > 0 && search.renew_tractions();
            if (settled && !changed)
              break;
            --rounds;
            balance = search.balance();
          }
        if (step == most_steps)
          throw RunError("the static start did not converge: after " + std::to_string(most_steps) +
                         " steps " + std::to_string(missing) +
                         " N of the wheel load are missing; lower Contact/Penalty scale or refine the mesh");
        balance = search.search_along(search.newton_step(balance, result.residual > 1e-3), balance);
        if (balance.sums.nodes == 0)
          throw RunError(
            "the static start lost the contact between wheel and rail; give a smaller first approach");
        result.newton_steps = step + 1;
      }
    search.set_tractions();
    result.lift          = search.lift;
    result.cg_steps      = search.cg_steps;
    result.contact_force = balance.sums.force;
    result.creepage      = search.tractions.creepage;
    if (frictionless(contact.law().friction))
      result.creepage = loads.rate_held ? loads.creepage : 0;
    if (search.tractions.saturated)
      report("static start: the torque is beyond friction x wheel load; the wheel will spin up");
    if (!search.tractions.converged)
      report(
        "static start: the half-space solver did not reach its tolerance; the tractions of the start are "
        "less exact");
    return result;
  }
} // namespace wheelrail
