#pragma once

#include <wheelrail/state/checkpoint.h>

#include <string>

namespace wheelrail
{
  /// Why a run with the entries `parameters` (and the scene they give) cannot go on from a saved state, a
  /// sentence that names every entry with what it is, what it was, and what to do; empty when it can.
  std::string
  obstacle_to_resume(const Checkpoint &saved, const Scene &scene, const std::string &parameters);

  /// In which entries that results depend on two lists of entries differ, "path = now, saved with ...", with
  /// semicolons between; empty when in none. `of_run`: those that steps of a run depend on alone.
  std::string
  other_entries(const std::string &saved, const std::string &now, bool of_run = true);

  /// In which entries of the rail's material two lists of entries differ, a sentence; empty when in none.
  std::string
  other_steel(const std::string &before, const std::string &now);
} // namespace wheelrail
