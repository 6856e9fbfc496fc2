#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace wheelrail
{
  struct RunOptions;
  struct Scene;
  struct SceneGeometry;

  /// Runs a simulation; a parameter so that tests of the command line need none.
  using RunFunction = std::function<int(const Scene &, const SceneGeometry &, const RunOptions &)>;

  /// A subcommand: its options besides the positional file, and what it does.
  struct Command
  {
    std::string name;
    std::string operand; ///< "FILE.prm", in brackets when it may be left out; or nothing
    std::string summary;
    std::function<void(boost::program_options::options_description &)> add_options;
    /// Returns the exit code; normal text goes to the stream. Throws InputError for what cannot be
    /// understood.
    std::function<int(const boost::program_options::variables_map &, const RunFunction &, std::ostream &)>
      act;
  };

  /// All of them, in the order of the help text.
  const std::vector<Command> &
  commands();
} // namespace wheelrail
