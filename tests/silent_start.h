#pragma once

// The static start of a scene's model, for tests that ask for its equilibrium alone.

#include <wheelrail/run/run_start.h>

#include <string>

namespace test
{
  /// What it would report is left out. Collective.
  inline wheelrail::StaticResult
  silent_start(const wheelrail::Scene &scene, wheelrail::Model &model)
  {
    return wheelrail::static_start(*model.discretization,
                                   model.solid,
                                   *model.contact,
                                   model.parts,
                                   wheelrail::static_loads(scene, model),
                                   [](const std::string &) {});
  }
} // namespace test
