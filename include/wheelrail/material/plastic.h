#pragma once

#include <wheelrail/base/simd.h>
#include <wheelrail/material/elastic.h>

namespace wheelrail
{
  /// Double contraction of two deviators of five numbers each: xx, yy, yz, xz, xy.
  template <typename T>
  inline T
  contract_deviators(const T (&a)[5], const T (&b)[5])
  {
    return a[0] * (2. * b[0] + b[1]) + a[1] * (2. * b[1] + b[0]) +
           2. * (a[2] * b[2] + a[3] * b[3] + a[4] * b[4]);
  }


  /// What points remember of the flow of a metal, whatever its hardening.
  template <typename T>
  struct PlasticStrain
  {
    T strain[5]   = {0., 0., 0., 0., 0.}; ///< plastic strain E_p, whose trace is zero: xx, yy, yz, xz, xy
    T accumulated = 0.;                   ///< integral of sqrt(2/3 dE_p : dE_p)

    /// Component k of xx, yy, zz, yz, xz, xy.
    T
    component(const int k) const
    {
      return k < 2 ? strain[k] : k > 2 ? strain[k - 1] : -strain[0] - strain[1];
    }
  };


  /// Base of the laws that flow: their stress is that of the elastic part of the strain, E - E_p.
  struct PlasticLaw : ElasticLaw
  {
    using ElasticLaw::ElasticLaw;

    static constexpr bool flows = true;

    /// S = K tr(E) I + 2 mu (dev E - E_p) [Pa].
    template <typename T>
    void
    stress(const T (&E)[6], const PlasticStrain<T> &history, T (&S)[6]) const
    {
      const T pressure = lambda * (E[0] + E[1] + E[2]);
      for (int k = 0; k < 6; ++k)
        S[k] = 2 * shear * (E[k] - history.component(k)) + (k < 3 ? pressure : T(0.));
    }

    /// S : (E - E_p) / 2 [J/m3].
    template <typename T>
    T
    stored_energy(const T (&E)[6], const PlasticStrain<T> &history, const T (&S)[6]) const
    {
      T elastic[6];
      for (int k = 0; k < 6; ++k)
        elastic[k] = E[k] - history.component(k);
      return 0.5 * contract(S, elastic);
    }
  };
} // namespace wheelrail
