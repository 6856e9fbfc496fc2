#include <wheelrail/solid/batches.h>
#include <wheelrail/solid/reduced_kernel.h>
#include <wheelrail/solid/reduced_plasticity.h>

namespace wheelrail
{
  namespace
  {
    using namespace reduced;
    namespace stdx = std::experimental;

    /// Stress S at the centre and hourglass stresses Q of an elastic batch.
    template <int W, bool with_energy>
    inline void
    elastic_response(const KernelCall &call,
                     const Packed<W>  &g,
                     const Simd<W> (&E)[6],
                     const V3<W> (&p)[4],
                     Simd<W> (&S)[6],
                     V3<W> (&Q)[4],
                     LaneEnergy<W> &energy)
    {
      const Elasticity &material = call.blocks.material;
      elastic_stress<W>(E, call.law.lambda, call.law.shear, S);
      Simd<W>       square;
      const Simd<W> stabilisation =
        hourglass_stress<W>(g, p, material.youngs_modulus, material.poissons_ratio, Q, square);
      if constexpr (with_energy)
        {
          energy.strain += 0.5 * g.volume() * contract<W>(S, E);
          energy.stabilisation += stabilisation;
        }
    }

    /// The same for a batch that may flow, with its history brought up to date.
    template <int W, bool with_energy>
    inline void
    plastic_response(const KernelCall &call,
                     const std::size_t batch,
                     const Packed<W>  &g,
                     const Simd<W> (&E)[6],
                     const V3<W> (&p)[4],
                     Simd<W> (&S)[6],
                     V3<W> (&Q)[4],
                     LaneEnergy<W> &energy)
    {
      ElementBlocks    &blocks   = call.blocks;
      const Elasticity &material = blocks.material;
      double           *rows     = blocks.history.data() + batch * (plastic_history_rows + 12) * W;
      double           *work     = blocks.plastic_work.data() + batch * W;
      unsigned char    &flowed   = blocks.flowed[batch];
      CellHistory<W>    history;
      Simd<W>           done(0.);
      if (flowed)
        history.load(rows);
      if (return_to_yield<W>(call.law, material, g, E, p, history, Q, done))
        {
          flowed = 1;
          history.store(rows);
          done += Simd<W>(work, stdx::vector_aligned);
          done.copy_to(work, stdx::vector_aligned);
        }
      if (!flowed && !with_energy)
        {
          // nothing to take off: the trial state is the state
          elastic_stress<W>(E, call.law.lambda, call.law.shear, S);
          return;
        }
      plastic_stress<W>(call.law, E, history.point, S);
      V3<W>   elastic[4];
      Simd<W> square;
      for (int m = 0; m < 4; ++m)
        for (int k = 0; k < 3; ++k)
          elastic[m][k] = p[m][k] - history.p[m][k];
      const Simd<W> stabilisation =
        hourglass_stress<W>(g, elastic, material.youngs_modulus, material.poissons_ratio, Q, square);
      if constexpr (with_energy)
        {
          energy.strain += g.volume() * elastic_energy<W>(E, history.point, S);
          energy.stabilisation += stabilisation;
          energy.plastic_work += Simd<W>(work, stdx::vector_aligned);
        }
    }

    /// Adds the stress of the bulk viscosity; records dilatation and stress.
    template <int W>
    inline void
    add_viscosity(const KernelCall &call,
                  const std::size_t batch,
                  const Packed<W>  &g,
                  const Simd<W> (&E)[6],
                  Simd<W> (&S)[6],
                  LaneEnergy<W> &energy)
    {
      const Elasticity &material = call.blocks.material;
      double           *old      = call.blocks.viscous.data() + batch * 2 * W;
      const Simd<W>     now      = E[0] + E[1] + E[2];
      const Simd<W>     rate     = (now - Simd<W>(old, stdx::vector_aligned)) / call.viscosity.time_step;
      now.copy_to(old, stdx::vector_aligned);
      const double  factor = call.viscosity.coefficient * material.density * material.wave_speed();
      const Simd<W> extra  = factor * g.length() * rate;
      for (int k = 0; k < 3; ++k)
        S[k] += extra;
      energy.viscous_power += 0.5 * g.volume() * (extra + Simd<W>(old + W, stdx::vector_aligned)) * rate;
      extra.copy_to(old + W, stdx::vector_aligned);
    }

    /// Asks for the packed data of the next batch, so that they arrive while this one is worked on (beyond
    /// the last batch this asks for nothing of use, and does no harm). Elastic bodies gain a quarter from it;
    /// plastic ones gain nothing, so they do not ask.
    template <int W>
    inline void
    fetch_next(const double *data, const std::uint32_t *nodes)
    {
      for (int k = 0; k < ElementBlocks::fields * W; k += 8) // lines of eight numbers
        __builtin_prefetch(data + ElementBlocks::fields * W + k);
      for (int k = 0; k < 8 * W; k += 16)
        __builtin_prefetch(nodes + 8 * W + k);
    }

    /// The work of one batch.
    template <int W, bool plastic, bool with_energy>
    inline void
    batch_force(const KernelCall &call, const std::size_t batch, LaneEnergy<W> &energy)
    {
      const std::uint32_t *nodes = call.blocks.nodes.data() + batch * 8 * W;
      const Packed<W>      g{call.blocks.data.data() + batch * ElementBlocks::fields * W};

      V3<W> u[8];
      for (int a = 0; a < 8; ++a)
        gather<W>(call.displacement, nodes + a * W, u[a]);
      V3<W> H[3], F[3], q[4], FA[3], p[4];
      gradients<W>(g, u, H, q);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          F[i][j] = i == j ? H[i][j] + 1. : H[i][j];
      Simd<W> E[6], S[6];
      green_strain<W>(H, E);
      hourglass_amplitudes<W>(g, F, q, FA, p);

      V3<W> P[3], Q[4], G[4];
      if constexpr (plastic)
        plastic_response<W, with_energy>(call, batch, g, E, p, S, Q, energy);
      else
        elastic_response<W, with_energy>(call, g, E, p, S, Q, energy);
      if (call.viscosity.time_step > 0)
        add_viscosity<W>(call, batch, g, E, S, energy);
      force_of_stress<W>(g, F, S, P);
      if constexpr (!plastic)
        fetch_next<W>(g.data, nodes);
      hourglass_forces<W>(g, FA, q, Q, P, G);
      apply_forces<W>(g, nodes, P, G, call.force);
    }

    struct ReducedKernel
    {
      template <int W, bool plastic, bool with_energy>
      static void
      batch(const KernelCall &call, const std::size_t batch, LaneEnergy<W> &energy)
      {
        batch_force<W, plastic, with_energy>(call, batch, energy);
      }
    };
  } // namespace


  void
  subtract_reduced_force(ElementBlocks       &blocks,
                         const double        *displacement,
                         double              *force,
                         const BulkViscosity &viscosity,
                         const bool           with_energy,
                         ElementEnergy       &energy)
  {
    all_batches<ReducedKernel>(
      {blocks, displacement, force, viscosity, BilinearLaw(blocks.material, blocks.plasticity)},
      with_energy,
      energy);
  }
} // namespace wheelrail
