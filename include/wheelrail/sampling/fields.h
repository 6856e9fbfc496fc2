#pragma once

#include <wheelrail/base/body.h>
#include <wheelrail/model/model.h>
#include <wheelrail/output/fields.h>
#include <wheelrail/solid/stress_recovery.h>

namespace wheelrail
{
  /// The contact patch of the moment on the rail nodes of the contact window. The coordinate along
  /// the track counts from the axle, shear and slip are in the directions of Z and of s.
  PatchFields
  patch_fields(const Contact &contact, const Axle &axle, double time);

  /// Which cells of the mesh a file shows.
  enum class Selection
  {
    all,
    window, ///< finest cells near the contact
    surface ///< faces of the finest cells on the running surfaces, as quadrilaterals
  };

  /// Positions, displacement against the rigid motion of the body, and for cells the von Mises stress,
  /// the stress components, for surfaces the contact tractions. Where a body may yield, both show the
  /// accumulated plastic strain, and von Mises' equivalent of the stress in the
  /// rail that the wheel left at least `unloaded` [m] behind, NaN elsewhere. `nodal`: see nodal_stress(),
  /// made once for all files of a moment since it costs as much as a file. `residual`: the stresses of the
  /// unloaded bodies, shown besides where they are known (Residual). Collective.
  FieldMesh
  field_mesh(const Solid       &solid,
             const Axle        &axle,
             const Contact     &contact,
             Selection          selection,
             const NodalStress &nodal,
             double             unloaded,
             const NodalStress *residual = nullptr);

  /// How far behind the wheel its own stress has faded, some patch lengths [m].
  double
  unloaded_distance(const Model &model);
} // namespace wheelrail
