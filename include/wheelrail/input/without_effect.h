#pragma once

#include <wheelrail/input/motion_file.h>
#include <wheelrail/input/parameters.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Entries that were set without effect: those of --set that a command ("geometry", "halfspace", "vehicle",
  /// "wear", "receptance", "material", "compare", "run"; "parameters" reads all) does not read, in one
  /// sentence, since a file serves all commands; and those that another entry leaves without effect, wherever
  /// they were set to something else than their default, each in one. What is named has no effect on any
  /// result; what is not named may still have none. Of a "study", whose axes count as --set, those of all
  /// cases.
  std::vector<std::string>
  entries_without_effect(const SceneInput &input, const std::string &command);

  /// Entries that were set and that columns of the rows of a file replace, in one sentence; empty: none.
  std::string
  entries_under_rows(const SceneInput &input, const MotionFile &rows, const std::string &file);
} // namespace wheelrail
