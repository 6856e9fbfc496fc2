#pragma once

#include <wheelrail/commands/scene_row.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>

#include <boost/program_options.hpp>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace wheelrail
{
  // What commands make of their options: the scene, and notes on it. All throw InputError for what cannot be
  // asked for.

  namespace po = boost::program_options;

  struct RunOptions;

  /// Runs a simulation; a parameter so that tests of the command line need none.
  using RunFunction = std::function<int(const Scene &, const SceneGeometry &, const RunOptions &)>;

  /// The texts of all --set options.
  std::vector<std::string>
  sets_of(const po::variables_map &options);

  /// The file or folder that the command is given; empty: none.
  std::string
  file_of(const po::variables_map &options);

  /// The file with the --set options; without a file the defaults.
  SceneInput
  file_input_of(const po::variables_map &options);

  /// What drives rows without a column for it.
  RowDrive
  row_drive_of(const po::variables_map &options);

  /// The same at the row of --row, or where it starts to follow its motion.
  SceneInput
  input_of(const po::variables_map &options);

  /// Half-space/Bodies = auto of a scene or an option for what true bodies do not have becomes
  /// half-spaces, and why is printed. `option`: "--creep-curve: ...", or nothing.
  void
  settle_bodies(Scene &scene, const std::string &option, std::ostream &out);

  /// The note on the drive of a scene that does not say it; empty when it does.
  std::string
  drive_note(const po::variables_map &options, const SceneInput &input);

  /// entries_without_effect() and those that the row of --row replaces.
  std::vector<std::string>
  idle_entries(const po::variables_map &options, const SceneInput &input, const std::string &command);

  /// Prints "note: ...", or nothing when there is none.
  void
  print_note(const std::string &note, std::ostream &out);

  /// Prints several of them, a line each.
  void
  print_notes(const std::vector<std::string> &notes, std::ostream &out);

  /// The profiles of both sides; prints what was found in their files, and of a file that both sides have
  /// once.
  WheelsetProfiles
  profiles_with_notes(const Scene &scene, std::ostream &out);

  /// The scene that a run computes of --row: straight on. Returns a note on a curve that is left out, or
  /// nothing.
  std::string
  roll_straight(const po::variables_map &options, Scene &scene);

  /// Throws InputError where the command got no file. `example`: a ready scene, with what else makes a whole
  /// command of it.
  void
  require_file(const po::variables_map &options,
               const std::string       &command,
               const std::string       &example = "rolling.prm");

  /// Throws InputError for a study.
  void
  require_one_scene(const SceneInput &input);

  /// The one scene of a file; throws InputError for a study.
  SceneInput
  one_scene_of(const po::variables_map &options);

  /// Throws InputError where the command got no folder of a run.
  void
  require_folder(const po::variables_map &options, const std::string &command);
} // namespace wheelrail
