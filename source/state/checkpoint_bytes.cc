#include <wheelrail/base/errors.h>
#include <wheelrail/output/hdf5_handles.h>
#include <wheelrail/state/checkpoint.h>

#include <map>
#include <sstream>
#include <type_traits>
#include <vector>

namespace wheelrail
{
  using namespace hdf5;

  namespace
  {
    // --- what is in a file: the lists serve writing and reading alike ---

    template <typename C, typename Visit>
    void
    visit_numbers(C &c, const Visit &visit)
    {
      visit("wall_time", c.wall_time);
      visit("ticks", c.ticks);
      visit("time_step", c.time_step);
      visit("prepared_distance", c.prepared_distance);
      visit("longest_distance", c.longest_distance);
      visit("fine_margin", c.fine_margin);
      visit("time", c.rolling.time);
      visit("steps", c.rolling.steps);
      visit("balance_started", c.rolling.energy.started);
      visit("energy_at_start", c.rolling.energy.start);
      visit("energy_error", c.rolling.energy.error);
      visit("ranks", c.ranks);
      visit("rail_column", c.window.column.rail);
      visit("wheel_column", c.window.column.wheel);
      visit("rail_start_column", c.window.start.rail);
      visit("wheel_start_column", c.window.start.wheel);
      visit("start_block", c.start_block);
      visit("rail_path_end", c.window.path_end.rail);
      visit("wheel_path_end", c.window.path_end.wheel);
      visit("rail_first", c.contact.window.rail.first);
      visit("rail_last", c.contact.window.rail.last);
      visit("wheel_first", c.contact.window.wheel.first);
      visit("wheel_last", c.contact.window.wheel.last);
    }

    /// Before the name of an energy term in the names of datasets.
    const std::string work_prefix = "work_";

    /// Pressure, shear (3), facet (2) and place in it (2) of each node.
    constexpr std::size_t contact_numbers = 8;

    std::vector<double>
    pack(const std::vector<ContactNode> &nodes)
    {
      std::vector<double> values;
      for (const ContactNode &n : nodes)
        values.insert(values.end(),
                      {n.pressure,
                       n.elastic[0],
                       n.elastic[1],
                       n.elastic[2],
                       double(n.foot.i),
                       double(n.foot.j),
                       n.foot.xi,
                       n.foot.eta});
      return values;
    }

    std::vector<ContactNode>
    unpack(const std::vector<double> &values)
    {
      std::vector<ContactNode> nodes(values.size() / contact_numbers);
      for (std::size_t k = 0; k < nodes.size(); ++k)
        {
          const double *v   = &values[contact_numbers * k];
          nodes[k].pressure = v[0];
          nodes[k].elastic  = {v[1], v[2], v[3]};
          nodes[k].foot.i   = static_cast<int>(v[4]);
          nodes[k].foot.j   = static_cast<int>(v[5]);
          nodes[k].foot.xi  = v[6];
          nodes[k].foot.eta = v[7];
        }
      return nodes;
    }

    std::vector<double>
    numbers_of(const std::vector<int> &columns)
    {
      return {columns.begin(), columns.end()};
    }

    std::vector<int>
    columns_of(const std::vector<double> &numbers)
    {
      return {numbers.begin(), numbers.end()};
    }

    // --- parts: names and values of the numbers that all ranks know, nodes and their values ---

    std::string
    part_prefix(const std::string &name)
    {
      return "part_" + name;
    }

    // --- tables: one array, column by column, the names and units as lines of text ---

    std::string
    join_lines(const std::vector<std::string> &lines)
    {
      std::string text;
      for (const std::string &line : lines)
        text += line + "\n";
      return text;
    }

    std::vector<std::string>
    split_lines(const std::string &text)
    {
      std::vector<std::string> lines;
      std::istringstream       stream(text);
      for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
      return lines;
    }

    void
    write_table(const hid_t file, const std::string &name, const History &table)
    {
      std::vector<double> values;
      for (const auto &column : table.columns)
        values.insert(values.end(), column.begin(), column.end());
      write_dataset(file, name, {values.size()}, values, "SI");
      write_attribute(file, name + "_names", join_lines(table.names));
      write_attribute(file, name + "_units", join_lines(table.units));
    }

    History
    read_table(const hid_t file, const std::string &name)
    {
      History table;
      table.names         = split_lines(read_text_attribute(file, name + "_names"));
      table.units         = split_lines(read_text_attribute(file, name + "_units"));
      const auto   values = read_dataset(file, name);
      const size_t rows   = table.names.empty() ? 0 : values.size() / table.names.size();
      for (auto begin = values.begin(); table.columns.size() < table.names.size(); begin += rows)
        table.columns.emplace_back(begin, begin + rows);
      return table;
    }

    void
    write_parts(const hid_t file, const std::map<std::string, PartState> &parts)
    {
      std::vector<std::string> names;
      const auto               write = [&](const std::string &name, const std::vector<double> &values) {
        write_dataset(file, name, {values.size()}, values, "SI");
      };
      for (const auto &[name, state] : parts)
        {
          std::vector<std::string> entries;
          std::vector<double>      numbers;
          for (const auto &[entry, number] : state.numbers)
            {
              entries.push_back(entry);
              numbers.push_back(number);
            }
          names.push_back(name);
          write_attribute(file, part_prefix(name), join_lines(entries));
          write(part_prefix(name) + "_numbers", numbers);
          write_keys(file, part_prefix(name) + "_nodes", state.nodes);
          write(part_prefix(name) + "_values", state.values);
        }
      write_attribute(file, "parts", join_lines(names));
    }

    std::map<std::string, PartState>
    read_parts(const hid_t file)
    {
      std::map<std::string, PartState> parts;
      for (const std::string &name : split_lines(read_text_attribute(file, "parts")))
        {
          PartState &state   = parts[name];
          const auto entries = split_lines(read_text_attribute(file, part_prefix(name)));
          const auto numbers = read_dataset(file, part_prefix(name) + "_numbers");
          for (std::size_t k = 0; k < entries.size(); ++k)
            state.numbers[entries[k]] = numbers.at(k);
          state.nodes  = read_keys(file, part_prefix(name) + "_nodes");
          state.values = read_dataset(file, part_prefix(name) + "_values");
        }
      return parts;
    }

    /// Files say their format from 7 on; throws RunError for another one than that of this program.
    void
    check_format(const hid_t file)
    {
      const int format = has_attribute(file, "format") ? int(read_number_attribute(file, "format")) : 6;
      if (format != checkpoint_format)
        throw RunError("it is of format " + std::to_string(format) +
                       ", this version of the program reads format " + std::to_string(checkpoint_format));
    }

    // --- values by number: the rows of a dataset, in a group that names them ---

    void
    write_values(const hid_t file, const std::string &group, const std::map<std::string, NumberedValues> &all)
    {
      std::string names;
      for (const auto &[name, v] : all)
        {
          write_dataset(
            file, group + "_" + name, {v.values.size() / v.components, v.components}, v.values, "SI");
          names += name + "\n";
        }
      write_attribute(file, group, names);
    }

    std::map<std::string, NumberedValues>
    read_values(const hid_t file, const std::string &group, const std::size_t rows)
    {
      std::map<std::string, NumberedValues> all;
      for (const std::string &name : split_lines(read_text_attribute(file, group)))
        {
          NumberedValues &v = all[name];
          v.values          = read_dataset(file, group + "_" + name);
          v.components      = rows > 0 ? v.values.size() / rows : 1;
        }
      return all;
    }
  } // namespace


  std::vector<char>
  checkpoint_bytes(const Checkpoint &checkpoint)
  {
    const Quiet  quiet;
    const Handle file(open_in_memory(), H5Fclose, "make a file in memory");
    write_attribute(file, "format", static_cast<double>(checkpoint_format));
    write_text(file, "parameters", checkpoint.parameters);
    visit_numbers(checkpoint, [&](const char *name, const auto value) {
      write_attribute(file, name, static_cast<double>(value));
    });
    write_keys(file, "nodes", checkpoint.node);
    write_keys(file, "cells", checkpoint.cell);
    write_values(file, "node_values", checkpoint.node_values);
    write_values(file, "cell_values", checkpoint.cell_values);
    const auto write = [&](const std::string &name, const std::vector<double> &values) {
      write_dataset(file, name, {values.size()}, values, "SI");
    };
    std::vector<std::string> names;
    for (const auto &[name, work] : checkpoint.works)
      {
        write(work_prefix + name, work);
        names.push_back(name);
      }
    write_attribute(file, "works", join_lines(names));
    write("rail_kept", numbers_of(checkpoint.window.kept.rail));
    write("wheel_kept", numbers_of(checkpoint.window.kept.wheel));
    write_parts(file, checkpoint.rolling.parts);
    write("contact", pack(checkpoint.contact.nodes));
    write_table(file, "history", checkpoint.recorder.history);
    write_table(file, "patches", checkpoint.recorder.patches);
    write_table(file, "wear", checkpoint.recorder.wear);
    return file_image(file);
  }


  Checkpoint
  checkpoint_from_bytes(const std::string &bytes)
  {
    const Quiet  quiet;
    const Handle file(open_in_memory(bytes), H5Fclose, "read it");
    Checkpoint   checkpoint;
    check_format(file);
    checkpoint.parameters = read_text(file, "parameters");
    visit_numbers(checkpoint, [&](const char *name, auto &value) {
      value = static_cast<std::decay_t<decltype(value)>>(read_number_attribute(file, name));
    });
    checkpoint.node        = read_keys(file, "nodes");
    checkpoint.cell        = read_keys(file, "cells");
    checkpoint.node_values = read_values(file, "node_values", checkpoint.node.size());
    checkpoint.cell_values = read_values(file, "cell_values", checkpoint.cell.size());
    for (const std::string &name : split_lines(read_text_attribute(file, "works")))
      checkpoint.works[name] = read_dataset(file, work_prefix + name);
    checkpoint.window.kept.rail  = columns_of(read_dataset(file, "rail_kept"));
    checkpoint.window.kept.wheel = columns_of(read_dataset(file, "wheel_kept"));
    checkpoint.rolling.parts     = read_parts(file);
    checkpoint.contact.nodes     = unpack(read_dataset(file, "contact"));
    checkpoint.recorder.history  = read_table(file, "history");
    checkpoint.recorder.patches  = read_table(file, "patches");
    checkpoint.recorder.wear     = read_table(file, "wear");
    return checkpoint;
  }
} // namespace wheelrail
