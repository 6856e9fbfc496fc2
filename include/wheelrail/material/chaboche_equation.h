#pragma once

#include <wheelrail/material/cyclic_hardening.h>
#include <wheelrail/material/plastic.h>

#include <array>
#include <limits>

namespace wheelrail
{
  /// Constants of Chaboche's law and the equation for the plastic strain increment dp of one implicit step;
  /// see material/chaboche.h. Newton's steps are kept between bounds, and lanes that are done stay as they
  /// are.
  struct ChabocheEquation : PlasticLaw
  {
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
    ChabocheEquation(const Elasticity &constants, const CyclicHardening &hardening);

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
  };


  /// 1 - theta of back stress i by the direction of the guess; `change`: how it grows with dp.
  template <int N, typename T>
  inline T
  ChabocheEquation::part_gone(const Products<N, T> &products,
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
  ChabocheEquation::set_step(const T &equivalent,
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
  ChabocheEquation::follow(const Products<N, T> &products,
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
  ChabocheEquation::solve(const Products<N, T> &products,
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
    // a line, as without hardening, is solved by the first step, which round-off must not put beyond the
    // bound
    T low(0.), high = stdx::max(guess.miss, T(0.)) * ((1 + 1e-9) / least_slope);
    for (int iteration = 0;; ++iteration)
      {
        const auto short_of          = guess.miss > 0.;
        stdx::where(short_of, low)   = guess.dp;
        stdx::where(!short_of, high) = stdx::min(high, guess.dp);
        T next                       = guess.dp + guess.step;
        // with thresholds the equation changes a little from guess to guess, and so would the bounds
        const auto beside           = decltype(open)(!bounded) && (next < low || next > high);
        stdx::where(beside, next)   = 0.5 * (low + high);
        const T moved               = next - guess.dp;
        stdx::where(open, guess.dp) = stdx::max(next, T(0.));
        // what Newton's step leaves; half an interval leaves anything
        auto left = curvature * moved * moved > enough || beside;
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
} // namespace wheelrail
