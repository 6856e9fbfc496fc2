#pragma once

#include <wheelrail/reference/halfspace_case.h>
#include <wheelrail/verdict/measures.h>

namespace wheelrail
{
  /// Adds to the measures of a run what pressures of half-spaces under its load and in its pose say of it:
  /// the difference of the peaks, the penetration over the approach, the turn of the surfaces, patches. The
  /// effect of the pose is left out.
  void
  measure_against(const HalfspacePressure &halfspace,
                  const Scene             &scene,
                  const Summary           &run,
                  Measures                &measures);

  /// The load of a finished run: means of its vertical and longitudinal force.
  WheelRailLoad
  load_of_run(const Summary &run);

  /// Rolls and offset that the run's summary records; zero where it has none.
  SectionOffsets
  offsets_of_run(const Summary &run);
} // namespace wheelrail
