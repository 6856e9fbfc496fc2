#pragma once

#include <wheelrail/output/figure_table.h>
#include <wheelrail/reference/wear_evolution.h>

#include <optional>
#include <string>

namespace wheelrail
{
  /// All of a state as text, from which wear_on() goes on to the same bits. `digest` says of which scene
  /// (scene_digest()).
  std::string
  wear_state_as_text(const WearState &state, const std::string &digest);

  /// The state of a file, or nothing where there is none, it is no such text, or is of another scene.
  std::optional<WearState>
  read_wear_state(const std::string &path, const std::string &digest);

  /// The states so far, a row each, under names with their units [SI].
  FigureTable
  wear_table(const WearState &state);
} // namespace wheelrail
