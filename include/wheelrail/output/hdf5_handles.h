#pragma once

#include <hdf5.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace hdf5
  {
    /// An HDF5 identifier that closes itself; throws RunError with `what` when it is not valid.
    class Handle
    {
    public:
      Handle(hid_t id, herr_t (*close)(hid_t), const std::string &what);
      ~Handle();
      Handle(Handle &&other) noexcept
        : id_(std::exchange(other.id_, H5I_INVALID_HID))
        , close_(other.close_)
      {
      }
      Handle(const Handle &) = delete;
      Handle &
      operator=(const Handle &) = delete;

      operator hid_t() const
      {
        return id_;
      }

    private:
      hid_t id_;
      herr_t (*close_)(hid_t);
    };

    /// Throws RunError when an HDF5 call returned an error.
    void
    require(herr_t status, const std::string &what);

    /// While it lives, HDF5 prints no error stack of its own.
    class Quiet
    {
    public:
      Quiet();
      ~Quiet();
      Quiet(const Quiet &) = delete;
      Quiet &
      operator=(const Quiet &) = delete;

    private:
      H5E_auto2_t function_;
      void       *data_;
    };

    /// A file that lives in memory only; `image` are the bytes of a file to start from, or none.
    hid_t
    open_in_memory(const std::string &image = "");

    /// The bytes of a file in memory, as they belong on the disk.
    std::vector<char>
    file_image(hid_t file);

    /// At most some 64 000 characters, a limit of HDF5; longer texts: write_text().
    void
    write_attribute(hid_t object, const std::string &name, const std::string &value);

    void
    write_attribute(hid_t object, const std::string &name, double value);

    void
    write_attribute(hid_t object, const std::string &name, unsigned int value);

    bool
    has_attribute(hid_t object, const std::string &name);

    std::string
    read_text_attribute(hid_t object, const std::string &name);

    double
    read_number_attribute(hid_t object, const std::string &name);

    /// A dataset of doubles of the given shape with the attribute `unit` and, where one is given,
    /// `description`.
    void
    write_dataset(hid_t                       group,
                  const std::string          &name,
                  const std::vector<hsize_t> &shape,
                  const std::vector<double>  &values,
                  const std::string          &unit,
                  const std::string          &description = "");

    /// Whole numbers that say what the rows of other datasets belong to.
    void
    write_keys(hid_t group, const std::string &name, const std::vector<std::uint64_t> &keys);

    std::vector<std::uint64_t>
    read_keys(hid_t group, const std::string &name);

    /// A text of any length as a dataset of bytes.
    void
    write_text(hid_t group, const std::string &name, const std::string &text);

    std::string
    read_text(hid_t group, const std::string &name);

    /// All numbers of a dataset, in the order of the file.
    std::vector<double>
    read_dataset(hid_t group, const std::string &name);
  } // namespace hdf5
} // namespace wheelrail
