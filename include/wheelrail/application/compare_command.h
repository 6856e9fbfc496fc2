#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Compares the run in `folder` (summary.json, parameters.prm, patch.h5) with the half-spaces under its
  /// load and in its pose: prints the table, writes compare.json, halfspace.h5, pictures and compare.html,
  /// and adds halfspace_... and relative_difference_... to summary.json. Pictures and page are
  /// left out unless `draws`. With `bodies` besides with the contact of its own wheel and rail as elastic
  /// bodies (solve_bodies()), as a second table and as bodies_... in summary.json. `sets` change entries,
  /// such as Half-space/Element size. Returns the exit code. Throws InputError, RunError.
  int
  run_compare_command(const std::string              &folder,
                      const std::vector<std::string> &sets,
                      bool                            bodies,
                      bool                            draws,
                      std::ostream                   &out);
} // namespace wheelrail
