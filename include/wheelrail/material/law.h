#pragma once

#include <wheelrail/base/simd.h>
#include <wheelrail/material/elastic.h>

// What the elements ask of a material law.
//
// A law is a plain struct derived from ElasticLaw, whose constants rule before any flow, in the hourglass
// stabilisation and in the bulk viscosity; those that flow derive from PlasticLaw (material/plastic.h). Its
// functions are templates on T, one number for each of some points (Simd<W>), and see Green's strain E and
// the second Piola-Kirchhoff stress S as xx, yy, zz, yz, xz, xy. It provides
//
//   static constexpr bool flows;  whether points remember anything; false makes the law elastic
//   int history_rows();           numbers that a point remembers
//   template <typename T> struct History;
//     What points remember, made from the law; all zero at the start. load(rows) and store(rows) move it
//     from and to history_rows() x T::size() aligned numbers.
//   void stress(E, history, S)             stress of a strain with the history given [Pa]
//   T    stored_energy(E, history, S)      what unloading gives back [J/m3]
//
// and, when it has a history (the flow of metals: a yield surface round a back stress),
//
//   T History<T>::accumulated              integral of sqrt(2/3 dE_p : dE_p) [1]
//   T trial(E, history, deviator)
//     `deviator` becomes the deviator of the stress less the back stress over 2 mu if nothing flowed.
//     Returns the square of its von Mises equivalent [Pa2].
//   T limit(history)                       radius of the yield surface as an equivalent stress [Pa]
//   PlasticFlow<T> flow(equivalent, deviator, history)
//     Brings the history up to date by the flow that takes `equivalent` back to the yield surface. In cells
//     with hourglass stresses it is larger than that of `deviator` [Pa].
//   T hardening_energy(history)   what hardening stores of the plastic work [J/m3]
//   double back_ratio                      back stress over 2 mu E_p, for the hourglass stresses that flow
//
// A new law is one header in material/, one more name in MaterialLaw (material/material_law.h), and the
// entries for its constants; no element and no file of the state names a law.

namespace wheelrail
{
  /// Whether points remember anything: whether a material of this law can flow.
  template <typename Law>
  constexpr bool has_history = Law::flows;

  /// Plastic flow of one step; all of it is zero in lanes that do not yield.
  template <typename T>
  struct PlasticFlow
  {
    T part;   ///< plastic amplitudes of hourglass patterns grow by `part` times the trial amplitudes
    T middle; ///< mean of the relative stresses at the begin and the end of the flow over the trial stress
    T work;   ///< plastic work, the integral of S : dE_p [J/m3]
  };

  /// Stress of points after a step to the strain E, with the history brought up to date.
  ///
  /// Returns whether any lane yielded; only then were `history` and `work` touched, so that a caller
  /// may leave out storing it. The plastic work of the step is added to `work` [J/m3].
  template <typename Law, typename T>
  inline bool
  point_response(const Law &law,
                 const T (&E)[6],
                 typename Law::template History<T> &history,
                 T (&S)[6],
                 T &work)
  {
    bool yielded = false;
    if constexpr (has_history<Law>)
      {
        T       deviator[6];
        const T square = law.trial(E, history, deviator);
        const T limit  = law.limit(history);
        yielded        = std::experimental::any_of(square > limit * limit);
        if (yielded)
          work += law.flow(square_root(square), deviator, history).work;
      }
    law.stress(E, history, S);
    return yielded;
  }
} // namespace wheelrail
