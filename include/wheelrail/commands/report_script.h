#pragma once

#include <string>
#include <vector>

namespace wheelrail
{
  /// Debian's own interpreter, which has the packages, also where another python3 comes first in the path. As
  /// the first word of its command it must be whole: by the name alone Python looks for itself in the path,
  /// and in a virtual environment takes that one's packages.
  inline constexpr const char *debian_python = "/usr/bin/python3";

  /// Runs one of the scripts that draw pictures and pages, such as "report.py", with Debian's Python and
  /// waits for it; returns its exit code. Throws RunError when Python cannot be started or the script is
  /// missing.
  int
  run_script(const std::string &script, const std::vector<std::string> &arguments);

  /// Lets a script draw what a command has written into a folder, its last step. Throws RunError when the
  /// script fails, so that the command does not end as if all were there.
  void
  draw_results(const std::string &script, const std::string &folder);
} // namespace wheelrail
