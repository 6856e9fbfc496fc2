#pragma once

#include <wheelrail/halfspace/influence.h>
#include <wheelrail/halfspace/slip_kernels.h>

#include <array>
#include <list>
#include <memory>
#include <vector>

namespace wheelrail
{
  /// The influence functions of two half-spaces on one grid, as spectra: what takes longest of a solution,
  /// and stays the same for all loads, creepages and frictions. Each is computed when it is first asked for.
  /// Not for several threads at once.
  class HalfspaceKernels
  {
  public:
    using Spectrum = InfluenceProducts::Spectrum;

    /// For grid, bodies and layer of a problem.
    explicit HalfspaceKernels(const HalfspaceProblem &problem);

    /// Whether they are those of a problem, too: elements of the same number and size, wherever they lie.
    bool
    fit(const HalfspaceProblem &problem) const;

    int
    elements() const
    {
      return grid_.size();
    }
    const HalfspaceConstants &
    constants() const
    {
      return constants_;
    }
    InfluenceProducts &
    products()
    {
      return products_;
    }

    /// Of the displacement a under traction b (0, 1, 2 = x, y, n), seen `ahead` further along rolling [m].
    const Spectrum &
    of(int a, int b, double ahead);

    /// Of the slip, see slip_kernels(); valid until the next call.
    const SlipKernels &
    slip(double step, bool steady);

  private:
    struct Kept
    {
      int      a, b;
      double   ahead;
      Spectrum spectrum;
    };

    HalfspaceGrid      grid_;
    HalfspaceConstants constants_;
    InfluenceProducts  products_;
    std::list<Kept>    kept_; // references to them stay valid
    SlipKernels        slip_;
  };

  /// Those of the problems solved last, whose grids change by some elements and come back.
  class KeptKernels
  {
  public:
    /// Where those of a problem are, or may be made: null then.
    std::shared_ptr<HalfspaceKernels> &
    of(const HalfspaceProblem &problem);

  private:
    std::list<std::shared_ptr<HalfspaceKernels>> kept_; ///< last used first
  };

  /// Displacement differences of some components (0, 1, 2 = x, y, n), body 1 less body 2, under tractions (x,
  /// y, n) on body 1, for each element [m].
  std::vector<std::vector<double>>
  displacements(HalfspaceKernels                                 &kernels,
                const std::vector<int>                           &components,
                const std::array<const std::vector<double> *, 3> &tractions);

  /// solve_rolling() with the influence functions of an earlier solution where they fit; else they are made
  /// anew, and kept in `kernels` (which may be null). `guess`: a solution to begin with, taken where its grid
  /// has as many elements; what comes of it is the same to the tolerances of the problem.
  HalfspaceSolution
  solve_rolling(const HalfspaceProblem            &problem,
                std::shared_ptr<HalfspaceKernels> &kernels,
                const HalfspaceSolution           *guess = nullptr);
} // namespace wheelrail
