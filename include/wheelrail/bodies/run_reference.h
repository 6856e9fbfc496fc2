#pragma once

#include <wheelrail/verdict/measures.h>
#include <wheelrail/wheel/halfspace_case.h>

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

  /// Whether a run holds a creepage, in one place on smooth surfaces, so that its longitudinal force is to be
  /// judged.
  bool
  force_is_a_result(const Scene &scene);

  /// Adds how far the peak pressure of a run is from that of the true bodies under its forces, or under its
  /// vertical force with its creepage where this is given, and then the longitudinal force, too. What cells
  /// and penalty layer make of all results, with what the elements of the bodies leave open; nothing where
  /// these have no answer: where steel has flowed, the wheel moves or the surfaces are irregular.
  Contributions
  measure_against_bodies(const Scene         &scene,
                         const SceneGeometry &geometry,
                         const Summary       &run,
                         Measures            &measures);

  /// The load of a finished run: means of its vertical and longitudinal force.
  WheelRailLoad
  load_of_run(const Summary &run);

  /// Rolls and offset that the run's summary records; zero where it has none.
  SectionOffsets
  offsets_of_run(const Summary &run);
} // namespace wheelrail
