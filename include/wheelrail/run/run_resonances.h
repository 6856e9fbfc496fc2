#pragma once

#include <wheelrail/model/model.h>
#include <wheelrail/output/summary.h>

namespace wheelrail
{
  /// Adds the pinned-pinned frequency and the contact resonance of the track to the figures of a run. Of the
  /// room receptance; a build without track adds nothing.
  void
  add_resonances(const Scene &scene, const SceneGeometry &geometry, const Model &model, Summary &summary);
} // namespace wheelrail
