#pragma once

#include <wheelrail/commands/command_scene.h>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace wheelrail
{
  /// A subcommand: its options besides the positional file, and what it does.
  struct Command
  {
    std::string name;
    std::string operand; ///< "FILE.prm", in brackets when it may be left out; or nothing
    std::string summary;
    std::function<void(po::options_description &)> add_options;
    /// Returns the exit code; normal text goes to the stream. Throws InputError for what cannot be
    /// understood.
    std::function<int(const po::variables_map &, const RunFunction &, std::ostream &)> act;
  };

  /// All of them, in the order of the help text.
  const std::vector<Command> &
  commands();
} // namespace wheelrail
