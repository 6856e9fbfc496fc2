#include <wheelrail/base/errors.h>
#include <wheelrail/base/print.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/output/root.h>
#include <wheelrail/output/summary.h>
#include <wheelrail/run/passages.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <unistd.h>

namespace wheelrail
{
  namespace
  {
    namespace fs = std::filesystem;

    /// What is known of a passage before it is computed.
    enum class Stage
    {
      none,    ///< nothing is there
      begun,   ///< it may be gone on with
      finished ///< with its rail
    };

    /// Collective.
    Stage
    stage_of(const std::string &folder, MPI_Comm communicator)
    {
      int stage = 0;
      on_root(communicator, [&]() {
        if (holds_finished_run(folder) && fs::exists(folder + "/rail.h5"))
          stage = 2;
        else if (fs::exists(folder + "/parameters.prm") && !holds_finished_run(folder))
          stage = 1;
      });
      MPI_Bcast(&stage, 1, MPI_INT, 0, communicator);
      return static_cast<Stage>(stage);
    }

    /// Figures of the table, by their keys in summary.json.
    const std::vector<std::string> &
    columns()
    {
      static const std::vector<std::string> list = {"wheel_load_N",
                                                    "first_force_over_load",
                                                    "vertical_force_N",
                                                    "longitudinal_force_N",
                                                    "max_pressure_Pa",
                                                    "contact_area_m2",
                                                    "patch_lateral_m",
                                                    "patch_longitudinal_m",
                                                    "max_shear_traction_Pa",
                                                    "creepage",
                                                    "rail_plastic_strain",
                                                    "residual_lateral_stress_Pa",
                                                    "residual_longitudinal_stress_Pa",
                                                    "residual_forward_flow_m",
                                                    "plastic_band_width_m",
                                                    "plastic_band_depth_m",
                                                    "plastic_work_rail_J",
                                                    "plastic_work_wheel_J",
                                                    "energy_error",
                                                    "wall_time_s"};
      return list;
    }

    void
    write_table(const std::string &folder, const unsigned int n)
    {
      replace_file(folder + "/passages.csv", passage_table(folder, n));
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
    std::string table = "passage";
    for (const std::string &key : columns())
      table += "," + key;
    table += ",plastic_strain_increment,forward_flow_increment_m\n";
    double strain = 0, forward = 0;
    for (unsigned int k = 1; k <= n; ++k)
      {
        const Summary summary = read_summary(passage_folder(folder, k) + "/summary.json");
        table += std::to_string(k);
        char       word[40];
        const auto add = [&](const double value) {
          std::snprintf(word, sizeof(word), std::isnan(value) ? "," : ",%.8g", value);
          table += word;
        };
        for (const std::string &key : columns())
          add(get_figure(summary, key));
        const double now = get_figure(summary, "rail_plastic_strain"),
                     at  = get_figure(summary, "residual_forward_flow_m");
        add(now - strain);
        add(at - forward);
        table += "\n";
        strain  = now;
        forward = at;
      }
    return table;
  }


  int
  run_passages(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options)
  {
    MPI_Comm     communicator = MPI_COMM_WORLD;
    const auto   mode         = options.resume      ? FolderMode::resume
                                : options.overwrite ? FolderMode::overwrite
                                                    : FolderMode::fresh;
    OutputFolder whole(scene.folder, mode, options.prm_text, communicator);
    if (mode == FolderMode::fresh && stage_of(passage_folder(scene.folder, 1), communicator) != Stage::none)
      throw InputError(
        "Output/Folder = " + scene.folder +
        ": the folder holds passages of an earlier run; --resume goes on with them, --overwrite starts "
        "anew");
    whole.begin(options.parameters_text, options.resume);
    for (unsigned int k = 1; k <= scene.passages; ++k)
      {
        Scene one    = scene;
        one.passages = 1;
        one.folder   = passage_folder(scene.folder, k);
        if (k > 1)
          one.rail_from = passage_folder(scene.folder, k - 1);
        const Stage stage = options.resume ? stage_of(one.folder, communicator) : Stage::none;
        if (stage == Stage::finished)
          continue;
        RunOptions of_one = options;
        of_one.resume     = stage == Stage::begun;
        of_one.overwrite  = options.overwrite || (options.resume && stage == Stage::none);
        on_root(communicator, [&]() {
          print(STDOUT_FILENO,
                "Passage " + std::to_string(k) + " of " + std::to_string(scene.passages) + "\n");
        });
        int code = 0;
        try
          {
            code = run_simulation(one, geometry, of_one);
          }
        catch (const RunError &error)
          {
            throw RunError("passage " + std::to_string(k) + ": " + error.what() +
                           (k == 1 ? std::string()
                                   : "; the " + std::to_string(k - 1) +
                                       " before it are kept, with their figures in " + scene.folder +
                                       "/passages.csv"));
          }
        if (code != 0)
          return code;
        on_root(communicator, [&]() { write_table(scene.folder, k); });
      }
    on_root(communicator, [&]() {
      write_table(scene.folder, scene.passages);
      write_summary(read_summary(passage_folder(scene.folder, scene.passages) + "/summary.json"),
                    scene.folder + "/summary.json");
      print(STDOUT_FILENO, "Figures of all passages in " + scene.folder + "/passages.csv\n");
    });
    return 0;
  }
} // namespace wheelrail
