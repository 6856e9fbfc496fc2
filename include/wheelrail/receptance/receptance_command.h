#pragma once

#include <wheelrail/commands/command_scene.h>

#include <ostream>

namespace wheelrail
{
  /// Carries out the command receptance: a hammer on the rail or the wheel of a scene by itself; receptance,
  /// mobility and accelerance, decay rate along the track and resonances. Writes receptance.csv and .h5,
  /// resonances.csv, of a rail waves.csv, summary.json, and a page where it draws, into the folder of the
  /// scene with -receptance. Throws InputError for a place where the rail cannot be struck. Returns 0.
  int
  act_receptance(const po::variables_map &options, const RunFunction &run, std::ostream &out);
} // namespace wheelrail
