#include <wheelrail/profiles/roughness_file.h>
#include <wheelrail/tables/table.h>

namespace wheelrail
{
  std::vector<RoughnessBand>
  read_roughness_file(const std::string &path, std::vector<std::string> &notes)
  {
    const Table table = read_table(
      path,
      {{"wavelength", Dimension::length, 1e-9, 1e3, "a length above 0, up to 1 km,", true},
       {"level", Dimension::level, -60, 60, "-60 dB to 60 dB over a root mean square height of 1 um", true}},
      {"roughness is a row for each one-third-octave band under the names wavelength_mm, level_dB",
       true,
       {},
       "#%!",
       ""});
    notes.insert(notes.end(), table.notes.begin(), table.notes.end());
    std::vector<RoughnessBand> bands;
    for (std::size_t row = 0; row < table.lines.size(); ++row)
      bands.push_back({(*table.find(0))[row], (*table.find(1))[row]});
    return bands;
  }
} // namespace wheelrail
