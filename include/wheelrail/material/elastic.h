#pragma once

#include <wheelrail/material/elasticity.h>

namespace wheelrail
{
  /// Double contraction of symmetric tensors stored xx, yy, zz, yz, xz, xy.
  template <typename T>
  inline T
  contract(const T (&a)[6], const T (&b)[6])
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2. * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
  }

  /// The law of Saint Venant and Kirchhoff on Green's strain E and the second Piola-Kirchhoff stress
  /// S = lambda tr(E) I + 2 mu E, both stored xx, yy, zz, yz, xz, xy. What a law provides: material/law.h.
  struct ElasticLaw
  {
    Elasticity elasticity;
    double     lambda, shear; ///< Lame's constants [Pa]

    /// Not explicit: elastic constants alone are an elastic material.
    ElasticLaw(const Elasticity &constants = Elasticity())
      : elasticity(constants)
      , lambda(constants.lame_lambda())
      , shear(constants.shear_modulus())
    {
    }

    static constexpr bool flows = false;

    static constexpr int
    history_rows()
    {
      return 0;
    }

    template <typename T>
    struct History
    {
      explicit History(const ElasticLaw &)
      {
      }
      void
      load(const double *)
      {
      }
      void
      store(double *) const
      {
      }
    };

    /// Stress without a history [Pa]; of the laws built on this one, the stress before any flow.
    template <typename T>
    void
    elastic_stress(const T (&E)[6], T (&S)[6]) const
    {
      const T pressure = lambda * (E[0] + E[1] + E[2]);
      for (int k = 0; k < 6; ++k)
        S[k] = 2 * shear * E[k] + (k < 3 ? pressure : T(0.));
    }

    template <typename T>
    void
    stress(const T (&E)[6], const History<T> &, T (&S)[6]) const
    {
      elastic_stress(E, S);
    }

    /// S : E / 2 [J/m3].
    template <typename T>
    T
    stored_energy(const T (&E)[6], const History<T> &, const T (&S)[6]) const
    {
      return 0.5 * contract(S, E);
    }
  };
} // namespace wheelrail
