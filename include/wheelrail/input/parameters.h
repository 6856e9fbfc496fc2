#pragma once

#include <wheelrail/input/problems.h>
#include <wheelrail/scene/scene.h>

#include <map>
#include <string>
#include <vector>

namespace wheelrail
{
  /// A scene as read, and what it was read from.
  struct SceneInput
  {
    Scene                        scene;
    std::string                  name;   ///< of the file, for messages
    std::string                  text;   ///< the file with what it includes written out, without --set
    std::map<std::string, Place> origin; ///< where each entry that is set was set, by "Section/Name"
  };

  /// The scene of an input text (flatten_input()) with the changes of --set on top, entries not given at
  /// their defaults. `name` is the file for messages; one that ends with .json or .xml says how to read.
  ///
  /// All lines, names and values are checked. Throws InputError whose text has one line for each fault found,
  /// in the order of the lines, those of included files at the place of the include: "prm/x.prm:12:
  /// Wheelset/Velocity = 140: a bare number; a velocity with its unit is needed, such as 140 km/h". Every
  /// entry is then right by itself; whether they fit together say cross_checks() and check_scene().
  SceneInput
  scene_from_text(const std::string &text, const std::string &name, const std::vector<std::string> &sets);

  /// The same for a file; throws InputError also when it cannot be read.
  SceneInput
  read_scene(const std::string &prm_path, const std::vector<std::string> &sets);

  /// A sentence that begins with an entry, or with the file that an entry names, after the place where a file
  /// sets that entry; as it is where none does.
  std::string
  with_place(const std::string &sentence, const SceneInput &input);

  /// Throws InputError with all `errors` of a scene, if any, each after the place where the entry was set
  /// that it begins with.
  void
  require_none(const std::vector<std::string> &errors, const SceneInput &input);
} // namespace wheelrail
