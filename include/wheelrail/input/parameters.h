#pragma once

#include <wheelrail/scene/scene.h>

#include <map>
#include <string>
#include <vector>

namespace wheelrail
{
  /// A scene as read, and where its entries were set.
  struct SceneInput
  {
    Scene                              scene;
    std::string                        name;   ///< of the file, for messages
    std::map<std::string, std::string> origin; ///< "prm/x.prm:12" or "--set", by "Section/Name"
  };

  /// The scene of an input text with the changes of --set on top, entries not given at their
  /// defaults. `name` is the file name for messages.
  ///
  /// Throws InputError whose text has one line for each fault found, in the order of the file:
  /// "prm/x.prm:12: Wheelset/Velocity = 140: a bare number; a velocity with its unit is needed,
  /// such as 140 km/h". Every entry is then right by itself; whether they fit together tell cross_checks()
  /// and scene_checks().
  SceneInput
  scene_from_text(const std::string &text, const std::string &name, const std::vector<std::string> &sets);

  /// The same for a file; throws InputError also when it cannot be read.
  SceneInput
  read_scene(const std::string &prm_path, const std::vector<std::string> &sets);

  /// Throws InputError with all `errors` of a scene, if any, each after the place where the entry was set
  /// that it begins with.
  void
  require_none(const std::vector<std::string> &errors, const SceneInput &input);

  /// All entries with the values of `scene`, as a parameter file that read_scene() accepts, each
  /// with its meaning, what is accepted, and its default.
  std::string
  print_parameters(const Scene &scene);
} // namespace wheelrail
