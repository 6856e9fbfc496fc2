#include <wheelrail/dynamics/rolling.h>

namespace wheelrail
{
  Rolling::Rolling(Solid            &solid,
                   Contact          &contact,
                   const SceneParts &parts,
                   Axle             &axle,
                   const TimeScheme &scheme,
                   MPI_Comm          communicator)
    : axle_(axle)
    , communicator_(communicator)
    , contact_(contact, axle, communicator)
    , added_mass_(axle)
    , loop_(solid, scheme, communicator)
  {
    for (const auto &part : parts)
      loop_.add(*part);
    loop_.add(contact_);
    loop_.add(added_mass_);
    loop_.add(axle);
    if (axle.data().torque_ramp > 0)
      rate_change_ = &loop_.energy().term("rate_change_work", EnergyKind::supplied);
    loop_.prepare();
  }


  void
  Rolling::turn_faster(const double change)
  {
    const double before = axle_.energy().kinetic;
    axle_.add_rate(change);
    double gain = loop_.add_spin(Body::wheel, axle_.centre(), change * axle_.axis());
    int    rank;
    MPI_Comm_rank(communicator_, &rank);
    if (rank == 0) // all ranks have the same axle
      gain += axle_.energy().kinetic - before;
    rate_change_->add_done(gain);
  }


  void
  RollingContact::enter(EnergyBalance &energies)
  {
    int rank;
    MPI_Comm_rank(communicator_, &rank);
    tells_    = rank == 0;
    stored_   = &energies.term("contact_energy", EnergyKind::stored);
    friction_ = &energies.term("friction_dissipation", EnergyKind::dissipated);
    damping_  = &energies.term("contact_damping_dissipation", EnergyKind::dissipated);
    gain_     = &energies.term("contact_scheme_energy", EnergyKind::noted);
  }


  void
  RollingContact::add_forces(const Instant &now, Solid &solid)
  {
    const double along = axle_.contact_along();
    contact_.move_window(along, axle_.contact_on_wheel(contact_.surfaces().rolling_radius) - along);
    contact_.gather(solid.displacement.data(), solid.velocity.data());
    sums_ = contact_.evaluate(now.step);
    contact_.add_forces(solid.force.data());
  }


  void
  RollingContact::account(const Instant &now, const Solid &solid, const std::vector<NodeInertia> &inertia)
  {
    gain_->add_work(now.velocity_update.duration * contact_.power([&](const unsigned int node) {
      return mean_velocity(solid, inertia, node, now.velocity_update);
    }));
    if (!tells_)
      return;
    const double friction = now.velocity_update.duration * sums_.friction_power,
                 damping  = now.velocity_update.duration * sums_.damping_power;
    stored_->here += sums_.stored_energy;
    friction_->add_work(friction);
    damping_->add_work(damping);
    gain_->here += sums_.stored_energy;
    gain_->add_work(friction + damping);
    if (now.first)
      gain_->add_done(-sums_.stored_energy); // counted from the start on
  }


  void
  AddedMassRotation::prepare(const Solid &solid, std::vector<NodeInertia> &)
  {
    nodes_.clear();
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == Body::wheel && solid.mass[n] > 0 && solid.added_mass[n] > 0)
        nodes_.push_back(n);
    force_.resize(nodes_.size());
  }


  void
  AddedMassRotation::enter(EnergyBalance &energies)
  {
    work_ = &energies.term("added_mass_support_work", EnergyKind::supplied);
  }


  void
  AddedMassRotation::add_forces(const Instant &, Solid &solid)
  {
    const Vector3 centre = axle_.centre(), axis = axle_.axis();
    const double  rate2 = axle_.pitch_rate() * axle_.pitch_rate();
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      {
        const unsigned int n      = nodes_[k];
        const Vector3      arm    = solid.position(n) - centre;
        const Vector3      radial = arm - dot(arm, axis) * axis;
        force_[k]                 = (-solid.added_mass[n] * rate2) * radial;
        for (int i = 0; i < 3; ++i)
          solid.force[4 * n + i] += force_[k][i];
      }
  }


  void
  AddedMassRotation::account(const Instant &now, const Solid &solid, const std::vector<NodeInertia> &inertia)
  {
    double power = 0;
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      if (solid.mesh.owns(nodes_[k]))
        power += dot(force_[k], mean_velocity(solid, inertia, nodes_[k], now.velocity_update));
    work_->add_work(now.velocity_update.duration * power);
  }
} // namespace wheelrail
