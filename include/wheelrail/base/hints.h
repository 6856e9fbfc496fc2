#pragma once

#include <string>

namespace wheelrail
{
  /// How the user calls the program, for commands in messages, which shall work as they are read: as the
  /// launcher hands it on by the environment variable WHEELRAIL_COMMAND, else "./wheelrail".
  std::string
  own_call();

  /// A ready scene or table, such as "rolling.prm", as it is reached from where the command was given: in the
  /// folder of WHEELRAIL_SCENES, which the launcher sets, too, else in "prm".
  std::string
  ready_scene(const std::string &name);

  /// A word of a command as a shell takes it for one word: in quotes where it needs them.
  std::string
  shell_word(const std::string &word);
} // namespace wheelrail
