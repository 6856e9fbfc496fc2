#pragma once

#include <string>
#include <vector>

namespace wheelrail
{
  /// Runs one of the scripts that draw pictures and pages, such as "report.py", with Debian's Python and
  /// waits for it; returns its exit code. Throws RunError when Python cannot be started or the script is
  /// missing.
  int
  run_script(const std::string &script, const std::vector<std::string> &arguments);
} // namespace wheelrail
