#pragma once

#include <wheelrail/application/commands.h>

#include <ostream>
#include <string>
#include <vector>

namespace wheelrail
{
  /// The command line after the program's name.
  using Arguments = std::vector<std::string>;

  /// Whether these arguments start what several processes share, and so need MPI: `run`, and `wear` where a
  /// launcher of MPI (Open MPI, PMIx, PMI) has started this process; with `--validate` or `--help` neither.
  bool
  needs_mpi(const Arguments &arguments);

  /// Carries out a command line and returns the exit code. Normal text goes to `out`.
  /// Throws InputError for a command line or a parameter file that cannot be understood.
  int
  execute(const Arguments &arguments, const RunFunction &run, std::ostream &out);
} // namespace wheelrail
