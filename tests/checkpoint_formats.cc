// label: fast

// A saved state is what was written; other formats, older and newer ones, are refused.

#include <wheelrail/base/errors.h>
#include <wheelrail/output/hdf5_handles.h>
#include <wheelrail/state/checkpoint.h>

#include "error_of.h"
#include "near.h"

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

  /// What is said of a file of another format; files before format 7 have no number.
  std::string
  refusal(const std::string &bytes, void (*change)(hid_t))
  {
    return test::error_of<RunError>([&]() { checkpoint_from_bytes(changed(bytes, change)); });
  }
} // namespace


BOOST_AUTO_TEST_CASE(checkpoint_formats)
{
  const std::string bytes = bytes_of(small_state());
  const Checkpoint  now   = checkpoint_from_bytes(bytes);
  const PartState   pads  = now.rolling.parts.at("pads");
  BOOST_TEST((now.travelled() == 0.01 && pads.numbers.at("lift") == 3), "numbers of the parts");
  BOOST_TEST(
    (pads.nodes == std::vector<std::uint64_t>{7, 5} && pads.values == std::vector<double>{1, 2, 3, 4}),
    "values of nodes");
  BOOST_TEST((now.node == small_state().node), "keys of nodes");

  BOOST_TEST(same_text(refusal(bytes, [](const hid_t file) { H5Adelete(file, "format"); }),
                       "it is of format 6, this version of the program reads format 11",
                       "an older format is refused"));
  BOOST_TEST(same_text(refusal(bytes,
                               [](const hid_t file) {
                                 H5Adelete(file, "format");
                                 hdf5::write_attribute(file, "format", 99.);
                               }),
                       "it is of format 99, this version of the program reads format 11",
                       "a newer format is refused"));
}
