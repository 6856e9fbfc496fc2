#include <wheelrail/halfspace/kernels.h>

#include <algorithm>

// Influence matrices as spectra, kept while grid and materials stay: each is computed when it is first asked
// for.

namespace wheelrail
{
  namespace
  {
    HalfspaceConstants
    constants_of(const HalfspaceProblem &problem)
    {
      // the layer takes part in the shear of each element on itself alone
      HalfspaceConstants constants = halfspace_constants(problem.body1, problem.body2);
      constants.layer              = problem.layer_compliance;
      return constants;
    }
  } // namespace


  HalfspaceKernels::HalfspaceKernels(const HalfspaceProblem &problem)
    : grid_(problem.grid)
    , constants_(constants_of(problem))
    , products_(problem.grid)
  {
  }


  bool
  HalfspaceKernels::fit(const HalfspaceProblem &problem) const
  {
    const HalfspaceGrid     &grid = problem.grid;
    const HalfspaceConstants now  = constants_of(problem);
    // A depends on distances alone: the place of the grid does not matter
    return grid.mx == grid_.mx && grid.my == grid_.my && grid.dx == grid_.dx && grid.dy == grid_.dy &&
           now.normal == constants_.normal && now.poisson == constants_.poisson &&
           now.coupling == constants_.coupling && now.layer == constants_.layer;
  }


  const HalfspaceKernels::Spectrum &
  HalfspaceKernels::of(const int a, const int b, const double ahead)
  {
    for (const Kept &kept : kept_)
      // exact comparison: steps and components repeat to the bit
      if (kept.a == a && kept.b == b && kept.ahead == ahead)
        return kept.spectrum;
    const auto by_distance = influence_by_distance(constants_, grid_, products_, ahead, {{a, b}});
    // closed integrals over all distances, then one FFT
    kept_.push_back({a, b, ahead, products_.kernel(by_distance.front())});
    return kept_.back().spectrum;
  }


  const SlipKernels &
  HalfspaceKernels::slip(const double step, const bool steady)
  {
    // B = A/dq or (A - A')/dq
    if (slip_.step != step || slip_.steady != steady)
      slip_ = slip_kernels(products_, constants_, grid_, step, steady);
    return slip_;
  }


  std::shared_ptr<HalfspaceKernels> &
  KeptKernels::of(const HalfspaceProblem &problem)
  {
    // a place that was asked for and not filled
    kept_.remove(nullptr);
    for (auto kernels = kept_.begin(); kernels != kept_.end(); ++kernels)
      if ((*kernels)->fit(problem))
        {
          // last used first
          kept_.splice(kept_.begin(), kept_, kernels);
          return kept_.front();
        }
    // a spectrum of the doubled grid has four numbers an element, and some nine spectra may be kept: grids
    // that were not used for longest leave first
    constexpr std::size_t most_grids    = 8;
    constexpr int         most_elements = 100000; // of all
    int                   elements      = problem.grid.size();
    std::size_t           grids         = 1;
    kept_.remove_if([&](const std::shared_ptr<HalfspaceKernels> &kernels) {
      elements += std::min(most_elements, kernels->elements());
      return ++grids > most_grids || elements > most_elements;
    });
    return kept_.emplace_front();
  }


  std::vector<std::vector<double>>
  displacements(HalfspaceKernels                                 &kernels,
                const std::vector<int>                           &components,
                const std::array<const std::vector<double> *, 3> &tractions)
  {
    // u_a = sum over b of A_ab t_b: three transforms of tractions, one back for each component
    // (doc/theory/halfspace.md, Equations)
    std::array<HalfspaceKernels::Spectrum, 3> spectra;
    for (int b = 0; b < 3; ++b)
      kernels.products().forward(*tractions[b], spectra[b]);
    std::vector<std::vector<double>> found(components.size());
    for (std::size_t k = 0; k < components.size(); ++k)
      {
        // sums of modes: one transform back for three tractions
        HalfspaceKernels::Spectrum sum(spectra[0].size(), 0.);
        for (int b = 0; b < 3; ++b)
          {
            const HalfspaceKernels::Spectrum &kernel = kernels.of(components[k], b, 0);
            for (std::size_t m = 0; m < sum.size(); ++m)
              // convolution as a product of modes
              sum[m] += times(kernel[m], spectra[b][m]);
          }
        kernels.products().backward(sum, found[k]);
      }
    return found;
  }
} // namespace wheelrail
