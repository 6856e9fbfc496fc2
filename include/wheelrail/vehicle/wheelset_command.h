#pragma once

#include <wheelrail/commands/command_scene.h>
#include <wheelrail/vehicle/wheelset_contact.h>

#include <ostream>
#include <string>

namespace wheelrail
{
  /// Solves both wheels of the wheelset of a scene (solve_wheelset()) by its bodies, prints their figures
  /// side by side and those of the axle, and writes summary.json, parameters.prm, wheelset.csv (the lines of
  /// its picture) and the folders right and left, each as halfspace writes that of one wheel, into
  /// "<Output/Folder>-halfspace". The parameters.prm of these two compute the wheel alone in the pose and
  /// with the turning rate that were found. Pictures are left out unless `draws`. Returns the exit code.
  /// Throws InputError, RunError.
  int
  run_wheelset_command(const Scene &scene, bool draws, std::ostream &out);

  /// With --wheelset the scene becomes that of the modelled wheel of its wheelset alone, to be run with
  /// finite elements. Returns a note on what it takes from there, or nothing. Throws InputError where the
  /// wheel is lifted, or the balance was not found.
  std::string
  take_wheel(const po::variables_map &options, SceneInput &input);
} // namespace wheelrail
