#pragma once

#include <wheelrail/geometry/profiles.h>
#include <wheelrail/scene/scene.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Whether a value that may be a name of the program's own (of a standard profile, say) means a file: it
  /// has a dot or a slash, which no such name has.
  bool
  is_file_name(const std::string &name);

  /// The rail and the wheel of a scene, standard ones or read from files (measured_profiles.h). What was
  /// found and done is added to `notes`, if given. Throws InputError that names the entry.
  RailProfile
  scene_rail(const Scene &scene, std::vector<std::string> *notes = nullptr);
  WheelProfile
  scene_wheel(const Scene &scene, std::vector<std::string> *notes = nullptr);

  /// Notes on both, each with the name of the file; none for standard profiles.
  std::vector<std::string>
  profile_notes(const Scene &scene);
} // namespace wheelrail
