#pragma once

#include <wheelrail/verdict/interval.h>
#include <wheelrail/verdict/measures.h>
#include <wheelrail/wheel/halfspace_case.h>

#include <string>

namespace wheelrail
{
  /// What cells make of a run, from the same on cells twice as large (scene_on_coarser_cells()), with `cells`
  /// over its patch: Richardson's extrapolation with the order p of a result, which lies the change over 2^p
  /// - 1 further on, within the change, the coarser run's noise, and a part of value/cells: 0.1 (second
  /// order), 0.5 (first), 0.45 and 0.9 (length and width), 2 (plastic strain, residual stress).
  Contributions
  two_mesh_contributions(const Scene &scene, const Summary &run, const Summary &coarser, double cells);

  /// What is known of the results of a run. Noise and trend of its series are two of their errors. What cells
  /// and penalty layer make of it is the difference to the true bodies, `against_bodies` from
  /// measure_against_bodies(). Where these are no reference, `two_meshes` are, if they are not empty; else
  /// peak pressure and area have an estimate, of steel that yields extents and creep, too, over irregular
  /// surfaces the largest force, and forces that balances give have noise and trend.
  Contributions
  run_contributions(const Scene         &scene,
                    const Summary       &run,
                    const Measures      &measures,
                    const NoiseEffect   &noise,
                    const Contributions &against_bodies,
                    const Contributions &two_meshes);

  /// How well the worse known of creepage and T-gamma is known, by the intervals in the summary, held against
  /// a quarter at least of what belongs to half of what friction carries; NaN: neither has an interval.
  Known
  known_creep_of_run(const Scene &scene, const Summary &run);

  /// Which results of a run have no interval, and why, in a sentence; empty where true bodies judge all.
  std::string
  without_intervals(const Scene         &scene,
                    const Measures      &measures,
                    const Contributions &against_bodies,
                    const Contributions &two_meshes);
} // namespace wheelrail
