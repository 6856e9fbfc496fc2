#pragma once

#include <wheelrail/reference/wheelset_contact.h>
#include <wheelrail/scene/scene.h>

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
  run_wheelset_command(const Scene &scene, const WheelsetProfiles &profiles, bool draws, std::ostream &out);

  /// Solves the wheelset of a scene and returns that of its modelled wheel alone, to be run with finite
  /// elements, and a sentence on what it takes from the wheelset. Throws InputError where the wheel is
  /// lifted, or the balance was not found.
  struct WheelOfWheelset
  {
    Scene       scene;
    std::string note;
  };
  WheelOfWheelset
  take_from_wheelset(const Scene &scene, const WheelsetProfiles &profiles);
} // namespace wheelrail
