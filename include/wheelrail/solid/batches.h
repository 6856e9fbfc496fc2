#pragma once

#include <wheelrail/solid/kernel.h>
#include <wheelrail/solid/lanes.h>

#include <type_traits>

namespace wheelrail
{
  /// Energies summed lane by lane.
  template <int W>
  struct LaneEnergy
  {
    Simd<W> strain = 0., stabilisation = 0., plastic_work = 0., hardening = 0., viscous_power = 0.;
  };

  /// What one call of a kernel works on, and by which material law (material/law.h).
  template <typename Law>
  struct KernelCall
  {
    ElementBlocks &blocks;
    const double  *displacement;
    double        *force;
    BulkViscosity  viscosity;
    Law            law;
    double         viscous_impedance; ///< bulk viscosity coefficient x density x wave speed [Pa s/m]
  };

  /// Calls Kernel::batch<W, with_energy>(call, batch, lane_energy) for every batch and adds the
  /// energies. The kind is chosen once, so that the kernel has no branches for it.
  template <typename Kernel, int W, bool with_energy, typename Law>
  void
  batches_of_width(const KernelCall<Law> &call, ElementEnergy &energy)
  {
    const std::size_t n_batches = call.blocks.n_batches();
    LaneEnergy<W>     sum;
    for (std::size_t batch = 0; batch < n_batches; ++batch)
      Kernel::template batch<W, with_energy>(call, batch, sum);
    energy.strain += std::experimental::reduce(sum.strain);
    energy.stabilisation += std::experimental::reduce(sum.stabilisation);
    energy.plastic_work += std::experimental::reduce(sum.plastic_work);
    energy.hardening += std::experimental::reduce(sum.hardening);
    energy.viscous_power += std::experimental::reduce(sum.viscous_power);
  }

  /// The same for the width of the blocks.
  template <typename Kernel, bool with_energy, typename Law>
  void
  batches_of_law(const KernelCall<Law> &call, ElementEnergy &energy)
  {
    switch (call.blocks.width)
      {
        case 1:
          return batches_of_width<Kernel, 1, with_energy>(call, energy);
        case 2:
          return batches_of_width<Kernel, 2, with_energy>(call, energy);
        case 4:
          return batches_of_width<Kernel, 4, with_energy>(call, energy);
        default:
          return batches_of_width<Kernel, 8, with_energy>(call, energy);
      }
  }

  /// The same for the law of the blocks, with or without energies. Arguments: see
  /// subtract_internal_force().
  template <typename Kernel>
  void
  all_batches(ElementBlocks       &blocks,
              const double        *displacement,
              double              *force,
              const BulkViscosity &viscosity,
              const bool           with_energy,
              ElementEnergy       &energy)
  {
    const auto run = [&](const auto &law) {
      const Elasticity                             &material = law.elasticity;
      const KernelCall<std::decay_t<decltype(law)>> call{blocks,
                                                         displacement,
                                                         force,
                                                         viscosity,
                                                         law,
                                                         viscosity.coefficient * material.density *
                                                           material.wave_speed()};
      with_energy ? batches_of_law<Kernel, true>(call, energy) : batches_of_law<Kernel, false>(call, energy);
    };
    std::visit(run, blocks.law);
  }
} // namespace wheelrail
