#pragma once

#include <wheelrail/contact/contact.h>
#include <wheelrail/dynamics/time_loop.h>
#include <wheelrail/mesh/discretization.h>
#include <wheelrail/mesh/fine_window.h>
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
    ContactGeometry                 geometry;
    std::unique_ptr<Discretization> discretization; ///< makes all meshes
    FineWindow                      window; ///< where the finest cells lie, when they go with the wheel
    Solid                           solid;
    std::unique_ptr<Contact>        contact;
    SceneParts                      parts; ///< beside contact and axle: supports, weights
    AxleData                        axle;
    double                          wheel_load        = 0; ///< weight of sprung mass, axle and wheel [N]
    double                          duration          = 0; ///< of the run [s]
    double                          time_step         = 0; ///< [s]
    double                          expected_approach = 0; ///< from Hertz' scaling with the load [m]
    double reach = 0; ///< of the undeformed overlap at that approach, along the track from the contact [m]
  };

  TimeScheme
  time_scheme(const RunSettings &scene, const Model &model);

  /// Where the fine zone lies and how the sections are swept. Throws InputError and RunError as
  /// make_sweep_plan() does.
  SweepPlan
  sweep_plan(const Scene &scene, const SceneGeometry &geometry);

  /// The step that the cells allow on the whole path (step_on_path()); supports and free edges may shorten
  /// it. Throws as sweep_plan().
  StableStep
  limit_of_step(const Scene &scene, const SceneGeometry &geometry);

  /// Makes the mesh of the model's window, and prepares the bodies and the contact on it, at rest:
  /// masses, surfaces, added mass. The law of the contact stays that of the first mesh. Collective.
  void
  prepare_mesh(Model &model, MPI_Comm communicator);

  /// Whether the window has to move on, when the wheel's contact is at these places of rail and wheel, see
  /// follow(); moves it, and finds the columns that stay fine. Collective.
  bool
  move_window(const MeshSettings &scene, Model &model, const PerBody<double> &place, MPI_Comm communicator);

  /// Keeps the columns of blocks fine in which a body has flowed, and no others, unless Mesh/Behind the wheel
  /// makes all coarse. Collective.
  void
  keep_flowed(const MeshSettings &scene, Model &model, Body body, MPI_Comm communicator);

  /// Gives the window a longer path [m]; whether that changes the range of the finest cells.
  bool
  lengthen_path(Model &model, double distance);

  /// Builds the model. Throws InputError when the scene cannot be built. Collective.
  Model
  make_model(const Scene &scene, const SceneGeometry &geometry, MPI_Comm communicator);
} // namespace wheelrail
