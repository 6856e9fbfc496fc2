#include <wheelrail/base/errors.h>
#include <wheelrail/output/descriptions.h>
#include <wheelrail/output/hdf5_handles.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/run/passage_table.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <utility>

namespace wheelrail
{
  namespace
  {
    struct Column
    {
      const char *name; ///< key in summary.json, unless the passage has added it
      const char *unit;
    };

    const std::vector<Column> &
    columns()
    {
      static const std::vector<Column> list = {{"wheel_load_N", "N"},
                                               {"first_force_over_load", "1"},
                                               {"vertical_force_N", "N"},
                                               {"longitudinal_force_N", "N"},
                                               {"max_pressure_Pa", "Pa"},
                                               {"contact_area_m2", "m2"},
                                               {"patch_lateral_m", "m"},
                                               {"patch_longitudinal_m", "m"},
                                               {"max_shear_traction_Pa", "Pa"},
                                               {"creepage", "1"},
                                               {"rail_plastic_strain", "1"},
                                               {"residual_lateral_stress_Pa", "Pa"},
                                               {"residual_longitudinal_stress_Pa", "Pa"},
                                               {"residual_forward_flow_m", "m"},
                                               {"plastic_band_width_m", "m"},
                                               {"plastic_band_depth_m", "m"},
                                               {"plastic_work_rail_J", "J"},
                                               {"plastic_work_wheel_J", "J"},
                                               {"energy_error", "1"},
                                               {"wall_time_s", "s"}};
      return list;
    }

    /// What the first `n` passages have given: columns by name, one value a passage.
    std::vector<std::pair<Column, std::vector<double>>>
    read_columns(const std::string &folder, const unsigned int n)
    {
      std::vector<std::pair<Column, std::vector<double>>> table;
      for (const Column &column : columns())
        table.emplace_back(column, std::vector<double>());
      table.push_back({{"plastic_strain_increment", "1"}, {}});
      table.push_back({{"forward_flow_increment_m", "m"}, {}});
      auto  &added = table[table.size() - 2].second, &moved = table.back().second;
      double strain = 0, forward = 0;
      for (unsigned int k = 1; k <= n; ++k)
        {
          const Summary summary = read_summary(passage_folder(folder, k) + "/summary.json");
          for (std::size_t c = 0; c < columns().size(); ++c)
            table[c].second.push_back(get_figure(summary, columns()[c].name));
          const double now = get_figure(summary, "rail_plastic_strain"),
                       at  = get_figure(summary, "residual_forward_flow_m");
          added.push_back(now - strain);
          moved.push_back(at - forward);
          strain = now, forward = at;
        }
      return table;
    }

    using Fields = std::map<std::string, std::vector<double>>;

    /// Units of what residual.h5 has of the cut over lateral place and depth.
    const std::vector<Column> &
    cut_fields()
    {
      static const std::vector<Column> list = {{"plastic_strain", "1"},
                                               {"forward_shear", "1"},
                                               {"residual_von_mises_stress", "Pa"},
                                               {"stress_xx", "Pa"},
                                               {"stress_yy", "Pa"},
                                               {"stress_zz", "Pa"},
                                               {"stress_yz", "Pa"},
                                               {"stress_xz", "Pa"},
                                               {"stress_xy", "Pa"}};
      return list;
    }

    /// The cut BB_behind of a passage, with `position` and `depth`; nothing where there is none.
    Fields
    read_cut(const std::string &folder)
    {
      const std::string path = folder + "/residual.h5", group_name = "tick_0000/BB_behind_rail";
      Fields            cut;
      if (!std::filesystem::exists(path))
        return cut;
      const hdf5::Quiet  quiet;
      const hdf5::Handle file(hdf5::open_in_memory(read_whole_file(path)),
                              H5Fclose,
                              "read " + path + ": it is no complete HDF5 file");
      const hid_t        open = H5Gopen2(file, group_name.c_str(), H5P_DEFAULT);
      if (open < 0)
        return cut;
      const hdf5::Handle group(open, H5Gclose, "find the group " + group_name);
      for (const char *name : {"position", "depth"})
        cut[name] = hdf5::read_dataset(group, name);
      for (const Column &field : cut_fields())
        if (H5Lexists(group, field.name, H5P_DEFAULT) > 0)
          cut[field.name] = hdf5::read_dataset(group, field.name);
      return cut;
    }

    void
    write_cuts(const hid_t file, const std::string &folder, const unsigned int n)
    {
      std::vector<double> passages;
      std::vector<Fields> cuts;
      for (unsigned int k = 1; k <= n; ++k)
        {
          Fields cut = read_cut(passage_folder(folder, k));
          if (cut.empty() || (!cuts.empty() && (cut["position"].size() != cuts[0]["position"].size() ||
                                                cut["depth"].size() != cuts[0]["depth"].size())))
            continue;
          passages.push_back(k);
          cuts.push_back(std::move(cut));
        }
      if (cuts.empty())
        return;
      const hsize_t      across = cuts[0]["position"].size(), down = cuts[0]["depth"].size();
      const hdf5::Handle group(H5Gcreate2(file, "BB_behind_rail", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                               H5Gclose,
                               "make the group BB_behind_rail");
      hdf5::write_dataset(
        group, "passage", {passages.size()}, passages, "1", "number of the passage, from 1");
      for (const char *name : {"position", "depth"})
        hdf5::write_dataset(group, name, {cuts[0][name].size()}, cuts[0][name], "m", description_of(name));
      for (const Column &field : cut_fields())
        {
          std::vector<double> all, added;
          for (std::size_t k = 0; k < cuts.size(); ++k)
            {
              const auto &now = cuts[k][field.name];
              if (now.size() != across * down) // of a run of an earlier version
                break;
              for (std::size_t i = 0; i < now.size(); ++i)
                {
                  all.push_back(now[i]);
                  added.push_back(k == 0 ? now[i] : now[i] - cuts[k - 1][field.name][i]);
                }
            }
          if (all.size() != cuts.size() * across * down)
            continue;
          hdf5::write_dataset(
            group, field.name, {cuts.size(), across, down}, all, field.unit, description_of(field.name));
          if (field.unit[0] == '1')
            hdf5::write_dataset(group,
                                std::string(field.name) + "_increment",
                                {cuts.size(), across, down},
                                added,
                                field.unit,
                                "what the passage has added");
        }
    }
  } // namespace


  std::string
  passage_folder(const std::string &folder, const unsigned int passage)
  {
    char name[24];
    std::snprintf(name, sizeof(name), "/passage_%03u", passage);
    return folder + name;
  }


  std::string
  passage_table(const std::string &folder, const unsigned int n)
  {
    const auto  read  = read_columns(folder, n);
    std::string table = "passage";
    for (const auto &[column, values] : read)
      table += std::string(",") + column.name;
    table += "\n";
    for (unsigned int k = 0; k < n; ++k)
      {
        table += std::to_string(k + 1);
        for (const auto &[column, values] : read)
          {
            char word[40];
            std::snprintf(word, sizeof(word), std::isnan(values[k]) ? "," : ",%.8g", values[k]);
            table += word;
          }
        table += "\n";
      }
    return table;
  }


  std::vector<RoundGrowth>
  round_growths(const std::string &folder, const unsigned int n, const unsigned int of_round)
  {
    std::vector<RoundGrowth> rounds;
    // a rail in which nothing has yielded has no band
    double strain = 0, forward = 0;
    for (unsigned int k = of_round; k <= n; k += of_round)
      {
        const Summary summary = read_summary(passage_folder(folder, k) + "/summary.json");
        const double  now     = get_figure(summary, "rail_plastic_strain"),
                     at       = get_figure(summary, "residual_forward_flow_m"),
                     depth    = get_figure(summary, "plastic_band_depth_m");
        const double shear    = depth > 0 ? (at - forward) / depth : 0;
        rounds.push_back({std::isnan(now) ? 0 : now - strain, shear});
        strain  = std::isnan(now) ? strain : now;
        forward = std::isnan(at) ? forward : at;
      }
    return rounds;
  }


  void
  write_passage_fields(const std::string &folder, const unsigned int n)
  {
    const hdf5::Handle file(hdf5::open_in_memory(), H5Fclose, "make a file in memory");
    for (const auto &[column, values] : read_columns(folder, n))
      hdf5::write_dataset(
        file, column.name, {values.size()}, values, column.unit, description_of(column.name));
    write_cuts(file, folder, n);
    const std::vector<char> bytes = hdf5::file_image(file);
    replace_file(folder + "/passages.h5", bytes.data(), bytes.size());
  }
} // namespace wheelrail
