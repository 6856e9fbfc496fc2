#pragma once

#include <wheelrail/scene/scene.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// How far the input is checked.
  enum class Checks
  {
    all,    ///< the scene can be computed
    entries ///< every entry is right by itself, which is enough for the rigid profiles
  };

  /// The scene of an input text with the changes of --set on top, entries not given at their
  /// defaults. `name` is the file name for messages.
  ///
  /// Throws InputError whose text has one line for each fault found, in the order of the file:
  /// "prm/x.prm:12: Wheelset/Velocity = 140: a bare number; a velocity with its unit is needed,
  /// such as 140 km/h". The cross-checks are made when every single entry is right.
  Scene
  scene_from_text(const std::string              &text,
                  const std::string              &name,
                  const std::vector<std::string> &sets,
                  Checks                          checks = Checks::all);

  /// The same for a file; throws InputError also when it cannot be read.
  Scene
  read_scene(const std::string &prm_path, const std::vector<std::string> &sets, Checks checks = Checks::all);

  /// All entries with the values of `scene`, as a parameter file that read_scene() accepts, each
  /// with its meaning, what is accepted, and its default.
  std::string
  print_parameters(const Scene &scene);
} // namespace wheelrail
