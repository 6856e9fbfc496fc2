#include <wheelrail/dynamics/time_loop.h>
#include <wheelrail/solid/transfer.h>

#include <chrono>

namespace wheelrail
{
  namespace
  {
    double
    wall_seconds()
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    }

    /// Adds the seconds between its making and its end to a total.
    class Stopwatch
    {
    public:
      Stopwatch(double (*clock)(), double &total)
        : clock_(clock)
        , total_(total)
        , start_(clock())
      {
      }
      ~Stopwatch()
      {
        total_ += clock_() - start_;
      }
      Stopwatch(const Stopwatch &) = delete;

    private:
      double (*clock_)();
      double &total_;
      double  start_;
    };
  } // namespace


  TimeLoop::TimeLoop(Solid &solid, const TimeScheme &scheme, MPI_Comm communicator)
    : scheme(scheme)
    , clock(wall_seconds)
    , solid_(solid)
    , communicator_(communicator)
    , kinetic_(energies_.term("kinetic_energy", EnergyKind::stored))
    , mesh_change_(energies_.term("mesh_change_work", EnergyKind::supplied))
  {
    elements_.enter(energies_);
  }


  void
  TimeLoop::add(Part &part)
  {
    parts_.push_back(&part);
    part.enter(energies_);
  }


  void
  TimeLoop::prepare()
  {
    inertia_ = node_inertia(solid_);
    for (Part *part : parts_)
      part->prepare(solid_, inertia_);
    start_forces(solid_, inertia_);
  }


  void
  TimeLoop::change_mesh(const std::function<void()> &remake, const double middle)
  {
    const Stopwatch watch(clock, timing_.mesh);
    // a start has displacements and velocities at the same instant
    const double      step   = steps_ == 0 ? 0 : scheme.time_step;
    const double      before = body_energy(solid_, inertia_, step, communicator_);
    const SolidChoice choice = solid_.choice;
    SolidTransfer     transfer(std::move(solid_), middle, communicator_);
    solid_.choice = choice;
    remake();
    prepare();
    transfer.fill(solid_, inertia_, step);
    const double after = body_energy(solid_, inertia_, step, communicator_);
    int          rank;
    MPI_Comm_rank(communicator_, &rank);
    if (rank == 0) // all ranks know it
      mesh_change_.add_done(after - before);
  }


  double
  TimeLoop::add_spin(const Body body, const Vector3 &centre, const Vector3 &spin)
  {
    double gain = 0;
    for (unsigned int n = 0; n < inertia_.size(); ++n)
      if (solid_.mesh.node_body[n] == body)
        {
          double       *v      = &solid_.velocity[4 * n];
          const Vector3 before = {v[0], v[1], v[2]}, more = cross(spin, solid_.position(n) - centre);
          for (int i = 0; i < 3; ++i)
            v[i] += more[i];
          if (inertia_[n].inverse_mass > 0 && solid_.mesh.owns(n))
            gain += (dot(before, more) + 0.5 * dot(more, more)) / inertia_[n].inverse_mass;
        }
    return gain;
  }


  Instant
  TimeLoop::instant(const bool with_energy) const
  {
    const bool first = steps_ == 0;
    return {time_,
            scheme.time_step,
            make_velocity_update(first ? scheme.time_step / 2 : scheme.time_step, scheme.mass_damping),
            first,
            with_energy};
  }


  void
  TimeLoop::step(const bool with_energy)
  {
    const Instant now = instant(with_energy);
    energies_.begin_step();
    // 1. each rank's share of the forces
    {
      const Stopwatch watch(clock, timing_.elements);
      elements_.add_shares(now, scheme.bulk_viscosity, solid_);
    }
    {
      const Stopwatch watch(clock, timing_.parts);
      for (Part *part : parts_)
        part->add_shares(now, solid_);
    }
    // 2. sums over ranks
    {
      const Stopwatch watch(clock, timing_.exchange);
      condense(solid_.mesh, solid_.force.data());
      sum_over_ranks(solid_.mesh, solid_.force.data());
    }
    // 3. forces known alike, constraints, works
    {
      const Stopwatch watch(clock, timing_.parts);
      for (Part *part : parts_)
        part->add_forces(now, solid_);
      for (Part *part : parts_)
        part->constrain(now, solid_, inertia_);
      account(now);
    }
    // 4. free nodes
    {
      const Stopwatch watch(clock, timing_.update);
      move(now);
    }
    time_ += now.step;
    ++steps_;
    if (with_energy)
      energies_.balance(now.first, communicator_);
  }


  void
  TimeLoop::account(const Instant &now)
  {
    for (Part *part : parts_)
      part->account(now, solid_, inertia_);
    if (scheme.mass_damping == 0)
      return;
    double power = 0;
    for (unsigned int n = 0; n < inertia_.size(); ++n)
      if (inertia_[n].inverse_mass > 0 && solid_.mesh.owns(n))
        {
          const Vector3 v = mean_velocity(solid_, inertia_, n, now.velocity_update);
          power += scheme.mass_damping / inertia_[n].inverse_mass * dot(v, v);
        }
    energies_.term("mass_damping_dissipation", EnergyKind::dissipated)
      .add_work(now.velocity_update.duration * power);
  }


  void
  TimeLoop::move(const Instant &now)
  {
    kinetic_.here += move_nodes(solid_, inertia_, now.velocity_update, now.step, now.with_energy);
    distribute(solid_.mesh, solid_.displacement.data());
  }


  TimeLoop::State
  TimeLoop::state() const
  {
    State state{time_, steps_, energies_.state(), {}};
    for (const Part *part : parts_)
      if (!part->name().empty())
        state.parts[part->name()] = part->state();
    return state;
  }


  void
  TimeLoop::set_state(const State &state)
  {
    time_  = state.time;
    steps_ = state.steps;
    energies_.set_state(state.energy);
    for (Part *part : parts_)
      if (!part->name().empty())
        part->set_state(state.parts.at(part->name()));
  }


  void
  ElementForces::enter(EnergyBalance &energies)
  {
    strain_        = &energies.term("strain_energy", EnergyKind::stored);
    stabilisation_ = &energies.term("stabilisation_energy", EnergyKind::stored);
    plastic_       = &energies.term("plastic_work", EnergyKind::dissipated);
    hardening_     = &energies.term("hardening_energy", EnergyKind::noted);
    viscous_       = &energies.term("viscous_dissipation", EnergyKind::dissipated);
  }


  void
  ElementForces::add_shares(const Instant &now, const double bulk_viscosity, Solid &solid)
  {
    const BulkViscosity viscosity{now.first ? 0. : bulk_viscosity, bulk_viscosity > 0 ? now.step : 0.};
    ElementEnergy       energy;
    subtract_internal_force(
      solid.blocks, solid.displacement.data(), solid.force.data(), viscosity, now.with_energy, energy);
    viscous_->add_done(now.step * energy.viscous_power); // of the step behind
    if (!now.with_energy)
      return;
    strain_->here += energy.strain;
    stabilisation_->here += energy.stabilisation;
    plastic_->here += energy.plastic_work;
    hardening_->here += energy.hardening;
  }
} // namespace wheelrail
