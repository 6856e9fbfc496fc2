#pragma once

#include <wheelrail/verdict/interval.h>
#include <wheelrail/verdict/measures.h>
#include <wheelrail/wheel/halfspace_case.h>

namespace wheelrail
{
  /// What is known of the results of a run. Noise and trend of its series are two of their errors. What cells
  /// and penalty layer make of it is the difference to the true bodies, `against_bodies` from
  /// measure_against_bodies(); where these are no reference, of peak pressure and area an estimate, and of
  /// all else but forces that balances give nothing is known. Over irregular surfaces nothing is.
  Contributions
  run_contributions(const Scene         &scene,
                    const Summary       &run,
                    const Measures      &measures,
                    const NoiseEffect   &noise,
                    const Contributions &against_bodies);
} // namespace wheelrail
