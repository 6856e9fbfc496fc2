#pragma once

#include <wheelrail/commands/command_scene.h>

#include <ostream>

namespace wheelrail
{
  /// Carries out the command wear: wears the profiles of a scene (wear_on()) and writes into the folder of
  /// the scene, "-wear": wear.csv with a row a state, profiles/ with the profiles of each as tables that
  /// scenes take, wear.json from which an interrupted call resumes, and, with pictures, the page wear.html. A
  /// call for which everything is there draws the page alone; states of another scene are refused unless
  /// --overwrite. Collective where MPI has started several processes: they share the rows of the mix, the
  /// first one writes. Throws InputError, and RunError when a file cannot be written. Returns 0, or 2 where
  /// the profiles stopped to touch before the plan was done.
  int
  act_wear(const po::variables_map &options, const RunFunction &run, std::ostream &out);
} // namespace wheelrail
