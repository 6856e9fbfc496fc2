#include <wheelrail/dynamics/rolling_contact.h>

namespace wheelrail
{
  void
  RollingContact::enter(EnergyBook &book)
  {
    // all ranks evaluate the contact alike: one of them enters it
    int rank;
    MPI_Comm_rank(communicator_, &rank);
    stored_   = &book.term("contact_energy", EnergyKind::stored);
    friction_ = &book.term("friction_dissipation", EnergyKind::dissipated);
    damping_  = &book.term("contact_damping_dissipation", EnergyKind::dissipated);
    if (rank > 0)
      stored_ = friction_ = damping_ = nullptr;
  }


  void
  RollingContact::add_forces(const Instant &now, Solid &solid)
  {
    const double wheel_ahead = contact_.surfaces().rolling_radius * axle_.pitch_angle() - axle_.travelled();
    contact_.move_window(axle_.travelled(), wheel_ahead);
    contact_.gather(solid.displacement.data(), solid.velocity.data());
    sums_ = contact_.evaluate(now.step);
    contact_.add_forces(solid.force.data());
    if (stored_ == nullptr)
      return;
    stored_->here += sums_.stored_energy;
    friction_->add_work(now.kick.duration * sums_.friction_power);
    damping_->add_work(now.kick.duration * sums_.damping_power);
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
  AddedMassRotation::enter(EnergyBook &book)
  {
    work_ = &book.term("added_mass_support_work", EnergyKind::supplied);
  }


  void
  AddedMassRotation::add_forces(const Instant &, Solid &solid)
  {
    const Vector3 centre = axle_.data().centre + Vector3{0, axle_.height(), axle_.travelled()};
    const double  rate2  = axle_.pitch_rate() * axle_.pitch_rate();
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      {
        const unsigned int n      = nodes_[k];
        const Vector3      arm    = solid.position(n) - centre;
        const Vector3      radial = arm - dot(arm, axle_.data().axis) * axle_.data().axis;
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
      if (solid.mesh.owned[nodes_[k]])
        power += dot(force_[k], mean_velocity(solid, inertia, nodes_[k], now.kick));
    work_->add_work(now.kick.duration * power);
  }
} // namespace wheelrail
