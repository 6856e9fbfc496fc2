#pragma once

#include <wheelrail/input/parameters.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// What a study is to compute and where, as JSON for the scripts of source/study: version, title, folder,
  /// what is computed, the axes with their values, the cases with name, title and parameter file, and the
  /// table of figures. Throws InputError when the scene has no axes or study_faults().
  std::string
  study_plan(const SceneInput &input);

  /// Computes a study: becomes the script source/study/study.py, which gets the plan and `options` (--jobs N,
  /// --ranks N, --dry-run, --profile NAME). Does not return; throws RunError when Python cannot be started.
  void
  run_study(const std::string &plan, const std::vector<std::string> &options);
} // namespace wheelrail
