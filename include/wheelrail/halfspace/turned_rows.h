#pragma once

#include <wheelrail/halfspace/added_influence.h>
#include <wheelrail/halfspace/kernels.h>

#include <array>
#include <memory>
#include <vector>

namespace wheelrail
{
  /// Conformal contact, where the normal turns from row to row: each element displaces the others as
  /// half-spaces do along the arc, in its own directions, and these displacements are turned into the
  /// directions of each (Vollebregt and Segal 2014, with displacements transformed). Pressure so shifts
  /// surfaces against each other, of like materials, too. Not for several threads at once.
  class TurnedRows : public AddedInfluence
  {
  public:
    /// For grid, bodies, layer and step of a problem; the angle of each row, from y towards n [rad].
    TurnedRows(const HalfspaceProblem &problem, const std::vector<double> &angles);

    void
    add_displacement(const Given &traction, const Fields &displacement) const override;
    void
    add_slip(const Given &traction, const Fields &slip) const override;

  private:
    using Spectrum = HalfspaceKernels::Spectrum;
    /// Of the displacements y and n under each traction; empty: none.
    using Spectra = std::array<std::array<Spectrum, 3>, 2>;

    void
    add(const Spectra &spectra, const Given &traction, const Fields &result) const;

    HalfspaceGrid            grid_;
    mutable HalfspaceKernels kernels_;
    std::vector<double>      cosine_, sine_; ///< of each row
    Spectra                  here_, slip_;
  };

  /// solve_rolling() of a problem on rows so turned, at most so many times in turns of pressure and
  /// tractions, until pressures change by less than the tolerance of the coupling.
  HalfspaceSolution
  solve_turned(HalfspaceProblem                   problem,
               const std::vector<double>         &angles,
               int                                rounds,
               std::shared_ptr<HalfspaceKernels> &kernels,
               const HalfspaceSolution           *guess = nullptr);
} // namespace wheelrail
