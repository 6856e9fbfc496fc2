#include <wheelrail/base/errors.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/base/read_file.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/model/coarser_cells.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/root.h>
#include <wheelrail/run/passages.h>
#include <wheelrail/run/run_scene.h>
#include <wheelrail/state/checkpoint_checks.h>
#include <wheelrail/state/checkpoint_files.h>
#include <wheelrail/wheel/coarse_halfspaces.h>

#include <filesystem>

namespace wheelrail
{
  namespace
  {
    /// The first of two meshes, in a folder beside that of the run, which is held meanwhile. One that is
    /// finished is kept, unless it had other entries or all starts anew. Returns the exit code.
    int
    run_on_coarser_cells(const Scene &scene, const SceneGeometry &geometry, const RunOptions &options)
    {
      const Scene coarser        = scene_on_coarser_cells(scene);
      RunOptions  of_coarser     = options;
      of_coarser.parameters_text = print_parameters(coarser);
      of_coarser.whole_folder    = scene.folder;
      const std::string size     = "cells of " + in_mm(coarser.cell_size);
      of_coarser.note            = "the first of two meshes, " + size;
      const auto   mode          = options.resume      ? FolderMode::resume
                                   : options.overwrite ? FolderMode::overwrite
                                                       : FolderMode::fresh;
      OutputFolder whole(scene.folder, mode, options.prm_text, MPI_COMM_WORLD);
      int          there[2] = {0, 0}; // finished; with the same entries
      on_root(MPI_COMM_WORLD, [&]() {
        if (mode == FolderMode::fresh)
          protect_saved_states(scene.folder);
        const std::string path = coarser.folder + "/parameters.prm";
        there[0]               = holds_finished_run(coarser.folder);
        there[1]               = std::filesystem::exists(path) &&
                   other_entries(read_whole_file(path), of_coarser.parameters_text, false).empty();
      });
      MPI_Bcast(there, 2, MPI_INT, 0, MPI_COMM_WORLD);
      whole.begin(options.parameters_text, options.resume);
      if (there[0] && there[1] && !options.overwrite)
        return 0;
      of_coarser.resume    = options.resume && there[1];
      of_coarser.overwrite = !of_coarser.resume;
      try
        {
          return run_simulation(coarser, geometry, of_coarser);
        }
      catch (const RunError &error)
        {
          throw RunError("Run/Error estimate = two meshes: the run on " + size + ": " + error.what());
        }
    }
  } // namespace


  int
  run_scene(const Scene &given, const SceneGeometry &geometry, const RunOptions &options)
  {
    const Scene scene = scene_of_run(given);
    save_when_interrupted();
    if (scene.several_passages())
      return run_passages(scene, geometry, options);
    if (scene.error_estimate == ErrorEstimate::two_meshes)
      if (const int code = run_on_coarser_cells(scene, geometry, options); code != 0)
        return code;
    return run_simulation(scene, geometry, options);
  }
} // namespace wheelrail
