#pragma once

#include <wheelrail/material/cyclic_hardening.h>
#include <wheelrail/material/law.h>

#include <array>
#include <limits>

namespace wheelrail
{
  /// Cyclic plasticity after Chaboche (1986), on Green's strain E and the second Piola-Kirchhoff stress S as
  /// in material/bilinear.h: von Mises' yield condition q(dev S - sum X_i) <= Y + R, isotropic hardening R
  /// and any number of back stresses X_i. See material/law.h for what the functions are, and
  /// doc/theory/material.md for the equations.
  ///
  /// The step is the implicit one of Euler (Kobayashi and Ohno 2002): with theta_i = 1 / (1 + gamma_i dp),
  ///   X_i <- theta_i (X_i + 2/3 C_i dE_p),   R <- (R + b Q dp) / (1 + b dp),
  /// which leaves one equation for dp. Its left side falls at least as fast as -3 mu dp, since no X_i exceeds
  /// C_i / gamma_i, so that it has one root for any step, and Newton's steps are kept between bounds.
  struct ChabocheLaw : ElasticLaw
  {
    static constexpr bool   flows      = true;
    static constexpr double back_ratio = 0; ///< the hourglass stresses have no back stress

    using Constants = std::array<double, most_back_stresses>;

    double    yield_stress;   ///< Y [Pa]
    double    isotropic;      ///< Q [Pa]
    double    isotropic_rate; ///< b
    int       n_back;         ///< number of back stresses
    Constants modulus{};      ///< C_i [Pa]
    Constants recovery{};     ///< the part of gamma_i that acts below the threshold
    Constants threshold{};    ///< C_i / gamma_i, infinite where gamma_i is zero [Pa]
    bool      bounded;        ///< thresholds are watched: not all of the recovery acts below them
    double    least_slope;    ///< the equation for dp falls at least as fast [Pa]
    double    curvature; ///< at least half the second derivative of that equation, without thresholds [Pa]

    /// The numbers of moduli and rates must be equal.
    ChabocheLaw(const Elasticity &constants, const CyclicHardening &hardening);

    /// E_p and its accumulation as in BilinearLaw, R, and five numbers for each back stress.
    int
    history_rows() const
    {
      return 7 + 5 * n_back;
    }

    template <typename T>
    struct History
    {
      int n_back;
      T   strain[5]   = {0., 0., 0., 0., 0.};
      T   accumulated = 0.;
      T   hardened    = 0.;            ///< R [Pa]
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
      /// Component k of xx, yy, zz, yz, xz, xy.
      T
      component(const int k) const
      {
        return k < 2 ? strain[k] : k > 2 ? strain[k - 1] : -strain[0] - strain[1];
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

    /// Double contraction of two deviators of five numbers each.
    template <typename T>
    static T
    contract_deviators(const T (&a)[5], const T (&b)[5])
    {
      return a[0] * (2. * b[0] + b[1]) + a[1] * (2. * b[1] + b[0]) +
             2. * (a[2] * b[2] + a[3] * b[3] + a[4] * b[4]);
    }

    /// S = K tr(E) I + 2 mu (dev E - E_p) [Pa].
    template <typename T>
    void
    stress(const T (&E)[6], const History<T> &history, T (&S)[6]) const
    {
      const T pressure = lambda * (E[0] + E[1] + E[2]);
      for (int k = 0; k < 6; ++k)
        S[k] = 2 * shear * (E[k] - history.component(k)) + (k < 3 ? pressure : T(0.));
    }

    /// S : (E - E_p) / 2 [J/m3].
    template <typename T>
    T
    stored_energy(const T (&E)[6], const History<T> &history, const T (&S)[6]) const
    {
      T elastic[6];
      for (int k = 0; k < 6; ++k)
        elastic[k] = E[k] - history.component(k);
      return 0.5 * contract(S, elastic);
    }

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
    /// 3/2 of the contractions of the trial stress with itself and with the back stresses, and among these
    /// [Pa2]: all that the equation for dp asks for.
    template <int N, typename T>
    struct Products
    {
      T own, with[N], among[N][N];
    };

    /// Where a guess of dp leads to.
    template <int N, typename T>
    struct Guess
    {
      T dp = 0.;
      T gone[N];  ///< 1 - theta: of X_i + 2/3 C_i dE_p
      T along[N]; ///< 3/2 X_i : (dev S - sum X_i) / equivalent, where thresholds are watched [Pa]
      T ratio;    ///< equivalent without the share of the hourglass stresses over the one with it, likewise
      T turned;   ///< change of `along` since the guess before, likewise [Pa]
      T miss;     ///< of the yield condition [Pa]
      T step;     ///< Newton's step
    };

    /// The number of back stresses, known to the compiler where it is small.
    template <int N>
    int
    count() const
    {
      return N < most_back_stresses ? N : n_back;
    }

    template <int N, typename T>
    T
    part_gone(const Products<N, T> &products, const Guess<N, T> &guess, int i, T &change) const;

    template <int N, typename T>
    void
    set_step(const T &equivalent,
             const T &hardened,
             const T (&raw)[N],
             const T (&change)[N],
             Guess<N, T> &guess) const;

    template <int N, typename T>
    void
    follow(const Products<N, T> &products, const T &beyond, const T &hardened, Guess<N, T> &guess) const;

    template <int N, typename T>
    void
    solve(const Products<N, T> &products, const T &equivalent, const T &hardened, Guess<N, T> &guess) const;

    template <int N, typename T>
    PlasticFlow<T>
    flow_of(const T &equivalent, const T (&deviator)[6], History<T> &history) const;
  };


  /// 1 - theta of back stress i by the direction of the guess; `change`: how it grows with dp.
  template <int N, typename T>
  inline T
  ChabocheLaw::part_gone(const Products<N, T> &products,
                         const Guess<N, T>    &guess,
                         const int             i,
                         T                    &change) const
  {
    namespace stdx = std::experimental;
    const T theta  = 1. / (1. + recovery[i] * guess.dp);
    T       gone   = recovery[i] * guess.dp * theta;
    change         = recovery[i] * theta * theta;
    if (!bounded)
      return gone;
    const T step   = modulus[i] * guess.dp;
    const T square = stdx::max(
      products.among[i][i] + step * (2. * guess.along[i] + step * guess.ratio * guess.ratio), T(1e-300));
    const auto over = theta * theta * square > threshold[i] * threshold[i] && guess.dp > 0.;
    if (stdx::any_of(over))
      {
        const T projected         = threshold[i] / square_root(square);
        stdx::where(over, gone)   = 1. - projected;
        stdx::where(over, change) = projected * modulus[i] * (guess.along[i] + step) / square;
      }
    return gone;
  }


  /// What the yield condition misses at the guess and Newton's step from there; `raw`: 3/2 X_i : (dev S - sum
  /// X_i).
  template <int N, typename T>
  inline void
  ChabocheLaw::set_step(const T &equivalent,
                        const T &hardened,
                        const T (&raw)[N],
                        const T (&change)[N],
                        Guess<N, T> &guess) const
  {
    namespace stdx = std::experimental;
    const T grown  = 1. / (1. + isotropic_rate * guess.dp);
    T       bears =
      yield_stress + (hardened + (isotropic * isotropic_rate) * guess.dp) * grown + (3 * shear) * guess.dp;
    T slope   = 3 * shear + isotropic_rate * (isotropic - hardened) * grown * grown;
    T turning = 0.;
    for (int i = 0; i < count<N>(); ++i)
      {
        const T left = modulus[i] * (1. - guess.gone[i]);
        bears += left * guess.dp;
        slope += left - change[i] * modulus[i] * guess.dp;
        turning += change[i] * raw[i];
      }
    guess.miss = equivalent - bears;
    // the slope is slope - turning / equivalent
    guess.step = guess.miss * equivalent / stdx::max(slope * equivalent - turning, least_slope * equivalent);
  }


  /// Follows the guess of dp; `beyond`: share of the hourglass stresses in the equivalent.
  template <int N, typename T>
  inline void
  ChabocheLaw::follow(const Products<N, T> &products,
                      const T              &beyond,
                      const T              &hardened,
                      Guess<N, T>          &guess) const
  {
    namespace stdx = std::experimental;
    const int n    = count<N>();
    T         change[N], raw[N], square = products.own;
    for (int i = 0; i < n; ++i)
      guess.gone[i] = part_gone(products, guess, i, change[i]);
    for (int i = 0; i < n; ++i)
      {
        raw[i] = products.with[i];
        for (int j = 0; j < n; ++j)
          raw[i] += guess.gone[j] * products.among[i][j];
        square += guess.gone[i] * (products.with[i] + raw[i]);
      }
    const T own        = square_root(stdx::max(square, T(0.)));
    const T equivalent = stdx::max(own + beyond, T(1e-6 * yield_stress)); // lanes at rest
    set_step(equivalent, hardened, raw, change, guess);
    if (!bounded)
      return;
    guess.ratio  = own / equivalent;
    guess.turned = 0.;
    for (int i = 0; i < n; ++i)
      {
        raw[i]         = raw[i] / equivalent;
        guess.turned   = stdx::max(guess.turned, stdx::abs(raw[i] - guess.along[i]));
        guess.along[i] = raw[i];
      }
  }


  /// Newton's steps for dp; lanes that are done, or do not flow, stay as they are. The last step is not
  /// followed where what it leaves is known to be too small.
  template <int N, typename T>
  inline void
  ChabocheLaw::solve(const Products<N, T> &products,
                     const T              &equivalent,
                     const T              &hardened,
                     Guess<N, T>          &guess) const
  {
    namespace stdx = std::experimental;
    const T before = yield_stress + hardened;
    const T enough = 1e-9 * before + 1e-14 * equivalent; // the latter some hundred times its round-off
    const T own = square_root(products.own), beyond = equivalent - own;
    const T at_least = stdx::max(equivalent, T(1e-6 * yield_stress)); // lanes at rest
    auto    open     = equivalent > before;
    T       change[N];
    for (int i = 0; i < count<N>(); ++i)
      {
        guess.gone[i]  = 0.;
        change[i]      = recovery[i];
        guess.along[i] = products.with[i] / at_least;
      }
    guess.ratio  = own / at_least;
    guess.turned = std::numeric_limits<double>::infinity();
    set_step(at_least, hardened, products.with, change, guess);
    T low(0.), high = stdx::max(guess.miss, T(0.)) / least_slope;
    for (int iteration = 0;; ++iteration)
      {
        const auto short_of          = guess.miss > 0.;
        stdx::where(short_of, low)   = guess.dp;
        stdx::where(!short_of, high) = stdx::min(high, guess.dp);
        T next                       = guess.dp + guess.step;
        // with thresholds the equation changes a little from guess to guess, and so would the bounds
        if (!bounded)
          stdx::where(next < low || next > high, next) = 0.5 * (low + high);
        const T moved               = next - guess.dp;
        stdx::where(open, guess.dp) = stdx::max(next, T(0.));
        auto left                   = curvature * moved * moved > enough;
        if (bounded) // the directions that thresholds were watched along lag behind
          left = left || stdx::abs(guess.miss) > enough || guess.turned > enough;
        open = open && left;
        if (iteration == 100 || !stdx::any_of(open))
          break;
        follow(products, beyond, hardened, guess);
      }
    for (int i = 0; i < count<N>(); ++i)
      guess.gone[i] = part_gone(products, guess, i, change[i]);
  }


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
