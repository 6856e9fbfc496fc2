#include <wheelrail/dynamics/rolling.h>

#include <chrono>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Adds the seconds between its making and its end to a total.
    class Stopwatch
    {
    public:
      explicit Stopwatch(double &total)
        : total_(total)
        , start_(std::chrono::steady_clock::now())
      {
      }
      ~Stopwatch()
      {
        total_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
      }

    private:
      double                               &total_;
      std::chrono::steady_clock::time_point start_;
    };
  } // namespace


  Rolling::Rolling(Solid       &solid,
                   Contact     &contact,
                   Axle        &axle,
                   const double time_step,
                   const double bulk_viscosity,
                   MPI_Comm     communicator)
    : solid_(solid)
    , contact_(contact)
    , axle_(axle)
    , sum_(solid.mesh, communicator)
    , time_step_(time_step)
    , bulk_viscosity_(bulk_viscosity)
    , communicator_(communicator)
  {
    const std::size_t     n_nodes = solid.mesh.n_nodes();
    AlignedVector<double> fixed(4 * n_nodes, 0.);
    for (const Boundary mark : {Boundary::foot, Boundary::end, Boundary::bore})
      for (const unsigned int n : boundary_nodes(solid.mesh, mark))
        fixed[4 * n] = 1;
    sum_(fixed.data(), 1);
    inertia_.resize(n_nodes);
    for (unsigned int n = 0; n < n_nodes; ++n)
      {
        const double mass = solid.mass[n] + solid.added_mass[n];
        if (solid.mass[n] > 0 && fixed[4 * n] == 0)
          inertia_[n].inverse_mass = 1 / mass;
        if (solid.mesh.node_body[n] == Body::wheel && solid.mesh.owned[n])
          inertia_[n].weight = solid.mass[n] * axle.data().gravity;
        if (solid.mesh.node_body[n] == Body::wheel && solid.mass[n] > 0 && solid.added_mass[n] > 0)
          added_nodes_.push_back(n);
      }
    support_force_.resize(added_nodes_.size());
    start_forces(solid, inertia_);
  }


  void
  Rolling::step(const bool with_energy)
  {
    const bool first = steps_ == 0;
    // 1. internal forces of both bodies; the first call only records the dilatation
    {
      Stopwatch           watch(timing_.elements);
      const BulkViscosity viscosity{first ? 0. : bulk_viscosity_, bulk_viscosity_ > 0 ? time_step_ : 0.};
      elements_ = ElementEnergy();
      for (auto &blocks : solid_.blocks)
        subtract_internal_force(
          blocks, solid_.displacement.data(), solid_.force.data(), viscosity, with_energy, elements_);
      condense(solid_.mesh, solid_.force.data());
    }
    // 2. sums over ranks
    {
      Stopwatch watch(timing_.exchange);
      sum_(solid_.force.data());
    }
    // 3. contact
    {
      Stopwatch    watch(timing_.contact);
      const double wheel_ahead = contact_.surfaces().rolling_radius * axle_.pitch_angle() - axle_.travelled();
      contact_.move_window(axle_.travelled(), wheel_ahead);
      contact_.gather(solid_.displacement.data(), solid_.velocity.data());
      sums_ = contact_.evaluate(time_step_);
      contact_.add_forces(solid_.force.data());
    }
    // 4. loads, axle, free nodes
    Stopwatch watch(timing_.update);
    add_loads();
    const AxleEnergy axle_before    = axle_.energy();
    const double     support_before = support_work_;
    axle_.step(solid_, time_step_, first);
    const double kinetic = update_nodes(first, with_energy);
    time_ += time_step_;
    ++steps_;
    const double weight = first ? 0.5 * time_step_ : time_step_;
    viscous_ += time_step_ * elements_.viscous_power; // of the step behind
    friction_ += weight * sums_.friction_power;
    contact_damping_ += weight * sums_.damping_power;
    if (with_energy)
      balance(kinetic, axle_before, support_before);
  }


  void
  Rolling::add_loads()
  {
    // the added mass is turned by a force of its own: without it, it would pull at the rim
    const Vector3 centre = axle_.data().centre + Vector3{0, axle_.height(), axle_.travelled()};
    const double  rate2  = axle_.pitch_rate() * axle_.pitch_rate();
    for (std::size_t k = 0; k < added_nodes_.size(); ++k)
      {
        const unsigned int n      = added_nodes_[k];
        const Vector3      arm    = solid_.position(n) - centre;
        const Vector3      radial = arm - dot(arm, axle_.data().axis) * axle_.data().axis;
        support_force_[k]         = (-solid_.added_mass[n] * rate2) * radial;
        for (int i = 0; i < 3; ++i)
          solid_.force[4 * n + i] += support_force_[k][i];
      }
  }


  double
  Rolling::update_nodes(const bool first, const bool with_energy)
  {
    const double  kick = first ? time_step_ / 2 : time_step_;
    const double *v = solid_.velocity.data(), *f = solid_.force.data();
    // forces work with the mean of the velocities of both half steps
    for (std::size_t k = 0; k < added_nodes_.size(); ++k)
      if (const unsigned int n = added_nodes_[k]; solid_.mesh.owned[n])
        for (int i = 0; i < 3; ++i)
          support_work_ += kick * support_force_[k][i] *
                           (v[4 * n + i] + 0.5 * kick * f[4 * n + i] * inertia_[n].inverse_mass);
    const double kinetic = move_nodes(solid_, inertia_, kick, time_step_, with_energy);
    distribute(solid_.mesh, solid_.displacement.data());
    return kinetic;
  }


  Rolling::State
  Rolling::state() const
  {
    return {time_,
            steps_,
            viscous_,
            support_work_,
            friction_,
            contact_damping_,
            balance_started_,
            energy_.start,
            energy_.error};
  }


  void
  Rolling::set_state(const State &state)
  {
    time_            = state.time;
    steps_           = state.steps;
    viscous_         = state.viscous;
    friction_        = state.friction;
    contact_damping_ = state.contact_damping;
    support_work_    = state.support_work;
    balance_started_ = state.balance_started;
    energy_.start    = state.energy_at_start;
    energy_.error    = state.energy_error;
  }


  void
  Rolling::balance(const double kinetic, const AxleEnergy &axle_before, const double support_before)
  {
    // states belong to the full step, energies of the axle and works to the half steps around it: their means
    const AxleEnergy axle    = axle_.energy();
    double           sums[7] = {kinetic,
                                elements_.strain,
                                elements_.stabilisation,
                                viscous_,
                                0.5 * (support_before + support_work_),
                                0,
                                elements_.plastic_work};
    for (std::size_t n = 0; n < inertia_.size(); ++n)
      if (inertia_[n].weight > 0)
        // the displacement of the full step: the one after the step, taken back
        sums[5] +=
          inertia_[n].weight * (solid_.displacement[4 * n + 1] - time_step_ * solid_.velocity[4 * n + 1]);
    MPI_Allreduce(MPI_IN_PLACE, sums, 7, MPI_DOUBLE, MPI_SUM, communicator_);
    energy_.kinetic         = sums[0] + 0.5 * (axle_before.kinetic + axle.kinetic);
    energy_.strain          = sums[1];
    energy_.stabilisation   = sums[2];
    energy_.viscous         = sums[3];
    energy_.plastic         = sums[6];
    energy_.support_work    = sums[4];
    energy_.potential       = sums[5] + axle_before.potential;
    energy_.contact         = sums_.stored_energy;
    energy_.friction        = friction_;
    energy_.contact_damping = contact_damping_;
    energy_.suspension      = 0.5 * (axle_before.damped + axle.damped);
    energy_.torque_work     = 0.5 * (axle_before.torque_work + axle.torque_work);
    energy_.hold_work       = 0.5 * (axle_before.hold_work + axle.hold_work);
    const double total      = energy_.kinetic + energy_.strain + energy_.stabilisation + energy_.potential +
                         energy_.contact + energy_.dissipated() - energy_.torque_work - energy_.hold_work -
                         energy_.support_work;
    if (!balance_started_)
      energy_.start = total;
    balance_started_ = true;
    energy_.residual = total - energy_.start;
    energy_.error    = std::abs(energy_.residual) / (energy_.strain + energy_.dissipated());
  }
} // namespace wheelrail
