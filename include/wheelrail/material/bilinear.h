#pragma once

#include <wheelrail/base/simd.h>
#include <wheelrail/material/elasticity.h>

#include <limits>

namespace wheelrail
{
  /// Constants of a bilinear stress-strain curve with von Mises' yield condition.
  struct Plasticity
  {
    double yield_stress       = std::numeric_limits<double>::infinity(); ///< infinite: elastic [Pa]
    double tangent_modulus    = 0; ///< slope of the total curve beyond yield, less than Young's modulus [Pa]
    double kinematic_fraction = 0; ///< 0: isotropic hardening, 1: kinematic

    bool
    elastic() const
    {
      return yield_stress == std::numeric_limits<double>::infinity();
    }
    /// Slope of stress over plastic strain in uniaxial tension: H = E E_t / (E - E_t) [Pa].
    double
    hardening_modulus(const Elasticity &elasticity) const
    {
      const double E = elasticity.youngs_modulus;
      return E * tangent_modulus / (E - tangent_modulus);
    }
  };

  /// Both sets of constants in the form that the return mapping uses.
  ///
  /// Small-strain J2 plasticity in total form (Simo and Hughes 1998, boxes 3.1 and 3.2), on Green's
  /// strain E and the second Piola-Kirchhoff stress S, both stored xx, yy, zz, yz, xz, xy:
  /// S = K tr(E) I + 2 mu (dev E - E_p). The back stress of Prager's linear kinematic hardening is
  /// 2/3 f H E_p, so the plastic strain is the only tensor to remember.
  struct BilinearLaw
  {
    double lambda, shear;       ///< Lame's constants [Pa]
    double yield_stress;        ///< [Pa]
    double isotropic_hardening; ///< (1 - f) H [Pa]
    double kinematic_ratio;     ///< back stress over 2 mu E_p: f H / (3 mu)
    double flow_compliance;     ///< 1 / (3 mu + H) [1/Pa]
    /// Slope of shear stress over shear strain in plastic flow, relative to mu: H / (3 mu + H).
    double tangent_ratio;

    BilinearLaw(const Elasticity &elasticity, const Plasticity &plasticity)
      : lambda(elasticity.lame_lambda())
      , shear(elasticity.shear_modulus())
      , yield_stress(plasticity.yield_stress)
    {
      const double H      = plasticity.hardening_modulus(elasticity);
      isotropic_hardening = (1 - plasticity.kinematic_fraction) * H;
      kinematic_ratio     = plasticity.kinematic_fraction * H / (3 * shear);
      flow_compliance     = 1 / (3 * shear + H);
      tangent_ratio       = H / (3 * shear + H);
    }
  };

  /// Numbers that a material point remembers: five of the plastic strain, whose trace is zero (xx,
  /// yy, yz, xz, xy), and the accumulated plastic strain.
  constexpr int plastic_history_rows = 6;

  /// History of W points.
  template <int W>
  struct PlasticHistory
  {
    Simd<W> strain[5]   = {0., 0., 0., 0., 0.};
    Simd<W> accumulated = 0.; ///< integral of sqrt(2/3 dE_p : dE_p)

    /// `rows`: plastic_history_rows x W aligned numbers.
    void
    load(const double *rows)
    {
      for (int k = 0; k < 5; ++k)
        strain[k].copy_from(rows + k * W, std::experimental::vector_aligned);
      accumulated.copy_from(rows + 5 * W, std::experimental::vector_aligned);
    }
    void
    store(double *rows) const
    {
      for (int k = 0; k < 5; ++k)
        strain[k].copy_to(rows + k * W, std::experimental::vector_aligned);
      accumulated.copy_to(rows + 5 * W, std::experimental::vector_aligned);
    }
    /// Component k of xx, yy, zz, yz, xz, xy.
    Simd<W>
    component(const int k) const
    {
      return k < 2 ? strain[k] : k > 2 ? strain[k - 1] : -strain[0] - strain[1];
    }
  };

  /// Double contraction of symmetric tensors stored xx, yy, zz, yz, xz, xy.
  template <int W>
  inline Simd<W>
  contract(const Simd<W> (&a)[6], const Simd<W> (&b)[6])
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2. * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
  }

  /// The trial state, elastic from the history on: `deviator` becomes dev E - (1 + f H / 3 mu) E_p,
  /// which is the stress relative to the back stress over 2 mu. Returns the square of von Mises'
  /// equivalent of that stress [Pa2].
  template <int W>
  inline Simd<W>
  trial_state(const BilinearLaw &law,
              const Simd<W> (&E)[6],
              const PlasticHistory<W> &history,
              Simd<W> (&deviator)[6])
  {
    const Simd<W> mean   = (E[0] + E[1] + E[2]) * (1. / 3);
    const double  factor = 1 + law.kinematic_ratio;
    for (int k = 0; k < 6; ++k)
      deviator[k] = E[k] - factor * history.component(k) - (k < 3 ? mean : Simd<W>(0.));
    return (6 * law.shear * law.shear) * contract<W>(deviator, deviator);
  }

  /// Plastic flow of one step; all of it is zero in lanes that do not yield.
  template <int W>
  struct PlasticFlow
  {
    Simd<W> accumulated; ///< increment of the accumulated plastic strain
    /// The plastic strain grows by `part` times the trial deviator.
    Simd<W> part;
    /// Mean of the relative stresses at the begin and the end of the flow over the trial stress.
    Simd<W> middle;
  };

  /// Returns the trial stress along the radius to the yield surface. `equivalent`: of the trial
  /// state [Pa]; `accumulated`: plastic strain before the step.
  template <int W>
  inline PlasticFlow<W>
  radial_flow(const BilinearLaw &law, const Simd<W> &equivalent, const Simd<W> &accumulated)
  {
    namespace stdx       = std::experimental;
    const Simd<W>  limit = law.yield_stress + law.isotropic_hardening * accumulated;
    PlasticFlow<W> flow;
    flow.accumulated          = stdx::max(equivalent - limit, Simd<W>(0.)) * law.flow_compliance;
    const Simd<W> denominator = stdx::max(equivalent, limit); // differs from it where nothing flows
    flow.part                 = (3 * law.shear) * flow.accumulated / denominator;
    flow.middle               = (limit + (0.5 * law.isotropic_hardening) * flow.accumulated) / denominator;
    return flow;
  }

  /// Updates the history by a flow. Returns the plastic work, the integral of S : dE_p [J/m3]; the
  /// part of it that hardening stores is not told apart.
  template <int W>
  inline Simd<W>
  apply_flow(const BilinearLaw &law,
             const Simd<W> (&deviator)[6],
             const PlasticFlow<W> &flow,
             PlasticHistory<W>    &history)
  {
    Simd<W> back = 0.; // the back stress over 2 mu in the middle of the flow, times the deviator
    for (int k = 0; k < 6; ++k)
      back += (k < 3 ? 1. : 2.) * (history.component(k) + 0.5 * flow.part * deviator[k]) * deviator[k];
    const Simd<W> work = 2 * law.shear * flow.part *
                         (flow.middle * contract<W>(deviator, deviator) + law.kinematic_ratio * back);
    for (int k = 0; k < 5; ++k)
      history.strain[k] += flow.part * deviator[k < 2 ? k : k + 1];
    history.accumulated += flow.accumulated;
    return work;
  }

  /// S = K tr(E) I + 2 mu (dev E - E_p) [Pa].
  template <int W>
  inline void
  plastic_stress(const BilinearLaw &law,
                 const Simd<W> (&E)[6],
                 const PlasticHistory<W> &history,
                 Simd<W> (&S)[6])
  {
    const Simd<W> pressure = law.lambda * (E[0] + E[1] + E[2]);
    for (int k = 0; k < 6; ++k)
      S[k] = 2 * law.shear * (E[k] - history.component(k)) + (k < 3 ? pressure : Simd<W>(0.));
  }

  /// Stress of W points after a step to the strain E, with the history brought up to date.
  ///
  /// Returns whether any lane yielded; only then were `history` and `work` touched, so that a caller
  /// may leave out storing it. The plastic work of the step is added to `work` [J/m3], the integral
  /// of S : dE_p with the stress in the middle of the flow.
  template <int W>
  inline bool
  radial_return(const BilinearLaw &law,
                const Simd<W> (&E)[6],
                PlasticHistory<W> &history,
                Simd<W> (&S)[6],
                Simd<W> &work)
  {
    Simd<W>       deviator[6];
    const Simd<W> square  = trial_state<W>(law, E, history, deviator);
    const Simd<W> limit   = law.yield_stress + law.isotropic_hardening * history.accumulated;
    const bool    yielded = std::experimental::any_of(square > limit * limit);
    if (yielded)
      {
        const PlasticFlow<W> flow = radial_flow<W>(law, square_root<W>(square), history.accumulated);
        work += apply_flow<W>(law, deviator, flow, history);
      }
    plastic_stress<W>(law, E, history, S);
    return yielded;
  }

  /// Energy density that the elastic strain stores [J/m3]: S : (E - E_p) / 2.
  template <int W>
  inline Simd<W>
  elastic_energy(const Simd<W> (&E)[6], const PlasticHistory<W> &history, const Simd<W> (&S)[6])
  {
    Simd<W> elastic[6];
    for (int k = 0; k < 6; ++k)
      elastic[k] = E[k] - history.component(k);
    return 0.5 * contract<W>(S, elastic);
  }
} // namespace wheelrail
