#pragma once

#include <wheelrail/application/scene.h>

#include <ostream>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Solves the scene as two elastic half-spaces, prints the figures, and writes halfspace.h5 (one tick in
  /// the form of a run's patch.h5), summary.json, parameters.prm and pictures into
  /// "<Output/Folder>-halfspace". With a file name, also writes the input for the program CONTACT
  /// there. Returns the exit code. Throws InputError, RunError.
  int
  run_halfspace_command(const Scene &scene, const std::string &contact_input_file, std::ostream &out);

  /// Runs a script of source/report with Debian's Python and waits for it; returns its exit code.
  /// Throws RunError when Python cannot be started.
  int
  run_script(const std::string &script, const std::vector<std::string> &arguments);
} // namespace wheelrail
