#pragma once

#include <wheelrail/mesh/sweep_plan.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/receptance/hammer.h>
#include <wheelrail/scene/scene.h>

#include <functional>
#include <memory>
#include <vector>

namespace wheelrail
{
  class Axle;

  /// A body of a scene by itself, in its coarse blocks and without load: the rail on its supports, or the
  /// wheel on its axle and springs. No contact is needed, and no fine cells that would bound the time step.
  struct LoneBody
  {
    SweepPlan             plan;
    Solid                 solid;
    SceneParts            parts;
    std::unique_ptr<Axle> axle;          ///< of the wheel
    double                time_step = 0; ///< [s]

    ~LoneBody();
  };

  /// Throws what sweep_plan() does. Collective.
  std::unique_ptr<LoneBody>
  make_lone_body(const Scene &scene, const SceneGeometry &geometry, Body body, MPI_Comm communicator);

  /// What a blow does: force and displacements of some faces at equal steps of time.
  struct BlowRecord
  {
    double                           step = 0;         ///< [s]
    std::vector<double>              force;            ///< [N]
    std::vector<std::vector<double>> moved;            ///< of each face, along its direction [m]
    double                           energy_error = 0; ///< largest, relative
    unsigned long                    time_steps   = 0;
  };

  /// The blow on `faces[0]`, observed at all of them for `duration` [s], at steps of some 20 us; `report` is
  /// called with the share that is done. Collective.
  BlowRecord
  strike(const RunSettings                 &scene,
         LoneBody                          &body,
         const std::vector<HammerFace>     &faces,
         double                             duration,
         MPI_Comm                           communicator,
         const std::function<void(double)> &report = {});
} // namespace wheelrail
