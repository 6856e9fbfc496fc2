#pragma once

#include <wheelrail/bodies/section_motions.h>

#include <complex>
#include <utility>
#include <vector>

namespace wheelrail
{
  /// Forces on a section that act together: of 1 N in all where they are spread evenly. The displacement that
  /// belongs to them is the mean with the same shares.
  struct SectionForce
  {
    std::vector<std::pair<int, double>> shares;        ///< on displacements of WaveMatrices [1]
    bool                                along = false; ///< along the body; else in the plane of the section
  };

  /// Waves that travel along a rail, or die along it, at a frequency: 2.5-D finite elements with mass (Gavric
  /// 1995; Nilsson, Jones, Thompson and Ryue 2009), K(k)(1 + i loss) - w^2 M with the time factor exp(i w t).
  ///
  /// Waves in both directions are mirror images, so that k^2 is the eigenvalue: with u = (x, y, k w) the
  /// equations are linear in it. They are solved in a basis that holds the slowest motions of the section at
  /// several wavenumbers and how it deflects under the forces.
  class SectionWaves
  {
  public:
    /// A wave u exp(-i k z) with Im k < 0, which dies towards +z.
    struct Wave
    {
      std::complex<double>              k;  ///< [1/m]
      std::vector<std::complex<double>> at; ///< its displacement at each of the forces
      /// u' dD/dk u, of which the response to the forces follows (see response()).
      std::complex<double> turn;
    };

    SectionWaves(const WaveMatrices &matrices, const std::vector<SectionForce> &forces);

    /// Of the angular frequency w [rad/s]; Im w < 0 is what a response has that is faded by exp(Im w t).
    /// Below some 5 Hz the wave along a rail without springs, k^2 = w^2 rho / E, drowns in the rounding of
    /// the eigenvalues. `springs`: for each force the stiffness for each metre of the body of springs that
    /// act as it does [N/m2]; empty: none.
    std::vector<Wave>
    waves(std::complex<double> w, double loss, const std::vector<std::complex<double>> &springs = {}) const;

    /// Frequencies of the first `count` waves of real wavenumber k, without loss and springs, by all elements
    /// of the section, ascending [Hz].
    std::vector<double>
    frequencies(double k, unsigned int count) const;

    /// The displacement at force a, at the distance z >= 0 towards +Z from force b of 1 N, spread over a
    /// point of the body [m/N]: the sum of the residues. Forces along the body turn the sign of what is not
    /// along when z is counted backwards; those of different kinds differ by a factor of i, which is in
    /// it.
    std::complex<double>
    response(const std::vector<Wave> &waves, unsigned int a, unsigned int b, double z) const;

    /// The same, with a factor for each wave in place of exp(-i k z), such as means over a stretch.
    std::complex<double>
    response(const std::vector<Wave>                 &waves,
             unsigned int                             a,
             unsigned int                             b,
             const std::vector<std::complex<double>> &factors) const;

    /// Numbers of displacements of the section, and of the basis.
    std::size_t
    size() const
    {
      return matrices_.size();
    }
    std::size_t
    basis() const
    {
      return n_;
    }

  private:
    /// Its eigenvalues are the squares of the wavenumbers: -B^-1 A with the plane part of the stiffness, mass
    /// and springs in A; `steel`: 1 + i loss.
    std::vector<std::complex<double>>
    eigenmatrix(std::complex<double>                     w,
                std::complex<double>                     steel,
                const std::vector<std::complex<double>> &springs) const;
    void
    reduce(const SectionColumns &basis, std::size_t n_plane);

    WaveMatrices              matrices_;
    std::vector<SectionForce> forces_;
    std::size_t               n_ = 0, n_plane_ = 0; ///< of the basis; of those in the plane, which come first
    std::vector<double>       k0_, m_, b_;          ///< n x n, column after column; b_ inverted
    std::vector<double>       k1_;                  ///< K1 between along (rows) and plane
    std::vector<double>       k2_;
    SectionColumns            at_; ///< of each force: on the basis
  };
} // namespace wheelrail
