#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace wheelrail
{
  struct RunOptions;
  struct Scene;
  struct SceneGeometry;

  /// The command line after the program's name.
  using Arguments = std::vector<std::string>;

  /// Runs a simulation; a parameter so that tests of the command line need none.
  using RunFunction = std::function<int(const Scene &, const SceneGeometry &, const RunOptions &)>;

  /// Whether these arguments start a simulation and so need MPI; `run --validate` and `run --help`
  /// do not.
  bool
  needs_mpi(const Arguments &arguments);

  /// Carries out a command line and returns the exit code. Normal text goes to `out`.
  /// Throws InputError for a command line or a parameter file that cannot be understood.
  int
  execute(const Arguments &arguments, const RunFunction &run, std::ostream &out);
} // namespace wheelrail
