#include <wheelrail/dynamics/element_forces.h>

namespace wheelrail
{
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
