#pragma once

#include <wheelrail/base/log.h>
#include <wheelrail/model/model.h>
#include <wheelrail/state/checkpoint.h>
#include <wheelrail/statics/static_start.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// What the axle starts with; the state of the bodies and of the contact is in the model.
  struct RunStart
  {
    double hub_displacement = 0;     ///< static, vertical [m]
    double rate             = 0;     ///< pitch rate [rad/s]
    bool   at_border        = false; ///< the patch touches the border of the fine cells
  };

  /// The warnings of check_scene() with what this machine has for each rank. Collective; throws InputError
  /// for a scene that it cannot hold.
  std::vector<std::string>
  check_on_machine(const Scene &scene, const SceneGeometry &geometry, MPI_Comm communicator);

  /// What the static start of a scene is asked for.
  StaticLoads
  static_loads(const Scene &scene, const Model &model);

  /// Brings a model into static equilibrium under its loads and gives both bodies the velocities of
  /// rolling, see static_start() and rolling_velocities(). `beyond`: bodies_of_start(), or none. Collective;
  /// throws RunError when no equilibrium is found.
  RunStart
  start_from_rest(const Scene &scene, Model &model, const BeyondHalfspaces &beyond, Log &log);

  /// The same; when the patch reaches the edge of the fine cells, `scene.fine_margin` is doubled, to 24 mm at
  /// most, and the model made anew. Where profiles conform, as in the root of the flange, small moves of the
  /// loaded bodies open a second patch beside the one that the profiles let expect; a start that fails on a
  /// wider mesh counts as one at its edge. On a `rail` of an earlier run (none: a null pointer) the mesh
  /// stays that of the rail. Collective.
  RunStart
  start_on_wide_mesh(Scene               &scene,
                     const SceneGeometry &geometry,
                     Model               &model,
                     const Checkpoint    *rail,
                     Log                 &log,
                     MPI_Comm             communicator);
} // namespace wheelrail
