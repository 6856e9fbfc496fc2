#include <wheelrail/application/command_actions.h>
#include <wheelrail/application/compare_command.h>
#include <wheelrail/application/geometry_command.h>
#include <wheelrail/application/geometry_picture.h>
#include <wheelrail/application/material_command.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/commands/command_scene.h>
#include <wheelrail/commands/report_script.h>
#include <wheelrail/contactfiles/contact_command.h>
#include <wheelrail/input/cross_checks.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/former_drive.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/input/study_cases.h>
#include <wheelrail/input/without_effect.h>
#include <wheelrail/model/coarser_cells.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/model.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/model/scene_motion.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/run/passage_list.h>
#include <wheelrail/run/run_texts.h>
#include <wheelrail/run/simulation.h>
#include <wheelrail/scene/one_wheel.h>
#include <wheelrail/sections/sections_command.h>
#include <wheelrail/vehicle/wheelset_command.h>

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    std::string
    chosen(const Scene &scene, const char *entry)
    {
      return find_entry("Study", entry)->get(scene);
    }

    Json
    axes_json(const Scene &scene, const std::vector<StudyCase> &cases)
    {
      Json axes = Json::array();
      for (std::size_t a = 0; a < scene.study.axes.size(); ++a)
        {
          Json values = Json::array();
          for (const StudyCase &one : cases)
            if (std::find(values.begin(), values.end(), one.values[a]) == values.end())
              values.push_back(one.values[a]);
          const StudyAxis &axis = scene.study.axes[a];
          axes.push_back({{"entry", axis.path()}, {"name", axis.name}, {"values", values}});
        }
      return axes;
    }

    /// What a study is to compute and where, as JSON for the scripts of source/study: version, title, folder,
    /// what is computed, the axes with their values, the cases with name, title and parameter file, and the
    /// table of figures. Throws InputError when the scene has no axes or study_faults().
    std::string
    study_plan(const SceneInput &input)
    {
      const Scene &scene = input.scene;
      if (scene.study.axes.empty())
        throw InputError(input.name +
                         ": no study, since Study/Axes is not set; write in subsection Study, for instance, "
                         "\"set Axes = Contact/Friction coefficient: 0.1, 0.2, 0.3\"");
      require_none(study_faults(scene), input);
      const std::vector<StudyCase> cases = study_cases(scene, WHEELRAIL_VERSION);
      Json                         list  = Json::array();
      for (const StudyCase &one : cases)
        list.push_back({{"name", one.name},
                        {"title", one.scene.title},
                        {"values", one.values},
                        {"parameters", print_parameters(one.scene)}});
      const Json plan = {{"program_version", WHEELRAIL_VERSION},
                         {"title", scene.title},
                         {"file", input.name},
                         {"folder", std::filesystem::path(scene.folder).lexically_normal().string()},
                         {"compute", chosen(scene, "Compute")},
                         {"combine", chosen(scene, "Combine")},
                         {"axes", axes_json(scene, cases)},
                         {"cases", list},
                         {"figures", Json::parse(figures_as_json())}};
      return plan.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
    }

    /// Computes a study: becomes the script source/study/study.py, which gets the plan and `options` (--jobs
    /// N, --ranks N, --dry-run, --profile NAME). Does not return; throws RunError when Python cannot be
    /// started.
    void
    run_study(const std::string &plan, const std::vector<std::string> &options)
    {
      // a file without a name, which the script inherits open
      std::FILE *const file = std::tmpfile();
      if (file == nullptr || std::fwrite(plan.data(), 1, plan.size(), file) != plan.size() ||
          std::fflush(file) != 0)
        throw RunError("The plan of the study cannot be written into the folder of temporary files, " +
                       std::filesystem::temp_directory_path().string() + ": make room there.");
      std::vector<std::string> words = {debian_python,
                                        shared_file("study/study.py"),
                                        "--program",
                                        std::filesystem::read_symlink("/proc/self/exe").string(),
                                        "--plan",
                                        "/dev/fd/" + std::to_string(::fileno(file))};
      words.insert(words.end(), options.begin(), options.end());
      std::vector<char *> pointers;
      for (std::string &word : words)
        pointers.push_back(word.data());
      pointers.push_back(nullptr);
      // in place of this process, so that a signal reaches the script, which lets those through that come now
      sigset_t signals;
      sigemptyset(&signals);
      for (const int signal : {SIGINT, SIGTERM})
        sigaddset(&signals, signal);
      sigprocmask(SIG_BLOCK, &signals, nullptr);
      leave_if_interrupted();
      ::execv(debian_python, pointers.data());
      throw RunError(
        "/usr/bin/python3 cannot be started; install the Debian packages python3, python3-h5py and "
        "python3-matplotlib");
    }

    /// The processes that the launcher would start a run on, which it tells by an environment variable; 0
    /// when it does not.
    unsigned int
    ranks_of_launcher()
    {
      const char *const told = std::getenv("WHEELRAIL_RANKS");
      return told ? static_cast<unsigned int>(std::strtoul(told, nullptr, 10)) : 0;
    }

    int
    validate(const po::variables_map &options, std::ostream &out)
    {
      SceneInput input = input_of(options);
      print_note(take_wheel(options, input), out);
      print_note(roll_straight(options, input.scene), out);
      const CheckedScene checked = check_scene(input.scene, this_machine(ranks_of_launcher()));
      const Findings    &found   = checked.found;
      require_none(found.errors, input);
      require_possible_folder(input.scene.folder);
      passing_wheels(input.scene, *checked.geometry); // throws where their list cannot be read
      print_note(drive_note(options, input), out);
      print_notes(checked.geometry->notes, out);
      for (const std::string &warning : found.warnings)
        out << "warning: " << warning << "\n";
      SceneInput given = input_of(options);
      given.scene.both_wheels |= options.count("wheelset") > 0;
      print_notes(idle_entries(options, given, "run"), out);
      const ExpectedPatch patch = expected_patch(input.scene, *checked.geometry);
      print_note(expected_accuracy(input.scene, patch), out);
      const StableStep limit = limit_of_step(input.scene, *checked.geometry);
      print_note("time step: " + time_step_text(run_duration(input.scene),
                                                input.scene.time_step_factor * limit.step,
                                                limit),
                 out);
      if (input.scene.error_estimate == ErrorEstimate::two_meshes)
        print_note(cost_of_coarser_cells(input.scene, patch), out);
      out << file_of(options) << ": all entries are valid"
          << (found.warnings.empty() ? "" : ", with the warnings above") << "\n";
      return 0;
    }

  } // namespace


  int
  act_run(const po::variables_map &options, const RunFunction &run, std::ostream &out)
  {
    if (options.count("ranks"))
      throw InputError("--ranks " + options["ranks"].as<std::string>() +
                       ": an option of the launcher, which starts the processes; the program itself is "
                       "started by mpirun -n with their number");
    require_file(options, "run");
    if (options.count("validate"))
      return validate(options, out);
    RunOptions run_options;
    run_options.overwrite = options.count("overwrite") > 0;
    run_options.resume    = options.count("resume") > 0;
    if (run_options.overwrite && run_options.resume)
      throw InputError("--overwrite starts anew and --resume continues: give one of them");
    SceneInput input = one_scene_of(options);
    input.scene.both_wheels |= options.count("wheelset") > 0;
    std::vector<std::string> notes    = idle_entries(options, input, "run");
    const std::string        wheelset = take_wheel(options, input);
    const std::string        curve    = roll_straight(options, input.scene);
    const SceneGeometry      geometry = require_computable(input);
    run_options.prm_text              = input.text;
    for (const std::string &set : sets_of(options))
      run_options.prm_text += "# --set \"" + set + "\"\n";
    if (options.count("row"))
      run_options.prm_text += "# --row " + options["row"].as<std::string>() +
                              (options.count("traction") ? " --traction from scene\n" : "\n");
    if (options.count("wheelset"))
      run_options.prm_text += "# --wheelset\n";
    notes.insert(notes.begin(), {wheelset.empty() ? drive_note(options, input) : wheelset, curve});
    for (const std::string &note : notes)
      run_options.note += (run_options.note.empty() || note.empty() ? "" : "; ") + note;
    run_options.parameters_text = print_parameters(input.scene);
    run_options.program_version = WHEELRAIL_VERSION;
    return run(input.scene, geometry, run_options);
  }


  int
  act_geometry(const po::variables_map &options, const RunFunction &, std::ostream &out)
  {
    std::vector<double> shifts;
    if (options.count("shifts"))
      shifts = parse_shifts(options["shifts"].as<std::string>());
    const SceneInput input = input_of(options);
    const Scene     &scene = input.scene;
    print_notes(idle_entries(options, input, "geometry"), out);
    if (options.count("places"))
      return print_touching_places(scene, options["places"].as<std::string>(), out);
    const bool unlike =
      scene.both_wheels && (scene.left_wheel_profile != "as right" || scene.left_rail_profile != "as right");
    const WheelsetProfiles sides =
      unlike ? profiles_with_notes(scene, out) : WheelsetProfiles{read_profiles(scene), {}};
    const SceneProfiles &profiles = sides.right;
    if (!unlike)
      print_notes(profiles.notes, out);
    const int code = run_geometry_command(scene, profiles, shifts, out, unlike ? &sides.left : nullptr);
    if (code == 0 && options.count("profiles"))
      {
        const std::string stem = std::filesystem::path(file_of(options)).stem().string();
        draw_profiles(
          scene, make_geometry(scene, profiles), (stem.empty() ? "" : stem + "_") + "profiles", out);
      }
    return code;
  }


  int
  act_material(const po::variables_map &options, const RunFunction &, std::ostream &out)
  {
    require_file(options, "material", "rolling_plastic.prm --set \"Material test/Axial = 0.01, -0.01\"");
    const SceneInput input = input_of(options);
    const Findings   found = contact_checks(input.scene);
    require_none(found.errors, input);
    for (const std::string &warning : found.warnings)
      out << "warning: " << warning << "\n";
    print_notes(entries_without_effect(input, "material"), out);
    return run_material_command(input.scene, !options.count("no-pictures"), out);
  }


  int
  act_contact(const po::variables_map &options, const RunFunction &, std::ostream &out)
  {
    if (file_of(options).empty())
      throw InputError("contact needs an input file of the program CONTACT, NAME.inp");
    const auto sets = sets_of(options); // of --bodies alone
    const int  code = run_contact_command({file_of(options),
                                          options.count("case") ? options["case"].as<int>() : 0,
                                           options.count("printed") > 0,
                                           !sets.empty() && options["bodies"].as<std::string>() == "real"},
                                         out);
    if (!options.count("no-pictures"))
      draw_results("contact_file.py", contact_folder(file_of(options)));
    return code;
  }


  int
  act_parameters(const po::variables_map &options, const RunFunction &, std::ostream &out)
  {
    if (options.count("validate"))
      {
        require_file(options, "parameters --validate");
        return validate(options, out);
      }
    if (options.count("markdown") + options.count("json") + options.count("xml") > 1)
      throw InputError("parameters prints in one style: give one of --json, --xml and --markdown");
    if (options.count("markdown") && !(file_of(options).empty() && sets_of(options).empty()))
      throw InputError("parameters --markdown prints the defaults of all entries: leave file and --set out");
    if (options.count("markdown"))
      {
        out << parameter_reference();
        return 0;
      }
    SceneInput input = input_of(options);
    if (options.count("ranks")) // one wheel of a wheelset needs as many as one by itself
      leave_wheelset(input.scene);
    const SceneGeometry geometry = require_computable(input);
    if (options.count("ranks"))
      {
        const double elements = expected_elements(input.scene, expected_patch(input.scene, geometry));
        out << useful_ranks(elements, options["ranks"].as<unsigned int>()) << "\n";
        return 0;
      }
    if (!options.count("json") && !options.count("xml")) // which have no remarks
      for (const std::string &note : entries_without_effect(input, "parameters"))
        out << "# note: " << note << "\n";
    out << print_parameters(input.scene,
                            options.count("json")  ? ParameterStyle::json
                            : options.count("xml") ? ParameterStyle::xml
                                                   : ParameterStyle::prm);
    return 0;
  }


  int
  act_compare(const po::variables_map &options, const RunFunction &, std::ostream &out)
  {
    require_folder(options, "compare");
    const bool bodies = !options.count("bodies") || options["bodies"].as<std::string>() == "real";
    return run_compare_command(
      file_of(options), sets_of(options), bodies, !options.count("no-pictures"), out);
  }


  int
  act_report(const po::variables_map &options, const RunFunction &, std::ostream &out)
  {
    require_folder(options, "report");
    out.flush();
    std::vector<std::string> words = {file_of(options)};
    if (options.count("tick"))
      words.insert(words.end(), {"--tick", options["tick"].as<std::string>()});
    for (const std::string name : {"csv", "each"})
      if (options.count(name))
        words.push_back("--" + name);
    return run_script("report.py", words);
  }


  int
  act_study(const po::variables_map &options, const RunFunction &, std::ostream &out)
  {
    require_file(options, "study", "studies/friction.prm");
    const SceneInput  input = file_input_of(options);
    const std::string plan  = study_plan(input);
    if (options.count("plan"))
      {
        out << plan;
        return 0;
      }
    require_possible_folder(input.scene.folder);
    print_notes(entries_without_effect(input, "study"), out);
    print_note(former_drive_note(input), out);
    out.flush();
    std::vector<std::string> words;
    for (const std::string name : {"jobs", "ranks", "profile"})
      if (options.count(name))
        words.push_back("--" + name + "=" + options[name].as<std::string>());
    for (const std::string name : {"dry-run", "no-pictures"})
      if (options.count(name))
        words.push_back("--" + name);
    run_study(plan, words);
    return 0;
  }
} // namespace wheelrail
