#pragma once

#include <wheelrail/material/bilinear.h>
#include <wheelrail/solid/kernel.h>
#include <wheelrail/solid/lanes.h>

namespace wheelrail
{
  /// Energies summed lane by lane.
  template <int W>
  struct LaneEnergy
  {
    Simd<W> strain = 0., stabilisation = 0., plastic_work = 0., viscous_power = 0.;
  };

  /// What one call of a kernel works on.
  struct KernelCall
  {
    ElementBlocks       &blocks;
    const double        *displacement;
    double              *force;
    const BulkViscosity &viscosity;
    BilinearLaw          law;
  };

  /// Calls Kernel::batch<W, plastic, with_energy>(call, batch, lane_energy) for every batch and adds the
  /// energies. The kind is chosen once, so that the kernel has no branches for it.
  template <typename Kernel, int W, bool plastic, bool with_energy>
  void
  batches_of_kind(const KernelCall &call, ElementEnergy &energy)
  {
    const std::size_t n_batches = call.blocks.n_batches();
    LaneEnergy<W>     sum;
    for (std::size_t batch = 0; batch < n_batches; ++batch)
      Kernel::template batch<W, plastic, with_energy>(call, batch, sum);
    energy.strain += std::experimental::reduce(sum.strain);
    energy.stabilisation += std::experimental::reduce(sum.stabilisation);
    energy.plastic_work += std::experimental::reduce(sum.plastic_work);
    energy.viscous_power += std::experimental::reduce(sum.viscous_power);
  }

  template <typename Kernel, int W>
  void
  batches_of_width(const KernelCall &call, const bool with_energy, ElementEnergy &energy)
  {
    if (call.blocks.plastic())
      with_energy ? batches_of_kind<Kernel, W, true, true>(call, energy)
                  : batches_of_kind<Kernel, W, true, false>(call, energy);
    else
      with_energy ? batches_of_kind<Kernel, W, false, true>(call, energy)
                  : batches_of_kind<Kernel, W, false, false>(call, energy);
  }

  /// The same for the width of the blocks, and with or without plasticity and energies.
  template <typename Kernel>
  void
  all_batches(const KernelCall &call, const bool with_energy, ElementEnergy &energy)
  {
    switch (call.blocks.width)
      {
        case 1:
          return batches_of_width<Kernel, 1>(call, with_energy, energy);
        case 2:
          return batches_of_width<Kernel, 2>(call, with_energy, energy);
        case 4:
          return batches_of_width<Kernel, 4>(call, with_energy, energy);
        default:
          return batches_of_width<Kernel, 8>(call, with_energy, energy);
      }
  }
} // namespace wheelrail
