#pragma once

#include <wheelrail/contact/contact.h>
#include <wheelrail/mesh/forest.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/wheelset/axle.h>

#include <memory>

namespace wheelrail
{
  /// Everything a run is made of, built from a scene: geometry, mesh, bodies, contact.
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

  Plasticity
  plasticity(const MaterialData &material);

  /// Where the fine zone lies and how the sections are swept, for a contact found by 2D-Geo.
  SweepPlan
  sweep_plan(const Scene &scene, const ContactGeometry &geometry, double expected_approach);

  /// Builds the model. Throws InputError when the scene cannot be built. Collective.
  Model
  make_model(const Scene &scene, MPI_Comm communicator);
} // namespace wheelrail
