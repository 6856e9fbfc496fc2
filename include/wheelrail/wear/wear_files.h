#pragma once

#include <wheelrail/output/figure_table.h>
#include <wheelrail/wear/wear_evolution.h>

#include <optional>
#include <string>

namespace wheelrail
{
  /// All of a state as text, from which wear_on() resumes with the same bits. `digest` says of which scene
  /// (scene_digest()).
  std::string
  wear_state_as_text(const WearState &state, const std::string &digest);

  /// What a file holds.
  struct KeptWear
  {
    std::string digest; ///< of its scene
    WearState   state;
  };

  /// The state of a file, or nothing where there is none. Throws InputError where it is no such text.
  std::optional<KeptWear>
  read_wear_state(const std::string &path);

  /// The states so far, a row each, under names with their units [SI].
  FigureTable
  wear_table(const WearState &state);
} // namespace wheelrail
