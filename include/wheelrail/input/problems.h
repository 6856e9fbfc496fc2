#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Where something was written.
  struct Place
  {
    std::string text;              ///< "prm/x.prm:12", or "--set" for the command line
    std::size_t order = last_line; ///< of the line among those of all files as they are read

    /// What belongs to no line of a file comes after all that does.
    static constexpr std::size_t last_line = static_cast<std::size_t>(-1);
  };

  /// One fault of the input.
  struct Problem
  {
    std::string text; ///< a whole sentence with file and line
    std::size_t order = Place::last_line;
  };

  /// Throws InputError when there are problems: one line each, in the order of the lines that they stand in,
  /// and at most as many as a screen holds. `name` is the file that was asked for.
  void
  require_no_problems(std::vector<Problem> problems, const std::string &name);
} // namespace wheelrail
