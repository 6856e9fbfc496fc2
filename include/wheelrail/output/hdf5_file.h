#pragma once

#include <wheelrail/output/fields.h>
#include <wheelrail/output/tick_file.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Writes a history as an HDF5 file: one dataset per column under its name, all of one length,
  /// each with the text attribute `unit`. The whole file is rewritten into a temporary file and
  /// renamed, so that a reader finds a complete table at any time. To be called on one rank.
  /// Throws RunError when names, units and columns differ in number or the columns in length, or
  /// when the file cannot be written (with its name and the reason).
  void
  write_history(const History &history, const std::string &path);

  /// Points of a patch between its nodes, on the line between stick and slip, where the shear traction is
  /// largest.
  struct SlipEdge
  {
    std::vector<double> along, lateral;                   ///< as those of PatchFields [m]
    std::vector<double> pressure;                         ///< [Pa]
    std::vector<double> traction_along, traction_lateral; ///< shear traction on the rail [Pa]
  };

  /// Adds a contact patch as the next tick of a file, with the attributes `n_along`, `n_lateral` and each
  /// field as a dataset of n_along x n_lateral numbers with the attribute `unit` (names as in
  /// PatchFields); points of the edge as datasets of their own, `edge_along` and the like. Throws RunError
  /// when a field has another length, or when the file cannot be written.
  void
  append_patch(TickFile &file, const PatchFields &patch, const SlipEdge &edge = {});
} // namespace wheelrail
