#pragma once

// The scene of the rolling program in a size for tests: a short rail, few and coarse cells.

#include <wheelrail/model/model.h>

namespace test
{
  /// S1002 on 54E1, driving, with the given finest cells [m], 0.3 m of rail and 6 mm of rolling.
  inline wheelrail::Scene
  small_scene(const double cell_size, const double coarse_cell_size = 16e-3)
  {
    wheelrail::Scene scene;
    scene.cell_size            = cell_size;
    scene.coarse_cell_size     = coarse_cell_size;
    scene.fine_depth           = 2 * cell_size;
    scene.fine_margin          = 2 * cell_size;
    scene.rail_length          = 0.3;
    scene.traction_coefficient = 0.25;
    scene.rolling_distance     = 6e-3;
    scene.averaging_distance   = 3e-3;
    return scene;
  }

  /// Its model. Collective.
  inline wheelrail::Model
  small_model(MPI_Comm communicator, const double cell_size, const double coarse_cell_size = 16e-3)
  {
    const wheelrail::Scene scene = small_scene(cell_size, coarse_cell_size);
    return wheelrail::make_model(scene, wheelrail::make_geometry(scene), communicator);
  }
} // namespace test
