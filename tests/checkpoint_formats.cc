// label: fast

// Saved states of other formats: the rail of a finished run is read from the format before, which has the
// axle's numbers beside those of the run; a newer format is refused.

#include <wheelrail/base/errors.h>
#include <wheelrail/output/hdf5_handles.h>
#include <wheelrail/state/checkpoint.h>

#include "check.h"

#include <cstdint>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  Checkpoint
  small_state()
  {
    Checkpoint state;
    state.parameters                  = "set Title = x\n";
    state.fine_margin                 = 3e-3;
    state.node                        = {3, std::uint64_t(1) << 62 | 5};
    state.node_values["displacement"] = {3, {1, 2, 3, 4, 5, 6}};
    state.rolling.parts["axle"]       = {{{"travelled", 0.01}, {"angle", 0.02}}, {}, {}};
    state.rolling.parts["pads"]       = {{{"lift", 3}}, {7, 5}, {1, 2, 3, 4}};
    return state;
  }

  std::string
  bytes_of(const Checkpoint &state)
  {
    const std::vector<char> bytes = checkpoint_bytes(state);
    return {bytes.begin(), bytes.end()};
  }

  std::string
  changed(const std::string &bytes, void (*change)(hid_t))
  {
    const hdf5::Quiet  quiet;
    const hdf5::Handle file(hdf5::open_in_memory(bytes), H5Fclose, "open it");
    change(file);
    const std::vector<char> image = hdf5::file_image(file);
    return {image.begin(), image.end()};
  }

  void
  as_format_6(const hid_t file)
  {
    H5Adelete(file, "format");
    H5Adelete(file, "parts");
    H5Adelete(file, "part_axle");
    for (const char *keys : {"nodes", "cells"})
      H5Ldelete(file, keys, H5P_DEFAULT);
    hdf5::write_attribute(file, "nodes", 2.);
    hdf5::write_attribute(file, "cells", 0.);
    hdf5::write_attribute(file, "travelled", 0.01);
    hdf5::write_attribute(file, "angle", 0.02);
  }

  void
  as_format_99(const hid_t file)
  {
    H5Adelete(file, "format");
    hdf5::write_attribute(file, "format", 99.);
  }
} // namespace

int
main()
{
  const std::string bytes = bytes_of(small_state());
  const Checkpoint  now   = checkpoint_from_bytes(bytes);
  const PartState   pads  = now.rolling.parts.at("pads");
  check(now.travelled() == 0.01 && pads.numbers.at("lift") == 3, "numbers of the parts");
  check(pads.nodes == std::vector<std::uint64_t>{7, 5} && pads.values == std::vector<double>{1, 2, 3, 4},
        "values of nodes");
  check(now.has_keys && now.node == small_state().node, "keys of nodes");

  const Checkpoint former = checkpoint_from_bytes(changed(bytes, as_format_6));
  check(former.travelled() == 0.01 && former.rolling.parts.at("axle").numbers.at("angle") == 0.02,
        "format 6: the axle");
  check(!former.has_keys && former.rolling.parts.size() == 1 && former.fine_margin == 3e-3 &&
          former.node_values.at("displacement").values[5] == 6,
        "format 6: the rail");

  std::string error;
  try
    {
      checkpoint_from_bytes(changed(bytes, as_format_99));
    }
  catch (const RunError &refused)
    {
      error = refused.what();
    }
  check_text(error,
             "it is of format 99, this version of the program reads formats up to 11",
             "a newer format is refused");
  return report();
}
