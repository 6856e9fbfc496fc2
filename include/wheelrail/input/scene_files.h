#pragma once

#include <wheelrail/scene/scene.h>

#include <functional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Where a scene names a file.
  using PathPlace = std::function<std::string &(Scene &)>;

  /// A file that a scene names.
  struct SceneFile
  {
    std::string entry; ///< "Wheelset/Motion"
    std::string path;
    std::string what;   ///< "motion": what its copy beside the results is called by
    PathPlace   value;  ///< where the scene names it; null where that is not by this path alone
    bool        in_run; ///< every step of a run depends on it
  };

  /// All files that a scene depends on by its entries, in the order of the entries: profiles, motion,
  /// distance, material test, lists of wheels or scenes, the rail of an earlier run (its rail.h5). What a
  /// listed scene names follows behind it, its includes are in contents_of(). Files need not be there.
  std::vector<SceneFile>
  files_of(const Scene &scene);

  /// What the figures depend on of such a file: its bytes, or of a scene all its entries, so that includes
  /// count and remarks do not. Empty where it cannot be read, which the reader of it reports.
  std::string
  contents_of(const SceneFile &file);

  /// Eight letters and digits for all that the figures of a scene depend on: version of the program, entries
  /// but title, output folder, study and saving, and the files that they name.
  std::string
  scene_digest(const Scene &scene, const std::string &program_version);
} // namespace wheelrail
