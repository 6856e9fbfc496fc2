#pragma once

#include <wheelrail/model/expected_patch.h>
#include <wheelrail/scene/scene.h>

#include <string>

namespace wheelrail
{
  /// Whether a run on larger cells can come first: a rail that was rolled over has cells of one size.
  bool
  takes_coarser_cells(const Scene &scene);

  /// The run of Run/Error estimate = two meshes that comes first: the same scene on cells twice as large,
  /// beside its folder ("-coarse"). Elastic bodies on smooth surfaces roll until steady, all others their
  /// path.
  Scene
  scene_on_coarser_cells(const Scene &scene);

  /// What that run costs, about, in words: by its elements; start and coarse cells often leave it as many
  /// steps.
  std::string
  cost_of_coarser_cells(const Scene &scene, const ExpectedPatch &patch);
} // namespace wheelrail
