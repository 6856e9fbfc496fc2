#include <wheelrail/base/errors.h>
#include <wheelrail/base/hints.h>
#include <wheelrail/commands/command_scene.h>
#include <wheelrail/input/cross_checks.h>
#include <wheelrail/input/former_drive.h>
#include <wheelrail/input/motion_file.h>
#include <wheelrail/input/without_effect.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace wheelrail
{
  std::vector<std::string>
  sets_of(const po::variables_map &options)
  {
    std::vector<std::string> sets;
    if (options.count("set"))
      sets = options["set"].as<std::vector<std::string>>();
    if (options.count("bodies"))
      {
        const std::string bodies = options["bodies"].as<std::string>();
        if (bodies != "real" && bodies != "half-spaces")
          throw InputError("--bodies " + bodies + ": half-spaces or real is accepted");
        sets.push_back("Half-space/Bodies = " + bodies);
      }
    return sets;
  }


  std::string
  file_of(const po::variables_map &options)
  {
    return options.count("file") ? options["file"].as<std::string>() : "";
  }


  SceneInput
  file_input_of(const po::variables_map &options)
  {
    const std::string file = file_of(options);
    return file.empty() ? scene_from_text("", "defaults", sets_of(options))
                        : read_scene(file, sets_of(options));
  }


  RowDrive
  row_drive_of(const po::variables_map &options)
  {
    return options.count("traction") ? row_drive(options["traction"].as<std::string>()) : RowDrive::none;
  }


  SceneInput
  input_of(const po::variables_map &options)
  {
    SceneInput input = file_input_of(options);
    if (options.count("row") && input.scene.motion != "none")
      throw InputError("--row and Wheelset/Motion: a scene has one row, or follows a motion; leave one out");
    if (options.count("traction") && !options.count("row"))
      throw InputError(
        "--traction says what drives a row: give --row, too, or set Wheelset/Traction coefficient");
    if (options.count("row") && (input.scene.both_wheels || options.count("wheelset")) &&
        read_vehicle_file(file_of_row(options["row"].as<std::string>())).find(MotionQuantity::load_right))
      throw InputError(
        "--row: the row has a load for each wheel, the scene one for both; write the column load in "
        "their place, and cant where the curve shares it");
    input.scene = options.count("row")
                    ? scene_of_row(input.scene, options["row"].as<std::string>(), row_drive_of(options))
                    : scene_at_start(input.scene);
    return input;
  }


  void
  settle_bodies(Scene &scene, const std::string &option, std::ostream &out)
  {
    if (scene.halfspace_bodies != ContactBodies::automatic)
      return;
    const std::vector<std::string> refused = refused_by_bodies(scene);
    if (option.empty() && refused.empty())
      return;
    scene.halfspace_bodies = ContactBodies::half_spaces;
    print_note("by half-spaces, " + (option.empty() ? refused.front() : option), out);
  }


  std::string
  drive_note(const po::variables_map &options, const SceneInput &input)
  {
    if (options.count("row"))
      return drive_of_rows(
        input.scene, read_vehicle_file(file_of_row(options["row"].as<std::string>())), row_drive_of(options));
    return former_drive_note(input);
  }


  std::vector<std::string>
  idle_entries(const po::variables_map &options, const SceneInput &input, const std::string &command)
  {
    std::vector<std::string> notes = entries_without_effect(input, command);
    if (options.count("row"))
      {
        const std::string file = file_of_row(options["row"].as<std::string>());
        if (const std::string note = entries_under_rows(input, read_vehicle_file(file), file); !note.empty())
          notes.push_back(note);
      }
    return notes;
  }


  void
  print_note(const std::string &note, std::ostream &out)
  {
    if (!note.empty())
      out << "note: " << note << "\n";
  }


  void
  print_notes(const std::vector<std::string> &notes, std::ostream &out)
  {
    for (const std::string &note : notes)
      print_note(note, out);
  }


  WheelsetProfiles
  profiles_with_notes(const Scene &scene, std::ostream &out)
  {
    WheelsetProfiles                profiles = read_wheelset_profiles(scene);
    const std::vector<std::string> &right    = profiles.right.notes;
    print_notes(right, out);
    if (scene.both_wheels)
      for (const std::string &note : profiles.left.notes)
        if (std::find(right.begin(), right.end(), note) == right.end())
          print_note(note, out);
    return profiles;
  }


  std::string
  roll_straight(const po::variables_map &options, Scene &scene)
  {
    if (scene.motion != "none" && read_motion_file(scene.motion).find(MotionQuantity::radius))
      return "the run rolls straight on, without the radius of " + scene.motion;
    if (!options.count("row") || !std::isfinite(scene.track_radius))
      return "";
    scene.track_radius = std::numeric_limits<double>::infinity();
    return "the run rolls straight on, without the radius of the row";
  }


  void
  require_file(const po::variables_map &options, const std::string &command, const std::string &example)
  {
    if (file_of(options).empty())
      throw InputError(command + " needs a parameter file, such as " + own_call() + " " + command + " " +
                       ready_scene(example));
  }


  void
  require_one_scene(const SceneInput &input)
  {
    if (!input.scene.study.axes.empty())
      throw InputError(input.name + ": a study, since Study/Axes is set; " + own_call() + " study " +
                       shell_word(input.name) + " computes its cases");
  }


  SceneInput
  one_scene_of(const po::variables_map &options)
  {
    SceneInput input = input_of(options);
    require_one_scene(input);
    return input;
  }


  void
  require_folder(const po::variables_map &options, const std::string &command)
  {
    const std::string folder = file_of(options);
    if (!std::filesystem::is_directory(folder))
      throw InputError(folder.empty()
                         ? command + " needs the output folder of a run, such as output/rolling"
                         : folder + ": no such folder; " + command + " needs the output folder of a run");
  }
} // namespace wheelrail
