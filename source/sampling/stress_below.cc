#include <wheelrail/sampling/stress_below.h>

#include <cmath>
#include <cstddef>

namespace wheelrail
{
  StressBelow
  largest_stress_below(const std::vector<Slice> &slices, const double from)
  {
    StressBelow largest;
    for (const Slice &slice : slices)
      {
        if (slice.unloaded)
          continue;
        const std::size_t          n      = slice.depth.size();
        const std::vector<double> &stress = slice.values[slice_von_mises];
        for (std::size_t place = 0; place < slice.position.size(); ++place)
          for (std::size_t k = 0; k < n; ++k)
            {
              const double here = stress[place * n + k];
              if (k == 0 && here > largest.surface)
                largest.surface = here;
              if (slice.depth[k] < from * (1 - 1e-6) || !(here > largest.below))
                continue;
              largest.below = here;
              largest.depth = slice.depth[k];
              if (k == 0 || k + 1 == n || slice.depth[k - 1] < from * (1 - 1e-6))
                continue;
              const double above = stress[place * n + k - 1], deeper = stress[place * n + k + 1],
                           slope = 0.5 * (deeper - above), bend = above - 2 * here + deeper;
              if (bend < 0 && std::abs(slope) < -bend)
                largest.depth -= slope / bend * (slice.depth[k + 1] - slice.depth[k]);
            }
      }
    return largest;
  }


  void
  set_stress_below(const StressBelow &stress, Summary &summary)
  {
    set_figure(summary, "surface_von_mises_Pa", stress.surface);
    set_figure(summary, "von_mises_below_cell_Pa", stress.below);
    set_figure(summary, "von_mises_below_cell_depth_m", stress.depth);
  }
} // namespace wheelrail
