#pragma once

#include <wheelrail/solid/kernel.h>
#include <wheelrail/solid/lanes.h>

#include <cstddef>
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
    std::size_t    history;           ///< numbers that one batch remembers
  };

  /// Asks for `n` numbers from `first` on, a cache line of 64 bytes at a time. Always inline: GCC takes a
  /// function that only asks for memory for one without effect, and drops the call.
  template <typename T>
  [[gnu::always_inline]] inline void
  fetch(const T *first, const std::size_t n)
  {
    for (std::size_t k = 0; k < n; k += 64 / sizeof(T))
      __builtin_prefetch(first + k);
  }

  /// Asks for what the batch after the next needs, so that it arrives while others are worked on (beyond the
  /// last batch this asks for nothing of use, and does no harm).
  template <int W, typename Law>
  [[gnu::always_inline]] inline void
  fetch_ahead(const KernelCall<Law> &call, const std::size_t batch)
  {
    const ElementBlocks &blocks = call.blocks;
    const std::size_t    ahead  = batch + 2;
    fetch(blocks.data.data() + ahead * blocks.rows * W, blocks.rows * W);
    fetch(blocks.nodes.data() + ahead * 8 * W, 8 * W);
    fetch(blocks.viscous.data() + ahead * 2 * W, 2 * W);
    if constexpr (has_history<Law>)
      if (ahead < blocks.flowed.size() && blocks.flowed[ahead])
        {
          fetch(blocks.history.data() + ahead * call.history, call.history);
          fetch(blocks.plastic_work.data() + ahead * W, W);
        }
  }

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
                                                           material.wave_speed(),
                                                         std::size_t(blocks.history_rows()) * blocks.width};
      with_energy ? batches_of_law<Kernel, true>(call, energy) : batches_of_law<Kernel, false>(call, energy);
    };
    std::visit(run, blocks.law);
  }
} // namespace wheelrail
