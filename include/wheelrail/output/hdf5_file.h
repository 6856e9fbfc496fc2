#pragma once

#include <wheelrail/output/fields.h>
#include <wheelrail/output/tick_file.h>

#include <string>

namespace wheelrail
{
  /// Writes a history as an HDF5 file: one dataset per column under its name, all of one length,
  /// each with the text attribute `unit`. The whole file is rewritten into a temporary file and
  /// renamed, so that a reader finds a complete table at any time. To be called on one rank.
  /// Throws RunError when names, units and columns differ in number or the columns in length, or
  /// when the file cannot be written (with its name and the reason).
  void
  write_history(const History &history, const std::string &path);

  /// Reads a file of write_history() back; columns come in their original order. Throws RunError
  /// naming the file when it is missing or no such table.
  History
  read_history(const std::string &path);

  /// Adds a contact patch as the next tick of a file, with the attributes `n_along`, `n_lateral` and each
  /// field as a dataset of n_along x n_lateral numbers with the attribute `unit` (names as in
  /// PatchFields). Throws RunError when a field has another length, or when the file cannot be written.
  void
  append_patch(TickFile &file, const PatchFields &patch);

  /// Reads one tick of a file of append_patch() back; `tick` counts from 0. Throws RunError naming the
  /// file when it is missing or has no such tick.
  PatchFields
  read_patch(const std::string &path, unsigned int tick);
} // namespace wheelrail
