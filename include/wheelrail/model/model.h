#pragma once

#include <wheelrail/contact/contact.h>
#include <wheelrail/dynamics/time_loop.h>
#include <wheelrail/mesh/forest.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/wheelset/axle.h>

#include <mpi.h>

#include <memory>

namespace wheelrail
{
  /// Everything a run is made of, built from a scene: mesh, bodies, contact, axle.
  struct Model
  {
    ContactGeometry          geometry;
    std::unique_ptr<Forest>  forest;
    Solid                    solid;
    std::unique_ptr<Contact> contact;
    AxleData                 axle;
    double                   wheel_load        = 0; ///< weight of sprung mass, axle and wheel [N]
    double                   time_step         = 0; ///< [s]
    double                   expected_approach = 0; ///< from Hertz' scaling with the load [m]
  };

  /// Elastic constants of an input block.
  Elasticity
  elasticity(const MaterialData &material);

  /// Its material law.
  MaterialLaw
  material_law(const MaterialData &material);

  TimeScheme
  time_scheme(const Scene &scene, const Model &model);

  /// Where the fine zone lies and how the sections are swept. Throws InputError and RunError as
  /// make_sweep_plan() does.
  SweepPlan
  sweep_plan(const Scene &scene, const SceneGeometry &geometry);

  /// Prepares the bodies and the contact for the mesh that the forest has now, at rest: masses, stable step,
  /// surfaces, added mass. The law of the contact stays that of the first mesh. Collective.
  void
  prepare(const Scene &scene, Model &model, MPI_Comm communicator);

  /// Builds the model. Throws InputError when the scene cannot be built. Collective.
  Model
  make_model(const Scene &scene, const SceneGeometry &geometry, MPI_Comm communicator);
} // namespace wheelrail
