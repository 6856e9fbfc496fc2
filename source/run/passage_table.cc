#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/output/descriptions.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/output/hdf5_handles.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/run/passage_table.h>
#include <wheelrail/verdict/verdict.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <numeric>
#include <utility>

namespace wheelrail
{
  namespace
  {
    struct Field
    {
      const char *name;
      const char *unit;
    };

    /// Figures of the table, by their keys in summary.json.
    const std::vector<std::string> &
    figure_keys()
    {
      static const std::vector<std::string> list = split_list(
        "wheel_load_N, first_force_over_load, vertical_force_N, longitudinal_force_N, max_pressure_Pa, "
        "max_pressure_low_Pa, max_pressure_high_Pa, contact_area_m2, contact_area_low_m2, "
        "contact_area_high_m2, patch_lateral_m, patch_longitudinal_m, max_shear_traction_Pa, creepage, "
        "rail_plastic_strain, residual_lateral_stress_Pa, residual_longitudinal_stress_Pa, "
        "residual_forward_flow_m, plastic_band_width_m, plastic_band_depth_m, plastic_work_rail_J, "
        "plastic_work_wheel_J, energy_error, wall_time_s");
      return list;
    }

    /// What each value is more than the one before.
    std::vector<double>
    increments(std::vector<double> values)
    {
      std::adjacent_difference(values.begin(), values.end(), values.begin());
      return values;
    }

    using Fields = std::map<std::string, std::vector<double>>;

    /// Units of what residual.h5 has of the cut over lateral place and depth.
    const std::vector<Field> &
    cut_fields()
    {
      static const std::vector<Field> list = {{"plastic_strain", "1"},
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
      for (const Field &field : cut_fields())
        if (H5Lexists(group, field.name, H5P_DEFAULT) > 0)
          cut[field.name] = hdf5::read_dataset(group, field.name);
      return cut;
    }

    void
    write_cuts(const hid_t file, const std::string &folder, const unsigned int passed)
    {
      std::vector<double> passages;
      std::vector<Fields> cuts;
      for (unsigned int k = 1; k <= passed; ++k)
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
      for (const Field &field : cut_fields())
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
                  added.push_back(k == 0                              ? now[i]
                                  : passages[k] > passages[k - 1] + 1 ? std::nan("")
                                                                      : now[i] - cuts[k - 1][field.name][i]);
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
    return folder + text("/passage_%03u", passage);
  }


  LeftInRail
  left_in_rail(const std::string &folder, const unsigned int passage)
  {
    const Summary summary = read_summary(passage_folder(folder, passage) + "/summary.json");
    return {get_figure(summary, "rail_plastic_strain"),
            get_figure(summary, "residual_forward_flow_m"),
            get_figure(summary, "plastic_band_depth_m")};
  }


  FigureTable
  passage_table(const std::string &folder, const unsigned int passed)
  {
    std::vector<Summary> summaries;
    std::vector<double>  numbers, grades;
    for (unsigned int k = 1; k <= passed; ++k)
      {
        numbers.push_back(k);
        summaries.push_back(read_summary(passage_folder(folder, k) + "/summary.json"));
      }
    FigureTable table;
    table.add("passage", "1", numbers);
    for (const Summary &summary : summaries)
      grades.push_back(static_cast<double>(grade_of(summary)));
    table.add("verdict", "1", grades);
    for (const std::string &key : figure_keys())
      {
        std::vector<double> values;
        for (const Summary &summary : summaries)
          values.push_back(get_figure(summary, key));
        table.add(key, unit_of(key), values);
      }
    table.add("plastic_strain_increment", "1", increments(*table.find("rail_plastic_strain")));
    table.add("forward_flow_increment_m", "m", increments(*table.find("residual_forward_flow_m")));
    return table;
  }


  std::string
  passage_verdicts(const FigureTable &table)
  {
    std::size_t of_grade[3] = {0, 0, 0};
    for (const double grade : *table.find("verdict"))
      ++of_grade[static_cast<int>(grade)];
    return "verdict: " + std::to_string(of_grade[2]) + " passages trusted, " + std::to_string(of_grade[1]) +
           " with care, " + std::to_string(of_grade[0]) + " not trusted\n";
  }


  std::vector<RoundGrowth>
  round_growths(const std::string &folder, const unsigned int passed, const unsigned int of_round)
  {
    std::vector<RoundGrowth> rounds;
    // a rail in which nothing has yielded has no band
    double strain = 0, forward = 0;
    for (unsigned int k = of_round; k <= passed; k += of_round)
      {
        const LeftInRail now   = left_in_rail(folder, k);
        const double     shear = now.depth > 0 ? (now.forward - forward) / now.depth : 0;
        rounds.push_back({std::isnan(now.strain) ? 0 : now.strain - strain, shear});
        strain  = std::isnan(now.strain) ? strain : now.strain;
        forward = std::isnan(now.forward) ? forward : now.forward;
      }
    return rounds;
  }


  void
  write_passage_fields(const std::string &folder, const unsigned int passed, const FigureTable &table)
  {
    const hdf5::Handle file(hdf5::open_in_memory(), H5Fclose, "make a file in memory");
    for (std::size_t c = 1; c < table.keys.size(); ++c) // HDF5 counts the passages by itself
      hdf5::write_dataset(
        file, table.keys[c], {table.rows()}, table.columns[c], table.units[c], description_of(table.keys[c]));
    write_cuts(file, folder, passed);
    const std::vector<char> bytes = hdf5::file_image(file);
    replace_file(folder + "/passages.h5", bytes.data(), bytes.size());
  }


  namespace
  {
    bool
    near(const double before, const double now, const double change)
    {
      return std::abs(now - before) <= change * std::abs(before);
    }

    bool
    steady(const RoundGrowth &before, const RoundGrowth &now, const double least, const double change)
    {
      const bool flows = std::abs(now.shear) >= least || std::abs(before.shear) >= least;
      return near(before.strain, now.strain, change) && (!flows || near(before.shear, now.shear, change));
    }
  } // namespace


  PassageTrend
  trend_of(const std::vector<RoundGrowth> &rounds, const double least, const double change)
  {
    if (rounds.empty())
      return PassageTrend::open;
    const std::size_t  n    = rounds.size();
    const RoundGrowth &last = rounds.back();
    if (last.strain < least)
      return PassageTrend::shakedown;
    if (n < 3 || !steady(rounds[n - 3], rounds[n - 2], least, change) ||
        !steady(rounds[n - 2], last, least, change))
      return PassageTrend::open;
    return std::abs(last.shear) >= least ? PassageTrend::ratcheting : PassageTrend::to_and_fro;
  }


  std::string
  in_words(const PassageTrend trend, const RoundGrowth &last)
  {
    const std::string strain = text("%.2g", last.strain), shear = text("%.2g", last.shear);
    const std::string forward =
      !std::isnan(last.shear)
        ? std::string(", the forward shear of the plastic zone by ") + shear + " in the last round"
      : trend == PassageTrend::shakedown
        ? " in the last round"
        : " in the last round; the run is too short to tell the forward flow";
    const std::string verdict = trend == PassageTrend::shakedown ? "the rail has shaken down"
                                : trend == PassageTrend::to_and_fro
                                  ? "the rail is in alternating plasticity (closed plastic loop)"
                                : trend == PassageTrend::ratcheting ? "the rail ratchets"
                                                                    : "the passages are not steady yet";
    return verdict + ": the largest plastic strain grew by " + strain + forward;
  }
} // namespace wheelrail
