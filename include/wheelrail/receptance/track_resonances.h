#pragma once

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>

namespace wheelrail
{
  /// What the spectra of a run over irregular surfaces are read by [Hz].
  struct TrackResonances
  {
    /// A wave of the unsupported rail is twice as long as a bay; NaN without sleepers.
    double pinned_pinned;
    /// Wheel and rail swing against each other on the spring of their contact: where a height of the surfaces
    /// makes the largest force, 1/|a_rail + a_wheel + a_contact| with receptances a, between 200 Hz and 3
    /// kHz (Thompson 2009, section 5.2). The rail midway between two sleepers, by the waves of its section;
    /// the wheel as a rigid mass; the spring as Hertz has it under the wheel load.
    double contact;
  };

  /// `unsprung_mass`: of wheel and half axle [kg]; `wheel_load` [N].
  TrackResonances
  track_resonances(const Scene         &scene,
                   const SceneGeometry &geometry,
                   double               unsprung_mass,
                   double               wheel_load);
} // namespace wheelrail
