#pragma once

// What the program has written, read back: tables of histories, patches of one output step.

#include <wheelrail/base/read_file.h>
#include <wheelrail/output/fields.h>
#include <wheelrail/output/hdf5_handles.h>
#include <wheelrail/output/tick_file.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test
{
  namespace hdf5 = wheelrail::hdf5;

  inline hdf5::Handle
  open_file(const std::string &path)
  {
    return {hdf5::open_in_memory(wheelrail::read_whole_file(path)), H5Fclose, "read " + path};
  }

  /// A file of write_history(), columns in the order in which they were written.
  inline wheelrail::History
  read_history(const std::string &path)
  {
    const hdf5::Quiet             quiet;
    const hdf5::Handle            file = open_file(path);
    std::map<double, std::string> names; // by the number of the column
    const auto                    collect = [](hid_t group, const char *name, const H5L_info_t *, void *all) {
      const hdf5::Handle set(H5Dopen2(group, name, H5P_DEFAULT), H5Dclose, "read a column");
      (*static_cast<std::map<double, std::string> *>(all))[hdf5::read_number_attribute(set, "column")] = name;
      return herr_t(0);
    };
    hdf5::require(H5Literate(file, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, collect, &names), "list columns");
    wheelrail::History history;
    for (const auto &[column, name] : names)
      {
        const hdf5::Handle set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "read a column");
        history.names.push_back(name);
        history.units.push_back(hdf5::read_text_attribute(set, "unit"));
        history.columns.push_back(hdf5::read_dataset(file, name));
      }
    return history;
  }

  /// One output step, counted from 0, of a file of append_patch().
  inline wheelrail::PatchFields
  read_patch(const std::string &path, const unsigned int tick)
  {
    using namespace hdf5;
    const Quiet  quiet;
    const Handle file = open_file(path);
    const Handle group(
      H5Gopen2(file, wheelrail::tick_name(tick).c_str(), H5P_DEFAULT), H5Gclose, "find the group");
    wheelrail::PatchFields patch;
    patch.time            = read_number_attribute(group, "time_s");
    patch.rolled_distance = read_number_attribute(group, "rolled_distance_m");
    patch.n_along         = static_cast<unsigned int>(read_number_attribute(group, "n_along"));
    patch.n_lateral       = static_cast<unsigned int>(read_number_attribute(group, "n_lateral"));
    for (const auto &[name, values] : {std::make_pair("along", &wheelrail::PatchFields::along),
                                       {"lateral", &wheelrail::PatchFields::lateral},
                                       {"gap", &wheelrail::PatchFields::gap},
                                       {"pressure", &wheelrail::PatchFields::pressure},
                                       {"shear_along", &wheelrail::PatchFields::traction_along},
                                       {"shear_lateral", &wheelrail::PatchFields::traction_lateral},
                                       {"slip_along", &wheelrail::PatchFields::slip_along},
                                       {"slip_lateral", &wheelrail::PatchFields::slip_lateral},
                                       {"state", &wheelrail::PatchFields::state},
                                       {"area", &wheelrail::PatchFields::area}})
      patch.*values = read_dataset(group, name);
    return patch;
  }
} // namespace test
