#include <wheelrail/application/study_command.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/commands/report_script.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/input/study_cases.h>
#include <wheelrail/output/figures.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include <unistd.h>

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
  } // namespace


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
} // namespace wheelrail
