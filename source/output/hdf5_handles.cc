#include <wheelrail/base/errors.h>
#include <wheelrail/output/hdf5_handles.h>

#include <atomic>
#include <cstring>
#include <functional>
#include <numeric>

namespace wheelrail
{
  namespace hdf5
  {
    Handle::Handle(const hid_t id, herr_t (*close)(hid_t), const std::string &what)
      : id_(id)
      , close_(close)
    {
      if (id_ < 0)
        throw RunError("HDF5 cannot " + what + ".");
    }

    Handle::~Handle()
    {
      if (id_ >= 0)
        close_(id_);
    }

    void
    require(const herr_t status, const std::string &what)
    {
      if (status < 0)
        throw RunError("HDF5 cannot " + what + ".");
    }

    Quiet::Quiet()
    {
      H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
      H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }

    Quiet::~Quiet()
    {
      H5Eset_auto2(H5E_DEFAULT, function_, data_);
    }

    hid_t
    open_in_memory(const std::string &image)
    {
      const Handle          access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "prepare a file in memory");
      constexpr std::size_t growth = 1 << 20; // bytes at a time: about one tick of a patch
      require(H5Pset_fapl_core(access, growth, false), "prepare a file in memory");

      // HDF5 refuses to open two files of one name, also when neither is on the disk
      static std::atomic<unsigned long> counter{0};
      const std::string                 name = "wheelrail-" + std::to_string(counter++);
      if (image.empty())
        return H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);

      std::string copy(image); // the library asks for a pointer to non-const and copies the bytes
      require(H5Pset_file_image(access, &copy[0], copy.size()), "take over the bytes of a file");
      return H5Fopen(name.c_str(), H5F_ACC_RDWR, access);
    }

    std::vector<char>
    file_image(const hid_t file)
    {
      require(H5Fflush(file, H5F_SCOPE_GLOBAL), "complete a file in memory");
      const ssize_t size = H5Fget_file_image(file, nullptr, 0);
      require(size < 0 ? -1 : 0, "give the bytes of a file in memory");
      std::vector<char> bytes(static_cast<std::size_t>(size));
      require(H5Fget_file_image(file, bytes.data(), bytes.size()) < 0 ? -1 : 0,
              "give the bytes of a file in memory");
      return bytes;
    }

    namespace
    {
      void
      write_scalar_attribute(const hid_t object, const std::string &name, const hid_t type, const void *value)
      {
        const std::string what = "write the attribute " + name;
        const Handle      space(H5Screate(H5S_SCALAR), H5Sclose, what);
        const Handle      attribute(
          H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, what);
        require(H5Awrite(attribute, type, value), what);
      }
    } // namespace

    void
    write_attribute(const hid_t object, const std::string &name, const std::string &value)
    {
      const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "write text");
      require(H5Tset_size(type, value.size() + 1), "write text");
      require(H5Tset_cset(type, H5T_CSET_UTF8), "write text");
      write_scalar_attribute(object, name, type, value.c_str());
    }

    void
    write_attribute(const hid_t object, const std::string &name, const double value)
    {
      write_scalar_attribute(object, name, H5T_NATIVE_DOUBLE, &value);
    }

    void
    write_attribute(const hid_t object, const std::string &name, const unsigned int value)
    {
      write_scalar_attribute(object, name, H5T_NATIVE_UINT, &value);
    }

    bool
    has_attribute(const hid_t object, const std::string &name)
    {
      return H5Aexists(object, name.c_str()) > 0;
    }


    std::string
    read_text_attribute(const hid_t object, const std::string &name)
    {
      const std::string what = "read the attribute " + name;
      const Handle      attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, what);
      const Handle      type(H5Aget_type(attribute), H5Tclose, what);
      if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0)
        throw RunError("HDF5 cannot " + what + ": it is no text of fixed length.");
      std::vector<char> text(H5Tget_size(type) + 1, '\0');
      require(H5Aread(attribute, type, text.data()), what);
      return text.data();
    }

    double
    read_number_attribute(const hid_t object, const std::string &name)
    {
      const std::string what = "read the attribute " + name;
      const Handle      attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, what);
      double            value = 0;
      require(H5Aread(attribute, H5T_NATIVE_DOUBLE, &value), what);
      return value;
    }

    namespace
    {
      /// Makes a dataset of `shape` and fills it; `doing` says in messages what is done with it.
      Handle
      write_all(const hid_t                 group,
                const std::string          &name,
                const std::vector<hsize_t> &shape,
                const void                 *values,
                const hid_t                 stored,
                const hid_t                 native,
                const std::string          &doing)
      {
        const std::string what = doing + name;
        const Handle      space(
          H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, what);
        Handle set(H5Dcreate2(group, name.c_str(), stored, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                   H5Dclose,
                   what);
        if (H5Sget_simple_extent_npoints(space) > 0)
          require(H5Dwrite(set, native, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), what);
        return set;
      }

      template <typename T>
      std::vector<T>
      read_all(const hid_t group, const std::string &name, const hid_t native, const std::string &doing)
      {
        const std::string what = doing + name;
        const Handle      set(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, what);
        const Handle      space(H5Dget_space(set), H5Sclose, what);
        std::vector<T>    values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
        if (!values.empty())
          require(H5Dread(set, native, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), what);
        return values;
      }
    } // namespace

    void
    write_dataset(const hid_t                 group,
                  const std::string          &name,
                  const std::vector<hsize_t> &shape,
                  const std::vector<double>  &values,
                  const std::string          &unit,
                  const std::string          &description)
    {
      const hsize_t expected =
        std::accumulate(shape.begin(), shape.end(), hsize_t(1), std::multiplies<hsize_t>());
      if (values.size() != expected)
        throw RunError("The field " + name + " has " + std::to_string(values.size()) + " values where " +
                       std::to_string(expected) + " belong.");

      const Handle set =
        write_all(group, name, shape, values.data(), H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, "write the dataset ");
      write_attribute(set, "unit", unit);
      if (!description.empty())
        write_attribute(set, "description", description);
    }

    void
    write_text(const hid_t group, const std::string &name, const std::string &text)
    {
      write_all(group, name, {text.size()}, text.data(), H5T_STD_U8LE, H5T_NATIVE_UCHAR, "write the text ");
    }

    std::string
    read_text(const hid_t group, const std::string &name)
    {
      const auto bytes = read_all<char>(group, name, H5T_NATIVE_UCHAR, "read the text ");
      return {bytes.begin(), bytes.end()};
    }

    void
    write_keys(const hid_t group, const std::string &name, const std::vector<std::uint64_t> &keys)
    {
      write_all(
        group, name, {keys.size()}, keys.data(), H5T_STD_U64LE, H5T_NATIVE_UINT64, "write the dataset ");
    }

    std::vector<std::uint64_t>
    read_keys(const hid_t group, const std::string &name)
    {
      return read_all<std::uint64_t>(group, name, H5T_NATIVE_UINT64, "read the dataset ");
    }

    std::vector<double>
    read_dataset(const hid_t group, const std::string &name)
    {
      return read_all<double>(group, name, H5T_NATIVE_DOUBLE, "read the dataset ");
    }
  } // namespace hdf5
} // namespace wheelrail
