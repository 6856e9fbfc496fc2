#pragma once

#include <cstdint>
#include <string>

namespace wheelrail
{
  /// What a dataset of patch.h5, slices.h5, history.h5 or patch_history.h5 holds, with its sign: the
  /// attribute `description`. Figures of the summary are described by their label and remark, energies by
  /// their term.
  std::string
  description_of(const std::string &name);

  /// Writes what holds for a whole HDF5 file as attributes of its root: `program` with the version, `format`
  /// (which grows when datasets change their meaning), `axes`, `signs`.
  void
  describe_root(std::int64_t file);
} // namespace wheelrail
