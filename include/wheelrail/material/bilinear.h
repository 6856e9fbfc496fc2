#pragma once

#include <wheelrail/material/law.h>
#include <wheelrail/material/plastic.h>

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

  /// Both sets of constants in the form that the return mapping uses, and the law; see material/law.h.
  ///
  /// Small-strain J2 plasticity in total form (Simo and Hughes 1998, boxes 3.1 and 3.2), on Green's
  /// strain E and the second Piola-Kirchhoff stress S, both stored xx, yy, zz, yz, xz, xy:
  /// S = K tr(E) I + 2 mu (dev E - E_p). The back stress of Prager's linear kinematic hardening is
  /// 2/3 f H E_p, so the plastic strain is the only tensor to remember.
  struct BilinearLaw : PlasticLaw
  {
    double yield_stress;        ///< [Pa]
    double isotropic_hardening; ///< (1 - f) H [Pa]
    double back_ratio;          ///< back stress over 2 mu E_p: f H / (3 mu)
    double flow_compliance;     ///< 1 / (3 mu + H) [1/Pa]
    /// Slope of shear stress over shear strain in plastic flow, relative to mu: H / (3 mu + H).
    double tangent_ratio;

    BilinearLaw(const Elasticity &constants, const Plasticity &plasticity)
      : PlasticLaw(constants)
      , yield_stress(plasticity.yield_stress)
    {
      const double H      = plasticity.hardening_modulus(constants);
      isotropic_hardening = (1 - plasticity.kinematic_fraction) * H;
      back_ratio          = plasticity.kinematic_fraction * H / (3 * shear);
      flow_compliance     = 1 / (3 * shear + H);
      tangent_ratio       = H / (3 * shear + H);
    }

    static constexpr int
    history_rows()
    {
      return 6;
    }

    template <typename T>
    struct History : PlasticStrain<T>
    {
      History() = default;
      explicit History(const BilinearLaw &)
      {
      }

      void
      load(const double *rows)
      {
        for (int k = 0; k < 5; ++k)
          this->strain[k].copy_from(rows + k * T::size(), std::experimental::vector_aligned);
        this->accumulated.copy_from(rows + 5 * T::size(), std::experimental::vector_aligned);
      }
      void
      store(double *rows) const
      {
        for (int k = 0; k < 5; ++k)
          this->strain[k].copy_to(rows + k * T::size(), std::experimental::vector_aligned);
        this->accumulated.copy_to(rows + 5 * T::size(), std::experimental::vector_aligned);
      }
    };

    /// The trial deviator is dev E - (1 + f H / 3 mu) E_p.
    template <typename T>
    T
    trial(const T (&E)[6], const History<T> &history, T (&deviator)[6]) const
    {
      const T      mean   = (E[0] + E[1] + E[2]) * (1. / 3);
      const double factor = 1 + back_ratio;
      for (int k = 0; k < 6; ++k)
        deviator[k] = E[k] - factor * history.component(k) - (k < 3 ? mean : T(0.));
      return (6 * shear * shear) * contract(deviator, deviator);
    }

    template <typename T>
    T
    limit(const History<T> &history) const
    {
      return yield_stress + isotropic_hardening * history.accumulated;
    }

    /// f H / 3 E_p : E_p and (1 - f) H a^2 / 2 [J/m3].
    template <typename T>
    T
    hardening_energy(const History<T> &history) const
    {
      T strain[6];
      for (int k = 0; k < 6; ++k)
        strain[k] = history.component(k);
      return (back_ratio * shear) * contract(strain, strain) +
             (0.5 * isotropic_hardening) * history.accumulated * history.accumulated;
    }

    /// Along the radius. The work is that of the stress in the middle of the flow.
    template <typename T>
    PlasticFlow<T>
    flow(const T &equivalent, const T (&deviator)[6], History<T> &history) const
    {
      namespace stdx             = std::experimental;
      const T        before      = limit(history);
      const T        accumulated = stdx::max(equivalent - before, T(0.)) * flow_compliance;
      const T        denominator = stdx::max(equivalent, before); // differs from it where nothing flows
      PlasticFlow<T> result;
      result.part   = (3 * shear) * accumulated / denominator;
      result.middle = (before + (0.5 * isotropic_hardening) * accumulated) / denominator;
      T back        = 0.; // the back stress over 2 mu in the middle of the flow, times the deviator
      for (int k = 0; k < 6; ++k)
        back += (k < 3 ? 1. : 2.) * (history.component(k) + 0.5 * result.part * deviator[k]) * deviator[k];
      result.work =
        2 * shear * result.part * (result.middle * contract(deviator, deviator) + back_ratio * back);
      for (int k = 0; k < 5; ++k)
        history.strain[k] += result.part * deviator[k < 2 ? k : k + 1];
      history.accumulated += accumulated;
      return result;
    }
  };
} // namespace wheelrail
