#pragma once

#include <wheelrail/solid/part.h>

namespace wheelrail
{
  /// Internal forces of the elements of both bodies, with the linear bulk viscosity, and their energies.
  /// `plastic_work` is all work of plastic flow, `hardening_energy` the part of it that
  /// hardening stores; the rest is heat.
  class ElementForces
  {
  public:
    void
    enter(EnergyBalance &energies);

    /// Subtracts the internal forces of the rank's elements; the first step only records the dilatation, from
    /// which the viscosity of the next one takes its rate.
    void
    add_shares(const Instant &now, double bulk_viscosity, Solid &solid);

  private:
    EnergyTerm *strain_ = nullptr, *stabilisation_ = nullptr, *plastic_ = nullptr, *hardening_ = nullptr,
               *viscous_ = nullptr;
  };
} // namespace wheelrail
