#include <deal.II/lac/lapack_templates.h>

#include <wheelrail/base/errors.h>
#include <wheelrail/bodies/section_waves.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

// Waves of a rail at one frequency: all k with (K0 + k K1 + k^2 K2 - omega^2 M) u = 0, on a basis of some
// dozens of motions (Galerkin). 1. basis: slow motions at real wavenumbers, and static responses to the
// forces for near fields; 2. K0, K1, K2, M on it; 3. eigenvalues k^2 by LAPACK; 4. responses as sums of
// residues of waves that decay.

namespace wheelrail
{
  namespace
  {
    using Complex = std::complex<double>;
    /// The part of a motion along the body, or in the plane of its section; empty where there is none.
    std::vector<double>
    part(std::vector<double> motion, const bool along)
    {
      // K1 couples plane and along alone, hence two separate parts of the basis
      bool any = false;
      for (std::size_t d = 0; d < motion.size(); ++d)
        if ((d % 3 == 2) != along)
          motion[d] = 0;
        else
          any = any || motion[d] != 0;
      return any ? motion : std::vector<double>();
    }

    /// Eigenvalues and eigenvectors, one after the other, of a matrix that is stored column after column.
    /// False: they were not found.
    bool
    find_eigenvectors(std::vector<Complex>  matrix,
                      std::vector<Complex> &values,
                      std::vector<Complex> &vectors)
    {
      // right eigenvectors alone; the matrix is not symmetric
      const int            n = values.size(), length = 40 * n, one = 1;
      int                  code = 0;
      std::vector<Complex> work(length);
      std::vector<double>  real_work(2 * n);
      dealii::geev("N",
                   "V",
                   &n,
                   matrix.data(),
                   &n,
                   values.data(),
                   nullptr,
                   &one,
                   vectors.data(),
                   &n,
                   work.data(),
                   &length,
                   real_work.data(),
                   &code);
      return code == 0;
    }
  } // namespace


  SectionWaves::SectionWaves(const WaveMatrices &matrices, const std::vector<SectionForce> &forces)
    : matrices_(matrices)
    , forces_(forces)
  {
    // wavenumbers up to those of the slowest waves at some 6 kHz, and of near fields [1/m]
    constexpr double travelling[] = {0.2, 3, 7, 12, 20, 32, 50}, near[] = {1, 10, 30, 80, 200, 500};
    constexpr double shift = 2e7; // (700 Hz)^2 [rad2/s2]
    constexpr double least = 1e-10;
    // 1. Slow motions of travelling waves; 2. near fields of each force; 3. orthonormal directions of both
    SectionColumns plane, along;
    const auto     keep = [&](const std::vector<double> &motion) {
      for (const bool is_along : {false, true})
        if (auto own = part(motion, is_along); !own.empty())
          (is_along ? along : plane).push_back(std::move(own));
    };
    for (const double k : travelling)
      for (const auto &motion : slow_motions(matrices_, k, 12))
        keep(motion);
    for (const double k : near)
      {
        ShiftedSection solver(matrices_, k, shift);
        for (const SectionForce &force : forces_)
          {
            std::vector<double> f(matrices_.size(), 0.);
            for (const auto &[d, share] : force.shares)
              f[d] += share;
            // (K(k) + shift M)^-1 f: what a force does near itself, which decays as exp(-k z)
            keep(solver.solve(f));
          }
      }
    SectionColumns    basis   = common_directions(matrices_, plane, least);
    const std::size_t n_plane = basis.size();
    for (auto &direction : common_directions(matrices_, along, least))
      basis.push_back(std::move(direction));
    reduce(basis, n_plane);
  }


  void
  SectionWaves::reduce(const SectionColumns &basis, const std::size_t n_plane)
  {
    n_       = basis.size();
    n_plane_ = n_plane;
    std::array<std::vector<double>, 4> reduced;
    for (int p = 0; p < 4; ++p)
      {
        std::array<double, 4> factor{};
        factor[p] = 1;
        reduced[p].resize(n_ * n_);
        for (std::size_t j = 0; j < n_; ++j)
          {
            const auto column = product(matrices_, factor, basis[j]);
            for (std::size_t i = 0; i < n_; ++i)
              // Galerkin: k_p = X' K_p X, m = X' M X on the basis X of motions in the plane, then along
              reduced[p][i + n_ * j] = std::inner_product(column.begin(), column.end(), basis[i].begin(), 0.);
          }
      }
    k0_ = reduced[0], k1_ = reduced[1], k2_ = reduced[2], m_ = reduced[3];
    // what k^2 goes with: K2, and of K1 what the motion along does to the plane
    std::vector<double> with_square = k2_;
    for (std::size_t i = 0; i < n_plane_; ++i)
      for (std::size_t j = n_plane_; j < n_; ++j)
        // K1 couples plane and along alone. With u = (plane, k along) in place of (plane, along) the problem
        // (K0 + k K1 + k^2 K2 - w^2 M) u = 0 has k^2 alone, of half the size of the usual linearisation in k:
        // its eigenvalues come as +-k.
        with_square[i + n_ * j] += k1_[i + n_ * j];
    // B^-1 once, for all frequencies
    b_.assign(n_ * n_, 0.);
    for (std::size_t i = 0; i < n_; ++i)
      b_[i + n_ * i] = 1;
    // LU of B with pivots (LAPACK): K2 and K1 together are not symmetric
    const int        n = n_;
    std::vector<int> pivot(n_);
    int              code = 0;
    dealii::getrf(&n, &n, with_square.data(), &n, pivot.data(), &code);
    dealii::getrs("N", &n, &n, with_square.data(), &n, pivot.data(), b_.data(), &n, &code);
    for (const SectionForce &force : forces_)
      {
        // f' X: displacement along a force
        auto &at = at_.emplace_back(n_, 0.);
        for (std::size_t j = 0; j < n_; ++j)
          for (const auto &[d, share] : force.shares)
            at[j] += share * basis[j][d];
      }
  }


  std::vector<Complex>
  SectionWaves::eigenmatrix(const Complex w, const Complex steel, const std::vector<Complex> &springs) const
  {
    // A of A u = -k^2 B u
    std::vector<Complex> a(n_ * n_), c(n_ * n_, 0.);
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < n_; ++j)
        {
          // K0 and M couple like parts alone
          const bool same     = (i < n_plane_) == (j < n_plane_);
          const bool to_along = i >= n_plane_ && j < n_plane_;
          // u = (x, y, k w): below, K1 stands without k
          a[i + n_ * j] = (same ? k0_[i + n_ * j] * steel - w * w * m_[i + n_ * j] : 0.) +
                          (to_along ? k1_[i + n_ * j] * steel : 0.);
        }
    for (std::size_t s = 0; s < springs.size(); ++s)
      if (springs[s] != 0.)
        for (std::size_t i = 0; i < n_; ++i)
          for (std::size_t j = 0; j < n_; ++j)
            // f s f': a spring on the direction of a force
            a[i + n_ * j] += springs[s] * at_[s][i] * at_[s][j];
    for (std::size_t j = 0; j < n_; ++j)
      for (std::size_t l = 0; l < n_; ++l)
        {
          // k^2 u = -(K2 + K1)^-1 (K0 - w^2 M/steel + K1' + springs/steel) u
          const Complex factor = -a[l + n_ * j] / steel;
          if (factor != 0.)
            for (std::size_t i = 0; i < n_; ++i)
              c[i + n_ * j] += b_[i + n_ * l] * factor;
        }
    return c;
  }


  std::vector<SectionWaves::Wave>
  SectionWaves::waves(const Complex w, const double loss, const std::vector<Complex> &springs) const
  {
    // hysteretic damping: E (1 + i loss)
    const Complex        steel(1, loss);
    std::vector<Complex> squares(n_), shapes(n_ * n_);
    if (!find_eigenvectors(eigenmatrix(w, steel, springs), squares, shapes))
      throw RunError("The waves of the section could not be found at " +
                     std::to_string(w.real() / (2 * M_PI)) + " Hz.");
    std::vector<Wave> all;
    // each wave: k, displacement at the forces, denominator of its residue
    for (std::size_t s = 0; s < n_; ++s)
      {
        Wave wave;
        // k^2 has two roots: this wave and its mirror image towards -z
        wave.k = std::sqrt(squares[s]);
        // waves that decay towards +z, exp(-i k z) with Im k < 0
        if (wave.k.imag() > 0)
          wave.k = -wave.k;
        Complex *const shape = &shapes[n_ * s];
        for (std::size_t i = n_plane_; i < n_; ++i)
          // back to u = (plane, along): along is k times the unknown
          shape[i] *= wave.k;
        for (const auto &at : at_)
          {
            Complex sum = 0;
            for (std::size_t i = 0; i < n_; ++i)
              sum += at[i] * shape[i];
            wave.at.push_back(sum);
          }
        for (std::size_t j = 0; j < n_; ++j)
          {
            Complex sum = 0;
            for (std::size_t i = 0; i < n_; ++i)
              // u' (dD/dk) u = steel u' (K1 + 2 k K2) u, the denominator of the residue at k
              sum += (k1_[i + n_ * j] + 2. * wave.k * k2_[i + n_ * j]) * shape[i];
            // steel = 1 + i loss multiplies the stiffness alone, not the mass
            wave.turn += steel * sum * shape[j];
          }
        all.push_back(std::move(wave));
      }
    return all;
  }


  std::vector<double>
  SectionWaves::frequencies(const double k, const unsigned int count) const
  {
    std::vector<double> squares;
    // of the whole section, to hold the basis against
    slow_motions(matrices_, k, count, &squares);
    for (double &value : squares)
      // omega^2 to Hz
      value = std::sqrt(std::max(value, 0.)) / (2 * M_PI);
    return squares;
  }


  Complex
  SectionWaves::response(const std::vector<Wave> &waves,
                         const unsigned int       a,
                         const unsigned int       b,
                         const double             z) const
  {
    // exp(-i k z), |factor| <= 1 for z >= 0
    std::vector<Complex> factors;
    for (const Wave &wave : waves)
      factors.push_back(std::exp(Complex(0, -z) * wave.k));
    return response(waves, a, b, factors);
  }


  /// 1/(2 pi) int f' D(k)^-1 f exp(-i k z) dk, closed below: -i times the sum of the residues.
  Complex
  SectionWaves::response(const std::vector<Wave>    &waves,
                         const unsigned int          a,
                         const unsigned int          b,
                         const std::vector<Complex> &factors) const
  {
    // f' D(k)^-1 f has simple poles at the wavenumbers of waves: a residue is (f' u)(u' f)/(u' D'(k) u)
    Complex sum = 0;
    for (std::size_t n = 0; n < waves.size(); ++n)
      // f_a' u u' f_b/(u' D'(k) u) exp(-i k z), z >= 0
      sum += waves[n].at[a] * waves[n].at[b] / waves[n].turn * factors[n];
    sum *= Complex(0, -1);
    // the elements have u_z = i w and exp(i k z): waves towards +z are those of -k, whose w has the other
    // sign, and a force along is i times that of the elements
    if (forces_[a].along != forces_[b].along)
      sum *= Complex(0, forces_[a].along ? -1 : 1);
    return sum;
  }
} // namespace wheelrail
