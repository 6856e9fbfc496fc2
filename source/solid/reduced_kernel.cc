#include <wheelrail/solid/batches.h>
#include <wheelrail/solid/reduced_kernel.h>
#include <wheelrail/solid/reduced_plasticity.h>

#include <cstdint>

// Force of the reduced element, the exact gradient of its energy: so linear and angular momentum and energy
// are kept to round-off (doc/theory/element.md, Uniform gradients, Stabilisation). Total Lagrangian: Green's
// strain of a rotation is 0 whatever its angle, and no rate is integrated.
// Checked: bricks bend exactly, to 6e-15; patch test with distorted cells, 2e-15
// (doc/theory/verification.md).

namespace wheelrail
{
  namespace
  {
    using namespace reduced;
    namespace stdx = std::experimental;

    /// Brings the history of a batch up to date, by the trial state; returns whether it has flowed, now
    /// or before. If not, the history stays zero, and Q are the hourglass stresses of the state.
    template <int W, typename Law>
    inline bool
    advance_history(const KernelCall<Law> &call,
                    const std::size_t      batch,
                    const Packed<W>       &g,
                    const Simd<W> (&E)[6],
                    const V3<W> (&p)[4],
                    CellHistory<Law, W> &history,
                    V3<W> (&Q)[4])
    {
      // numbers of the centre, then the 12 plastic amplitudes of the patterns
      const int      n_rows = call.law.history_rows() + ElementBlocks::amplitude_rows;
      double        *rows   = call.blocks.history.data() + batch * n_rows * W;
      double        *work   = call.blocks.plastic_work.data() + batch * W;
      unsigned char &flowed = call.blocks.flowed[batch];
      Simd<W>        done(0.);
      // the mark is of the whole batch: one lane that flows loads all
      if (flowed)
        history.load(rows);
      // centre and patterns flow back by the same fraction, on n^2 + m^2 + n m/4 (doc/theory/element.md,
      // Plastic flow)
      if (return_to_yield<W>(call.law, g, E, p, history, Q, done))
        {
          flowed = 1;
          history.store(rows);
          done += Simd<W>(work, stdx::vector_aligned);
          done.copy_to(work, stdx::vector_aligned);
        }
      return flowed;
    }

    /// Stress S at the centre and hourglass stresses Q of a batch after a step to the strain E and the
    /// amplitudes p.
    template <int W, bool with_energy, typename Law>
    inline void
    cell_response(const KernelCall<Law> &call,
                  const std::size_t      batch,
                  const Packed<W>       &g,
                  const Simd<W> (&E)[6],
                  const V3<W> (&p)[4],
                  Simd<W> (&S)[6],
                  V3<W> (&Q)[4],
                  LaneEnergy<W> &energy)
    {
      CellHistory<Law, W> history(call.law);
      if constexpr (has_history<Law>)
        if (!advance_history<W>(call, batch, g, E, p, history, Q) && !with_energy)
          {
            // nothing to take off: the trial state is the state
            call.law.elastic_stress(E, S);
            return;
          }
      call.law.stress(E, history.point, S);
      V3<W> elastic[4];
      for (int m = 0; m < 4; ++m)
        for (int k = 0; k < 3; ++k)
          // p - p_pl
          elastic[m][k] = has_history<Law> ? p[m][k] - history.p[m][k] : p[m][k];
      Simd<W>       square;
      const Simd<W> stabilisation = hourglass_stress<W>(g, elastic, call.law.elasticity, Q, square);
      if constexpr (with_energy)
        {
          // apart: of bending over n cells the share 1/n^2 is called stabilisation
          // (doc/theory/verification.md, Elastic)
          energy.strain += g.volume() * call.law.stored_energy(E, history.point, S);
          energy.stabilisation += stabilisation;
          if constexpr (has_history<Law>)
            {
              energy.plastic_work +=
                Simd<W>(call.blocks.plastic_work.data() + batch * W, stdx::vector_aligned);
              V3<W>         back[4];
              const Simd<W> of_patterns =
                hourglass_stress<W>(g, history.p, call.law.elasticity, back, square);
              // of the patterns: the back stress is f H/(3 mu) times the elastic stress of their plastic
              // amplitudes
              energy.hardening +=
                g.volume() * call.law.hardening_energy(history.point) + call.law.back_ratio * of_patterns;
            }
        }
    }

    /// Adds the stress of the bulk viscosity; records dilatation and stress.
    template <int W, typename Law>
    inline void
    add_viscosity(const KernelCall<Law> &call,
                  const std::size_t      batch,
                  const Packed<W>       &g,
                  const Simd<W> (&E)[6],
                  Simd<W> (&S)[6],
                  LaneEnergy<W> &energy)
    {
      double *old = call.blocks.viscous.data() + batch * 2 * W;
      // tr E at the full step; the rate belongs to the half step behind
      const Simd<W> now  = E[0] + E[1] + E[2];
      const Simd<W> rate = (now - Simd<W>(old, stdx::vector_aligned)) / call.viscosity.time_step;
      now.copy_to(old, stdx::vector_aligned);
      // b rho c_p L d(tr E)/dt (von Neumann and Richtmyer 1950, the linear term); a pressure, so that no
      // rotation and no shear is braked
      const Simd<W> extra = call.viscous_impedance * g.length() * rate;
      for (int k = 0; k < 3; ++k)
        S[k] += extra;
      energy.viscous_power += 0.5 * g.volume() * (extra + Simd<W>(old + W, stdx::vector_aligned)) * rate;
      extra.copy_to(old + W, stdx::vector_aligned);
    }

    struct ReducedKernel
    {
      /// The work of one batch.
      template <int W, bool with_energy, typename Law>
      static void
      batch(const KernelCall<Law> &call, const std::size_t batch, LaneEnergy<W> &energy)
      {
        const std::uint32_t *nodes = call.blocks.nodes.data() + batch * 8 * W;
        // W elements at once, lane by lane the same arithmetic: results agree for every W to round-off
        const Packed<W> g{call.blocks.data.data() + batch * ElementBlocks::fields * W};

        V3<W> u[8];
        for (int a = 0; a < 8; ++a)
          gather<W>(call.displacement, nodes + a * W, u[a]);
        V3<W> H[3], F[3], q[4], FA[3], p[4];
        // 1. H = sum u_a (x) B_a, q_m = sum h_m(a) u_a - H (h_m X) (doc/theory/element.md, Uniform gradients,
        // Stabilisation)
        gradients<W>(g, u, H, q);
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            F[i][j] = i == j ? H[i][j] + 1. : H[i][j];
        Simd<W> E[6], S[6];
        // 2. E = (H + H' + H' H)/2 and p_m = (F A)' q_m, which a rotation leaves alone
        green_strain<W>(H, E);
        hourglass_amplitudes<W>(g, F, q, FA, p);

        V3<W> P[3], Q[4], G[4];
        // 3. S of the law, Q_m = dW/dp_m, both returned to one yield surface
        cell_response<W, with_energy>(call, batch, g, E, p, S, Q, energy);
        if (call.viscosity.time_step > 0)
          add_viscosity<W>(call, batch, g, E, S, energy);
        // 4. the exact gradient of the energy: P = V F S + sum (q_m (x) A Q_m - G_m (x) h_m X), G_m = F A
        // Q_m, f_a = P B_a + sum h_m(a) G_m (doc/theory/element.md, Forces)
        force_of_stress<W>(g, F, S, P);
        // memory of the batch after next is asked for here, while this one is computed
        fetch_ahead<W>(call, batch);
        hourglass_forces<W>(g, FA, q, Q, P, G);
        apply_forces<W>(g, nodes, P, G, call.force);
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
    all_batches<ReducedKernel>(blocks, displacement, force, viscosity, with_energy, energy);
  }
} // namespace wheelrail
