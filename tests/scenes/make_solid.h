#pragma once

#include <wheelrail/solid/solid.h>

#include <array>
#include <utility>

namespace scenes
{
  using namespace wheelrail;

  /// Bodies of the materials `rail` and `wheel` and of elements of the `forms`, prepared for a mesh.
  /// Collective.
  inline Solid
  make_solid(LocalMesh                         mesh,
             const MaterialLaw                &rail,
             const MaterialLaw                &wheel,
             double                            bulk_viscosity,
             MPI_Comm                          communicator,
             const std::array<ElementForm, 2> &forms = {})
  {
    Solid solid;
    solid.choice = {{rail, wheel}, {forms[0], forms[1]}, bulk_viscosity};
    prepare(solid, std::move(mesh), communicator);
    return solid;
  }
} // namespace scenes
