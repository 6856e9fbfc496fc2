#pragma once

#include <wheelrail/application/model.h>
#include <wheelrail/output/fields.h>

namespace wheelrail
{
  /// The contact patch of the moment on the rail nodes of the contact window. The coordinate along
  /// the track counts from the axle, shear and slip are in the directions of Z and of s.
  PatchFields
  patch_fields(const Contact &contact, const AxleData &axle, double time, double travelled);

  /// Which cells of the mesh a file shows.
  enum class Selection
  {
    all,
    window, ///< finest cells near the contact
    surface ///< faces of the finest cells on the running surfaces, as quadrilaterals
  };

  /// Positions, displacement against the rigid motion of the body, and for cells the von Mises stress
  /// and the stress components, for surfaces the contact tractions. Collective.
  FieldMesh
  field_mesh(const Solid   &solid,
             const Axle    &axle,
             const Contact &contact,
             Selection      selection,
             MPI_Comm       communicator);

  /// Largest von Mises stress over the elements of all ranks [Pa]. Collective.
  double
  largest_von_mises(const Solid &solid, MPI_Comm communicator);
} // namespace wheelrail
