#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/output/descriptions.h>
#include <wheelrail/output/hdf5_handles.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/tick_file.h>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace wheelrail
{
  using namespace hdf5;

  namespace
  {
    unsigned int
    count_ticks(const hid_t file)
    {
      unsigned int n = 0;
      while (H5Lexists(file, tick_name(n).c_str(), H5P_DEFAULT) > 0)
        ++n;
      return n;
    }
  } // namespace

  std::string
  tick_name(const unsigned int tick)
  {
    return text("tick_%04u", tick);
  }

  TickFile::TickFile(std::string path, const bool resume, const unsigned int keep_ticks)
    : path_(std::move(path))
    , file_(H5I_INVALID_HID)
  {
    const Quiet quiet;
    const bool  there = resume && std::filesystem::exists(path_);
    file_             = open_in_memory(there ? read_whole_file(path_) : "");
    if (file_ < 0)
      throw RunError("The HDF5 file \"" + path_ + "\": HDF5 cannot " +
                     (there ? "read it: it is no complete HDF5 file; start anew without --resume."
                            : "make a file in memory."));
    if (!there)
      describe_root(file_);
    const unsigned int found = count_ticks(file_);
    n_ticks_                 = std::min(found, keep_ticks);
    for (unsigned int tick = n_ticks_; tick < found; ++tick)
      H5Ldelete(file_, tick_name(tick).c_str(), H5P_DEFAULT);
  }

  TickFile::~TickFile()
  {
    const Quiet quiet;
    if (file_ >= 0)
      H5Fclose(file_);
  }

  void
  TickFile::append(const double                             time,
                   const double                             rolled_distance,
                   const std::function<void(std::int64_t)> &fill)
  {
    const Quiet       quiet;
    const std::string name = tick_name(n_ticks_);
    std::vector<char> bytes;
    try
      {
        const Handle group(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                           H5Gclose,
                           "make the group " + name);
        write_attribute(group, "time_s", time);
        write_attribute(group, "rolled_distance_m", rolled_distance);
        fill(group);
        bytes = file_image(file_);
      }
    catch (const RunError &error)
      {
        throw RunError("The HDF5 file \"" + path_ + "\": " + error.what());
      }
    ++n_ticks_;
    replace_file(path_, bytes.data(), bytes.size());
  }
} // namespace wheelrail
