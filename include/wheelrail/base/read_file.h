#pragma once

#include <string>

namespace wheelrail
{
  /// The whole file as a string; throws RunError naming the file and the reason, also when it is no ordinary
  /// file.
  std::string
  read_whole_file(const std::string &path);

  /// What is at `path` in place of an ordinary file, in words ("a folder", "a pipe", "a device", "a
  /// socket"); empty where there is an ordinary file, or nothing. Only ordinary files are read: a pipe may be
  /// waited for for ever, and a device may have no end.
  std::string
  other_than_a_file(const std::string &path);

  /// The text with '\n' at the end of every line. Files end their lines by LF, by CR LF (Windows) or by CR
  /// alone (old Macintosh programs and some measuring devices); read by lines of LF, the last kind would be
  /// one line only, and all of it a comment after its first mark.
  std::string
  with_line_feeds(const std::string &text);

  /// The path of a file that belongs to the program, such as "report/report.py". It is found from where the
  /// executable lies, so that build folder and installed program may be moved: in share/wheelrail beside the
  /// executable or beside its folder. Throws RunError, with the places looked at, when it is in neither.
  std::string
  shared_file(const std::string &name);
} // namespace wheelrail
