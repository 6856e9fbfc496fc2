#pragma once

#include <wheelrail/geometry/roughness.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Reads a table of one-third-octave levels: columns wavelength (_m, _mm, _um) and level_dB (over 1 um root
  /// mean square), a row for each band. Columns left out are named in `notes`. Throws InputError that names
  /// file and line.
  std::vector<RoughnessBand>
  read_roughness_file(const std::string &path, std::vector<std::string> &notes);
} // namespace wheelrail
