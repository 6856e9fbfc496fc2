#include <wheelrail/base/format_text.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/model/coarser_cells.h>
#include <wheelrail/output/folder.h>

#include <algorithm>

namespace wheelrail
{
  bool
  takes_coarser_cells(const Scene &scene)
  {
    return !scene.several_passages() && scene.rail_from == "new";
  }


  Scene
  scene_on_coarser_cells(const Scene &scene)
  {
    Scene coarser            = scene;
    coarser.error_estimate   = ErrorEstimate::model;
    coarser.folder           = folder_beside(scene.folder, "-coarse").string();
    coarser.volume_fields    = false;
    coarser.cell_size        = 2 * scene.cell_size;
    coarser.coarse_cell_size = std::max(scene.coarse_cell_size, coarser.cell_size);
    coarser.fine_margin      = std::max(scene.fine_margin, coarser.cell_size);
    coarser.mass_scaling     = false; // may be too much for large cells
    if (scene.fine_depth > 0)
      coarser.fine_depth = std::max(scene.fine_depth, 2 * coarser.cell_size);
    if (scene.motion == "none" && !scene.irregular() && scene.evaluate_at == 0 &&
        !scene.rail_material.yields() && !scene.wheel_material.yields())
      {
        coarser.rolling_distance = 0; // until steady
        coarser.longest_distance = scene.path();
      }
    return coarser;
  }


  std::string
  cost_of_coarser_cells(const Scene &scene, const ExpectedPatch &patch)
  {
    const Scene coarser = scene_on_coarser_cells(scene);
    return "two meshes: a run on cells of " + in_mm(coarser.cell_size) + " comes first, for about " +
           text("%.0f %% more time",
                100 * expected_elements(coarser, patch) / expected_elements(scene, patch));
  }
} // namespace wheelrail
