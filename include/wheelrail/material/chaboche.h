#pragma once

#include <wheelrail/material/chaboche_equation.h>
#include <wheelrail/material/law.h>

namespace wheelrail
{
  /// Cyclic plasticity after Chaboche (1986), on Green's strain E and the second Piola-Kirchhoff stress S as
  /// in material/bilinear.h: von Mises' yield condition q(dev S - sum X_i) <= Y + R, isotropic hardening R
  /// and any number of back stresses X_i. See material/law.h for what the functions are, and
  /// doc/manual/material.md for the equations.
  ///
  /// The step is the implicit one of Euler (Kobayashi and Ohno 2002): with theta_i = 1 / (1 + gamma_i dp),
  ///   X_i <- theta_i (X_i + 2/3 C_i dE_p),   R <- (R + b Q dp) / (1 + b dp),
  /// which leaves one equation for dp. Its left side falls at least as fast as -3 mu dp, since no X_i exceeds
  /// C_i / gamma_i, so that it has one root for any step, and Newton's steps are kept between bounds.
  struct ChabocheLaw : ChabocheEquation
  {
    static constexpr double back_ratio = 0; ///< the hourglass stresses have no back stress

    using ChabocheEquation::ChabocheEquation;

    /// E_p and its accumulation as in BilinearLaw, R, and five numbers for each back stress.
    int
    history_rows() const
    {
      return 7 + 5 * n_back;
    }

    template <typename T>
    struct History : PlasticStrain<T>
    {
      int n_back;
      T   hardened = 0.;               ///< R [Pa]
      T   back[most_back_stresses][5]; ///< the first n_back are in use: xx, yy, yz, xz, xy [Pa]

      explicit History(const ChabocheLaw &law)
        : n_back(law.n_back)
      {
        for (int i = 0; i < n_back; ++i)
          for (T &component : back[i])
            component = 0.;
      }

      void
      load(const double *rows)
      {
        visit(*this, [&](T &value) {
          value.copy_from(rows, std::experimental::vector_aligned);
          rows += T::size();
        });
      }
      void
      store(double *rows) const
      {
        visit(*this, [&](const T &value) {
          value.copy_to(rows, std::experimental::vector_aligned);
          rows += T::size();
        });
      }

    private:
      template <typename Rows, typename Visit>
      static void
      visit(Rows &history, const Visit &value)
      {
        for (auto &component : history.strain)
          value(component);
        value(history.accumulated);
        value(history.hardened);
        for (int i = 0; i < history.n_back; ++i)
          for (auto &component : history.back[i])
            value(component);
      }
    };

    /// Sum of q(X_i)^2 / (2 C_i), and R^2 / (2 b Q) [J/m3].
    template <typename T>
    T
    hardening_energy(const History<T> &history) const
    {
      const double iso = isotropic * isotropic_rate;
      T            sum = iso != 0 ? history.hardened * history.hardened * (0.5 / iso) : T(0.);
      for (int i = 0; i < n_back; ++i)
        sum += (0.75 / modulus[i]) * contract_deviators(history.back[i], history.back[i]);
      return sum;
    }

    template <typename T>
    T
    trial(const T (&E)[6], const History<T> &history, T (&deviator)[6]) const
    {
      const T      mean    = (E[0] + E[1] + E[2]) * (1. / 3);
      const double factor  = 1 / (2 * shear);
      T            back[5] = {0., 0., 0., 0., 0.};
      for (int i = 0; i < n_back; ++i)
        for (int k = 0; k < 5; ++k)
          back[k] += history.back[i][k];
      for (int k = 0; k < 6; ++k)
        {
          const T X   = k < 2 ? back[k] : k > 2 ? back[k - 1] : -back[0] - back[1];
          deviator[k] = E[k] - history.component(k) - factor * X - (k < 3 ? mean : T(0.));
        }
      return (6 * shear * shear) * contract(deviator, deviator);
    }

    template <typename T>
    T
    limit(const History<T> &history) const
    {
      return yield_stress + history.hardened;
    }

    template <typename T>
    PlasticFlow<T>
    flow(const T &equivalent, const T (&deviator)[6], History<T> &history) const;

  private:
    template <int N, typename T>
    PlasticFlow<T>
    flow_of(const T &equivalent, const T (&deviator)[6], History<T> &history) const;
  };


  template <int N, typename T>
  [[gnu::noinline]] PlasticFlow<T>
  ChabocheLaw::flow_of(const T &equivalent, const T (&deviator)[6], History<T> &history) const
  {
    namespace stdx     = std::experimental;
    const int  n       = count<N>();
    const T    before  = limit(history);
    const auto flowing = equivalent > before;
    T          relative[5]; // dev S - sum X_i, of the trial and then before it is scaled back
    for (int k = 0; k < 5; ++k)
      relative[k] = (2 * shear) * deviator[k < 2 ? k : k + 1];

    Products<N, T> products;
    products.own = 1.5 * contract_deviators(relative, relative);
    for (int i = 0; i < n; ++i)
      {
        products.with[i] = 1.5 * contract_deviators(relative, history.back[i]);
        for (int j = 0; j <= i; ++j)
          products.among[i][j] = products.among[j][i] =
            1.5 * contract_deviators(history.back[i], history.back[j]);
      }
    Guess<N, T> guess;
    solve(products, equivalent, history.hardened, guess);

    const T dp       = guess.dp;
    history.hardened = (history.hardened + (isotropic * isotropic_rate) * dp) / (1. + isotropic_rate * dp);
    history.accumulated += dp;
    // the equivalent before the stress is scaled back, by the equation that is solved
    T scaled = limit(history) + (3 * shear) * dp;
    for (int i = 0; i < n; ++i)
      scaled += (1. - guess.gone[i]) * modulus[i] * dp;
    const T        inverse = 1. / scaled;
    PlasticFlow<T> result;
    result.part   = (3 * shear) * dp * inverse;
    result.middle = 0.5 * (before + limit(history)) * inverse;
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < 5; ++k)
        relative[k] += guess.gone[i] * history.back[i][k];
    T increment[5]; // of the plastic strain
    for (int k = 0; k < 5; ++k)
      {
        increment[k] = 1.5 * dp * inverse * relative[k];
        history.strain[k] += increment[k];
      }
    T mean[5]; // of the stress over the flow
    for (int k = 0; k < 5; ++k)
      mean[k] = result.middle * relative[k];
    for (int i = 0; i < n; ++i)
      {
        const T theta = 1. - guess.gone[i];
        for (int k = 0; k < 5; ++k)
          {
            const T next = theta * (history.back[i][k] + (2. / 3 * modulus[i]) * increment[k]);
            mean[k] += 0.5 * (history.back[i][k] + next);
            stdx::where(flowing, history.back[i][k]) = next;
          }
      }
    result.work = contract_deviators(mean, increment);
    return result;
  }


  template <typename T>
  PlasticFlow<T>
  ChabocheLaw::flow(const T &equivalent, const T (&deviator)[6], History<T> &history) const
  {
    switch (n_back)
      {
        case 1:
          return flow_of<1>(equivalent, deviator, history);
        case 2:
          return flow_of<2>(equivalent, deviator, history);
        case 3:
          return flow_of<3>(equivalent, deviator, history);
        default:
          return flow_of<most_back_stresses>(equivalent, deviator, history);
      }
  }
} // namespace wheelrail
