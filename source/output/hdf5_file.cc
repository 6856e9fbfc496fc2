#include <wheelrail/base/errors.h>
#include <wheelrail/output/descriptions.h>
#include <wheelrail/output/hdf5_file.h>
#include <wheelrail/output/hdf5_handles.h>
#include <wheelrail/output/replace_file.h>

#include <array>
#include <cstdint>

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

    /// The bytes of the file.
    std::vector<char>
    history_bytes(const History &history)
    {
      const Handle file(open_in_memory(), H5Fclose, "make a file in memory");
      describe_root(file);
      for (std::size_t c = 0; c < history.names.size(); ++c)
        {
          const std::string &name = history.names[c];
          write_dataset(file,
                        name,
                        {history.columns[0].size()},
                        history.columns[c],
                        history.units[c],
                        description_of(name));
          const Handle set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "mark a column");
          write_attribute(set, "column", static_cast<unsigned int>(c));
        }
      return file_image(file);
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

    std::vector<char> bytes;
    try
      {
        bytes = history_bytes(history);
      }
    catch (const RunError &error)
      {
        throw RunError("The HDF5 file \"" + path + "\": " + error.what());
      }
    replace_file(path, bytes.data(), bytes.size());
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
} // namespace wheelrail
