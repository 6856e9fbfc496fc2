#include <wheelrail/base/errors.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/output/descriptions.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/hdf5_handles.h>
#include <wheelrail/output/replace_file.h>

#include <array>
#include <cstdint>
#include <vector>

namespace wheelrail
{
  using namespace hdf5;

  namespace
  {
    struct PatchColumn
    {
      const char         *name;
      const char         *unit;
      std::vector<double> PatchFields::*values;
    };

    const std::array<PatchColumn, 10> patch_columns = {
      {{"along", "m", &PatchFields::along},
       {"lateral", "m", &PatchFields::lateral},
       {"gap", "m", &PatchFields::gap},
       {"pressure", "Pa", &PatchFields::pressure},
       {"shear_along", "Pa", &PatchFields::traction_along},
       {"shear_lateral", "Pa", &PatchFields::traction_lateral},
       {"slip_along", "1", &PatchFields::slip_along},
       {"slip_lateral", "1", &PatchFields::slip_lateral},
       {"state", "1", &PatchFields::state},
       {"area", "m2", &PatchFields::area}}};

    /// Adds the name of the file to what went wrong in it.
    template <typename Work>
    auto
    naming(const std::string &path, const Work &work)
    {
      try
        {
          return work();
        }
      catch (const RunError &error)
        {
          throw RunError("The HDF5 file \"" + path + "\": " + error.what());
        }
    }

    /// A file from the disk, in memory.
    Handle
    load(const std::string &path)
    {
      return Handle(open_in_memory(read_whole_file(path)), H5Fclose, "read it: it is no complete HDF5 file");
    }

    Handle
    open_group(const hid_t file, const std::string &name)
    {
      return Handle(H5Gopen2(file, name.c_str(), H5P_DEFAULT), H5Gclose, "find the group " + name);
    }

    herr_t
    collect_name(hid_t, const char *name, const H5L_info_t *, void *names)
    {
      static_cast<std::vector<std::string> *>(names)->push_back(name);
      return 0;
    }
  } // namespace

  void
  write_history(const History &history, const std::string &path)
  {
    const Quiet       quiet;
    const std::size_t n = history.names.size();
    if (history.units.size() != n || history.columns.size() != n)
      throw RunError("The history for \"" + path + "\" has " + std::to_string(n) + " names, " +
                     std::to_string(history.units.size()) + " units and " +
                     std::to_string(history.columns.size()) + " columns; the numbers must agree.");

    const auto bytes = naming(path, [&]() {
      const Handle file(open_in_memory(), H5Fclose, "make a file in memory");
      describe_root(file);
      const hsize_t rows = n > 0 ? history.columns[0].size() : 0;
      for (std::size_t c = 0; c < n; ++c)
        {
          write_dataset(file,
                        history.names[c],
                        {rows},
                        history.columns[c],
                        history.units[c],
                        description_of(history.names[c]));
          const Handle set(H5Dopen2(file, history.names[c].c_str(), H5P_DEFAULT), H5Dclose, "mark a column");
          write_attribute(set, "column", static_cast<unsigned int>(c));
        }
      return file_image(file);
    });
    replace_file(path, bytes.data(), bytes.size());
  }

  History
  read_history(const std::string &path)
  {
    const Quiet quiet;
    return naming(path, [&]() {
      const Handle             file = load(path);
      std::vector<std::string> names;
      require(H5Literate(file, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, collect_name, &names),
              "list its columns");

      History history;
      history.names.resize(names.size());
      history.units.resize(names.size());
      history.columns.resize(names.size());
      for (const std::string &name : names)
        {
          const Handle set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "read the column " + name);
          const double column = read_number_attribute(set, "column");
          if (!(column >= 0 && column < names.size()))
            throw RunError("column " + name + " has a number outside the table.");
          const auto c       = static_cast<std::size_t>(column);
          history.names[c]   = name;
          history.units[c]   = read_text_attribute(set, "unit");
          history.columns[c] = read_dataset(file, name);
        }
      return history;
    });
  }

  void
  append_patch(TickFile &file, const PatchFields &patch, const SlipEdge &edge)
  {
    const std::string name = tick_name(file.n_ticks());
    for (const PatchColumn &column : patch_columns)
      if ((patch.*column.values).size() != std::size_t(patch.n_along) * patch.n_lateral)
        throw RunError("The HDF5 file \"" + file.path() + "\": the field " + std::string(column.name) +
                       " of " + name + " has " + std::to_string((patch.*column.values).size()) +
                       " values where " + std::to_string(patch.n_along) + " x " +
                       std::to_string(patch.n_lateral) + " belong.");
    file.append(patch.time, patch.rolled_distance, [&](const std::int64_t group) {
      write_attribute(group, "n_along", patch.n_along);
      write_attribute(group, "n_lateral", patch.n_lateral);
      for (const PatchColumn &column : patch_columns)
        write_dataset(group,
                      column.name,
                      {patch.n_along, patch.n_lateral},
                      patch.*column.values,
                      column.unit,
                      description_of(column.name));
      if (edge.along.empty())
        return;
      const auto of_edge =
        [&](const std::string &name, const std::string &unit, const std::vector<double> &values) {
          write_dataset(group,
                        "edge_" + name,
                        {values.size()},
                        values,
                        unit,
                        "on the line between stick and slip: " + description_of(name));
        };
      of_edge("along", "m", edge.along);
      of_edge("lateral", "m", edge.lateral);
      of_edge("pressure", "Pa", edge.pressure);
      of_edge("shear_along", "Pa", edge.traction_along);
      of_edge("shear_lateral", "Pa", edge.traction_lateral);
    });
  }

  PatchFields
  read_patch(const std::string &path, const unsigned int tick)
  {
    const Quiet quiet;
    return naming(path, [&]() {
      const Handle file  = load(path);
      const Handle group = open_group(file, tick_name(tick));
      PatchFields  patch;
      patch.time            = read_number_attribute(group, "time_s");
      patch.rolled_distance = read_number_attribute(group, "rolled_distance_m");
      patch.n_along         = static_cast<unsigned int>(read_number_attribute(group, "n_along"));
      patch.n_lateral       = static_cast<unsigned int>(read_number_attribute(group, "n_lateral"));
      for (const PatchColumn &column : patch_columns)
        patch.*column.values = read_dataset(group, column.name);
      return patch;
    });
  }
} // namespace wheelrail
