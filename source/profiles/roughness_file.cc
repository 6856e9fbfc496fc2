#include <wheelrail/base/errors.h>
#include <wheelrail/profiles/named_columns.h>
#include <wheelrail/profiles/profile_text.h>
#include <wheelrail/profiles/roughness_file.h>

#include <cmath>

namespace wheelrail
{
  std::vector<RoughnessBand>
  read_roughness_file(const std::string &path)
  {
    constexpr double  highest = 60; // 1 mm root mean square
    const std::string accepted =
      "; a line with the names wavelength_mm, level_dB is needed, then a row for each one-third-octave band";
    const NamedTable table = read_named_columns(
      path, {{"wavelength", length_units(), true}, {"level", {{"_dB", 1.}}, true}}, accepted);
    std::vector<RoughnessBand> bands;
    for (const NamedRow &row : table.rows)
      {
        if (!(row.value[0] > 0))
          throw InputError(place(path, row.line) + "a wavelength must be positive");
        if (std::abs(row.value[1]) > highest)
          throw InputError(place(path, row.line) +
                           "a level beyond 60 dB; levels are 20 lg of the root mean square height over 1 um");
        bands.push_back({row.value[0], row.value[1]});
      }
    if (bands.empty())
      throw InputError(path + ": no band" + accepted);
    return bands;
  }
} // namespace wheelrail
