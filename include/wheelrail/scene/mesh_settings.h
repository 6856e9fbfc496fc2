#pragma once

#include <wheelrail/solid/element_form.h>

#include <optional>
#include <vector>

namespace wheelrail
{
  /// Where the finest cells lie.
  enum class MeshWindow
  {
    fixed, ///< all along the rolled distance
    moving ///< around the wheel
  };

  /// What becomes of finest cells that the wheel has left behind.
  enum class BehindWheel
  {
    automatic, ///< those that have flowed stay, the others are made coarse
    coarsen,   ///< all are made coarse
    keep       ///< all stay
  };

  /// Cells, as in subsection Mesh.
  struct MeshSettings
  {
    double      cell_size        = 1e-3;  ///< Solution cell size [m]
    double      coarse_cell_size = 16e-3; ///< [m]
    double      fine_depth       = 0; ///< given depth of the finest cells [m], 0: see depth_of_fine_cells()
    double      fine_margin      = 3e-3; ///< fine cells beyond the expected patch [m] ("Fine margin")
    ElementForm element          = ElementForm::reduced;
    std::optional<ElementForm> rail_element, wheel_element; ///< none: as `element`
    MeshWindow                 window       = MeshWindow::moving;
    BehindWheel                behind_wheel = BehindWheel::automatic;
    double              planned_load = 0; ///< for whose patch fine cells are laid [N], 0: the wheel load
    std::vector<double> planned_strip;    ///< rail section x, fine cells between [m]; none: around the patch
    bool   mass_scaling      = false;     ///< cells stiffer than a cube of the cell size get a larger density
    double prepared_distance = 0; ///< the mesh is made for rolling that far [m], 0: the rolling distance

    /// Depth of the layer of solution cells below both running surfaces: as given, or five cells [m].
    double
    depth_of_fine_cells() const
    {
      return fine_depth > 0 ? fine_depth : 5 * cell_size;
    }
  };
} // namespace wheelrail
