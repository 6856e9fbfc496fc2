#pragma once

#include <cstddef>
#include <string>

namespace wheelrail
{
  /// Writes `size` bytes to `path` so that a reader sees either the old or the new file, never a
  /// half: the bytes go to a temporary file beside it (`path` + ".part"), which is synchronised
  /// and renamed. A failure (full disk, missing rights, missing folder) removes the temporary
  /// file, leaves the old file as it was, and throws RunError naming the file and the reason.
  /// To be called on one rank.
  void
  replace_file(const std::string &path, const void *bytes, std::size_t size);

  /// The same for text.
  void
  replace_file(const std::string &path, const std::string &text);

  /// Adds text at the end of a file, which is made where it is not there, by one call of write(). Throws
  /// RunError naming the file and the reason; a part of the text may then stand in it.
  void
  append_to_file(const std::string &path, const std::string &text);

  /// "The output file "x" cannot be written: reason. What to do.", for an error number of the system.
  std::string
  cannot_write(const std::string &path, int reason);
} // namespace wheelrail
