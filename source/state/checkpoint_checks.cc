#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/input/flat_input.h>
#include <wheelrail/state/checkpoint_checks.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace wheelrail
{
  namespace
  {
    std::map<std::string, std::string>
    entries_of(const std::string &parameters)
    {
      std::map<std::string, std::string> values;
      for (const Assignment &a : flatten_input(parameters, "").assignments)
        values[a.path()] = a.value;
      return values;
    }

    /// Outputs, limits and lengths that no step depends on.
    bool
    may_differ(const std::string &path)
    {
      static const std::vector<std::string> single = split_list(
        "Title, Run/Energy limit, Run/Averaging distance, Run/Evaluate at, Run/Rolling distance, Run/Longest "
        "distance, Run/Standard error, Run/Wanted accuracy, Run/Error estimate, Run/Passages, Run/Passage "
        "list, Run/Most passages, Run/Settled growth, Run/Settled change, Run/Rail, Mesh/Prepared distance");
      for (const char *section : {"Output/", "Half-space/", "Material test/"})
        if (path.rfind(section, 0) == 0)
          return true;
      return std::find(single.begin(), single.end(), path) != single.end();
    }

    bool
    of_result(const std::string &path)
    {
      return path != "Title" && path.rfind("Output/", 0) != 0 && path.rfind("Study/", 0) != 0;
    }

    std::string
    shown(const std::string &value)
    {
      return value.empty() ? "(not there)" : value;
    }
  } // namespace


  std::string
  other_steel(const std::string &before, const std::string &now)
  {
    auto        old = entries_of(before);
    std::string differences;
    for (const auto &[path, value] : entries_of(now))
      if (path.rfind("Rail material/", 0) == 0 && old[path] != value)
        differences +=
          (differences.empty() ? "" : "; ") + path + " = " + value + ", there " + shown(old[path]);
    return differences;
  }


  std::string
  other_entries(const std::string &saved, const std::string &now, const bool of_run)
  {
    auto        before = entries_of(saved), after = entries_of(now);
    std::string differences;
    for (const auto &table : {before, after})
      for (const auto &[path, value] : table)
        if (before[path] != after[path] && (of_run ? !may_differ(path) : of_result(path)))
          {
            differences += (differences.empty() ? "" : "; ") + path + " = " + shown(after[path]) +
                           ", saved with " + shown(before[path]);
            before[path] = after[path]; // reported once
          }
    return differences;
  }


  std::string
  obstacle_to_resume(const Checkpoint &saved, const Scene &scene, const std::string &parameters)
  {
    const std::string differences = other_entries(saved.parameters, parameters);
    if (!differences.empty())
      return "entries differ from those of the saved state, which must not change: " + differences +
             "; set them back, or start anew in another Output/Folder";

    const double      rolled = saved.travelled();
    const std::string wanted = path_text(scene);
    if (scene.motion != "none" && scene.path() > saved.prepared_distance * (1 + 1e-12))
      return wanted + ": fine cells and motion of the saved state were laid for " +
             rounded_mm(saved.prepared_distance) + "; give at most that, or start anew";
    if (scene.path() > saved.longest_distance * (1 + 1e-12))
      return scene.window == MeshWindow::moving && !scene.rail_by_slices()
               ? wanted + ": on the rail of the saved state the wheel can roll " +
                   rounded_mm(std::floor(1e3 * saved.longest_distance) / 1e3) +
                   "; give at most that, or start anew with it or with a longer Track/Rail length"
               : wanted + ": the mesh of the saved state was made for " +
                   rounded_mm(saved.prepared_distance) +
                   " of rolling; give at most that, or start anew with " +
                   (scene.rail_by_slices()
                      ? "it"
                      : "Mesh/Prepared distance = " + rounded_mm(scene.path()) + " or Mesh/Window = moving");
    if (scene.path() <= rolled)
      return wanted + ": the saved state has rolled " + rounded_mm(rolled) +
             "; give more than that, and at most " +
             rounded_mm(std::floor(1e3 * saved.longest_distance) / 1e3);
    return "";
  }
} // namespace wheelrail
