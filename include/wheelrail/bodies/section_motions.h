#pragma once

#include <wheelrail/bodies/wave_matrices.h>

#include <array>
#include <memory>
#include <vector>

namespace wheelrail
{
  /// Displacements of a section, one column a motion.
  using SectionColumns = std::vector<std::vector<double>>;

  /// y = (sum of factors x (K0, K1, K2, M)) x.
  std::vector<double>
  product(const WaveMatrices &of, const std::array<double, 4> &factor, const std::vector<double> &x);

  /// Solves with K(k) + shift M, which is positive for any shift above zero [rad2/s2].
  class ShiftedSection
  {
  public:
    ShiftedSection(const WaveMatrices &of, double k, double shift);
    ~ShiftedSection();

    std::vector<double>
    solve(std::vector<double> rhs);

  private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
  };

  /// The `count` slowest motions at a real wavenumber [1/m], by subspace iteration with (K(k) + shift M)^-1 M
  /// (Bathe 1971); `squares`: of their angular frequencies, ascending. Throws RunError where they cannot be
  /// distinguished.
  SectionColumns
  slow_motions(const WaveMatrices &of, double k, unsigned int count, std::vector<double> *squares = nullptr);

  /// Directions that columns have in common, orthonormal with M: those whose share of the sum of squares, in
  /// which each column counts the same, is above `least`.
  SectionColumns
  common_directions(const WaveMatrices &of, const SectionColumns &columns, double least);
} // namespace wheelrail
