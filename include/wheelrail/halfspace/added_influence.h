#pragma once

#include <wheelrail/halfspace/problem.h>

#include <array>
#include <complex>
#include <memory>
#include <vector>

namespace wheelrail
{
  /// What one body deflects beyond a half-space, as influences between a few rows of its surface that run
  /// along x: smooth, so that rows of 2 mm serve elements of any size. Fixed axes (X, Y, Z) of the caller's
  /// choice.
  struct RowInfluence
  {
    int rows = 0;
    /// Of each row in a value at each row of elements: my x rows, weights of a smooth interpolation.
    std::vector<double> weights;
    /// Displacements (X, Y, Z) of row i under forces (X, Y, Z) on row j that stand the lag z behind it,
    /// for the lags asked for: value at lag * (3 rows)^2 + 3 rows (3 i + a) + 3 j + b [m/N].
    std::vector<double> by_lag;
  };

  /// Displacement differences that come to those of two half-spaces, because the bodies are not half-spaces.
  /// That of the normal displacement under pressure is symmetric.
  class AddedInfluence
  {
  public:
    virtual ~AddedInfluence() = default;

    using Fields = std::array<std::vector<double> *, 3>;
    using Given  = std::array<const std::vector<double> *, 3>;

    /// Adds displacements (x, y, n) under tractions (x, y, n) on body 1; null pointers leave components out.
    virtual void
    add_displacement(const Given &traction, const Fields &displacement) const = 0;

    /// Adds the slip in steady rolling, (u - u ahead) / step.
    virtual void
    add_slip(const Given &traction, const Fields &slip) const = 0;
  };

  /// That of bodies by a few rows of their surface: forces of the elements are gathered on the rows, the
  /// rows' influences act by FFT along x, and what comes of it is interpolated to the elements again.
  /// Symmetric, as influences of elastic bodies are. Modes along x that hold less than 1e-6 of the largest
  /// one are left out: smooth influences have some twenty.
  class RowsInfluence : public AddedInfluence
  {
  public:
    /// Directions x, y, n of the contact frame at a row of elements in the fixed axes: value at 3 * axis +
    /// direction.
    using Basis = std::array<double, 9>;

    /// Lags at which the influences are needed, for the displacement seen `ahead` further along x [m].
    static std::vector<double>
    lags(const HalfspaceGrid &grid, double ahead);

    RowsInfluence(const HalfspaceGrid &grid, std::vector<Basis> bases);
    ~RowsInfluence() override;

    /// Other directions of the rows, for surfaces that turn under the load.
    void
    set_bases(const std::vector<Basis> &bases);

    /// Adds a body with its influences at lags(grid, 0) and at lags(grid, step), see slip().
    void
    add_body(const RowInfluence &here, const RowInfluence &ahead, double step);

    void
    add_displacement(const Given &traction, const Fields &displacement) const override;
    void
    add_slip(const Given &traction, const Fields &slip) const override;

    /// Displacement of one body along the fixed axes under the tractions, for each element [m].
    std::array<std::vector<double>, 3>
    fixed_displacement(unsigned int body, const Given &traction) const;

  private:
    struct Body;
    struct Plans;

    /// Fills the free lags of the padded row.
    void
    close_gap();

    /// Sums of element forces on the rows of a body, as spectra along x.
    std::vector<std::complex<double>>
    row_forces(const Body &body, const Given &traction) const;

    /// Displacements of the rows along x, of a kernel.
    std::vector<double>
    row_displacements(const Body                              &body,
                      const std::vector<std::complex<double>> &kernel,
                      const std::vector<std::complex<double>> &forces) const;

    void
    add(bool slip, const Given &traction, const Fields &result) const;

    HalfspaceGrid          grid_;
    std::vector<Basis>     bases_;
    int                    length_ = 0, modes_ = 0; ///< of the padded rows, of their spectra
    std::vector<Body>      bodies_;
    std::unique_ptr<Plans> plans_;
  };
} // namespace wheelrail
