#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Compares the run in `folder` (summary.json, parameters.prm, patch.h5) with the half-spaces under its
  /// load and in its pose: prints the table, writes compare.json, halfspace.h5, pictures and compare.html,
  /// and adds halfspace_... and relative_difference_... to summary.json. Pictures and page are
  /// left out unless `draws`. `sets` change entries, such as
  /// Half-space/Element size. Returns the exit code. Throws InputError, RunError.
  int
  run_compare_command(const std::string              &folder,
                      const std::vector<std::string> &sets,
                      bool                            draws,
                      std::ostream                   &out);
} // namespace wheelrail
