#include <wheelrail/solid/batches.h>
#include <wheelrail/solid/full_element.h>
#include <wheelrail/solid/full_points.h>

#include <cstdint>

// Force of the full element: W = sum over g of w_g psi(Ebar_g), f_a = dW/du_a (doc/theory/element.md, The
// full element).

namespace wheelrail
{
  namespace
  {
    using namespace full;
    namespace stdx = std::experimental;

    /// The points of a batch, their strains with the mean dilatation in place of their own.
    template <int W>
    struct Points
    {
      Point<W> point[8];
      Simd<W>  volume = 0., dilatation = 0.;
    };

    template <int W, typename Law>
    inline void
    evaluate_points(const KernelCall<Law> &call, const std::size_t batch, Points<W> &points)
    {
      Simd<W>              u[8][3];
      const std::uint32_t *nodes = call.blocks.nodes.data() + batch * 8 * W;
      for (int a = 0; a < 8; ++a)
        // 1. F_g, E_g at the eight points, dilatation theta of the cell, Ebar_g (doc/theory/element.md, The
        // full element)
        gather<W>(call.displacement, nodes + a * W, u[a]);
      // dX/dxi and du/dxi: each has four values for eight points, since it does not vary along its own
      // direction
      Derivatives<W> dX, du;
      reference_derivatives<W>(call.blocks.data.data() + batch * fields * W, dX);
      nodal_derivatives<W>(u, du);
      for (int g = 0; g < 8; ++g)
        {
          auto &p = points.point[g];
          evaluate_point<W>(dX, du, g, p);
          points.volume += p.weight;
          points.dilatation += p.weight * trace<W>(p.E);
        }
      // theta = (1/V) sum of w_g tr E_g in place of tr E_g
      points.dilatation /= points.volume;
      for (auto &p : points.point)
        set_trace<W>(points.dilatation, p.E);
    }

    /// Stress of the bulk viscosity; records it and the dilatation.
    template <int W, typename Law>
    inline Simd<W>
    viscous_stress(const KernelCall<Law> &call,
                   const std::size_t      batch,
                   const Points<W>       &points,
                   LaneEnergy<W>         &energy)
    {
      // rows: theta of the step behind, its viscous stress [Pa]
      double *old = call.blocks.viscous.data() + batch * 2 * W;
      // b rho c_p L d(tr E)/dt, of the dilatation theta; its power is the mean of the stresses at both ends
      // of the step times the rate, exact in central differences
      const Simd<W> rate =
        (points.dilatation - Simd<W>(old, stdx::vector_aligned)) / call.viscosity.time_step;
      points.dilatation.copy_to(old, stdx::vector_aligned);
      const double *length = call.blocks.data.data() + (batch * fields + length_row) * W;
      const Simd<W> extra  = call.viscous_impedance * Simd<W>(length, stdx::vector_aligned) * rate;
      energy.viscous_power += 0.5 * points.volume * (extra + Simd<W>(old + W, stdx::vector_aligned)) * rate;
      extra.copy_to(old + W, stdx::vector_aligned);
      return extra;
    }

    /// Stress of one point, with its history brought up to date; whether it flowed. `flowed`: whether the
    /// batch did before; `work`: the plastic work of the element in this step [J].
    template <int W, bool with_energy, typename Law>
    inline bool
    respond(const KernelCall<Law> &call,
            const std::size_t      batch,
            const int              g,
            const Point<W>        &point,
            const bool             flowed,
            Simd<W> (&S)[6],
            Simd<W>       &work,
            LaneEnergy<W> &energy)
    {
      // each of the eight points has a history of its own
      double *rows = call.blocks.history.data() + (batch * 8 + g) * call.law.history_rows() * W;
      // a batch that has never flowed has zeros: nothing to load
      typename Law::template History<Simd<W>> history(call.law);
      Simd<W>                                 density(0.);
      if (flowed)
        history.load(rows);
      // trial and radial return on Ebar_g (doc/manual/material.md, Theory)
      const bool flows = point_response(call.law, point.E, history, S, density);
      // a batch in which nothing flows leaves its history as it is
      if (flows)
        {
          history.store(rows);
          work += point.weight * density;
        }
      if constexpr (with_energy)
        {
          energy.strain += point.weight * call.law.stored_energy(point.E, history, S);
          if constexpr (has_history<Law>)
            energy.hardening += point.weight * call.law.hardening_energy(history);
        }
      return flows;
    }

    struct FullKernel
    {
      /// The work of one batch.
      template <int W, bool with_energy, typename Law>
      static void
      batch(const KernelCall<Law> &call, const std::size_t batch, LaneEnergy<W> &energy)
      {
        Points<W> points;
        evaluate_points<W>(call, batch, points);
        fetch_ahead<W>(call, batch);
        Simd<W> viscous(0.);
        if (call.viscosity.time_step > 0)
          // 2. bulk viscosity
          viscous = viscous_stress<W>(call, batch, points, energy);

        // N: stresses that work on du/dxi [N]; forces at the nodes follow from them by the transpose of
        // nodal_derivatives()
        Derivatives<W> N;
        for (auto &direction : N)
          for (auto &value : direction)
            for (auto &component : value)
              component = 0.;
        Simd<W>    work(0.);
        bool       flows  = false;
        const bool flowed = has_history<Law> && call.blocks.flowed[batch];
        for (int g = 0; g < 8; ++g)
          {
            const auto &p = points.point[g];
            Simd<W>     S[6];
            // 3. S_g of the law, and F_g S_g summed to nine derivatives of the shape functions. In the laws
            // the pressure is K theta at each point, so that S_g is dpsi/dE and needs no correction for the
            // mean.
            flows = respond<W, with_energy>(call, batch, g, p, flowed, S, work, energy) || flows;
            for (int k = 0; k < 3; ++k)
              // a pressure of the whole cell
              S[k] += viscous;
            add_point_stress<W>(p, S, g, N);
          }
        if constexpr (has_history<Law>)
          {
            // [J] of the element since the start
            double *total = call.blocks.plastic_work.data() + batch * W;
            if (flows)
              {
                call.blocks.flowed[batch] = 1;
                work += Simd<W>(total, stdx::vector_aligned);
                work.copy_to(total, stdx::vector_aligned);
              }
            if constexpr (with_energy)
              energy.plastic_work += Simd<W>(total, stdx::vector_aligned);
          }
        Simd<W> f[8][3];
        // 4. f_a = sum over g of w_g F_g S_g dN_a/dX, subtracted from the forces
        nodal_forces<W>(N, f);
        const std::uint32_t *nodes = call.blocks.nodes.data() + batch * 8 * W;
        for (int a = 0; a < 8; ++a)
          scatter_subtract<W>(call.force, nodes + a * W, f[a]);
      }
    };
  } // namespace


  void
  subtract_full_force(ElementBlocks       &blocks,
                      const double        *displacement,
                      double              *force,
                      const BulkViscosity &viscosity,
                      const bool           with_energy,
                      ElementEnergy       &energy)
  {
    all_batches<FullKernel>(blocks, displacement, force, viscosity, with_energy, energy);
  }
} // namespace wheelrail
