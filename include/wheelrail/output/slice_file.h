#pragma once

#include <wheelrail/output/tick_file.h>

#include <cstddef>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Places of the fields in Slice::values.
  enum SliceField : std::size_t
  {
    slice_von_mises,
    slice_stress_xx,
    slice_stress_yy,
    slice_stress_zz,
    slice_stress_yz,
    slice_stress_xz,
    slice_stress_xy,
    slice_plastic_strain ///< only in a body that may flow
  };

  /// A plane cut through one body below the contact: points at `position` x `depth`, index
  /// i depth.size() + j.
  ///
  /// Depth counts along the normal of the contact frame from the deformed surface into the body. The
  /// position is along the track from the axle, positive ahead, or the lateral coordinate s of the contact
  /// frame, positive to the track centre.
  struct Slice
  {
    std::string         name;         ///< "AA_rail", ...
    double              offset   = 0; ///< of the plane: s of a longitudinal one, along of a lateral one [m]
    bool                unloaded = false; ///< the wheel's own stress has faded: stresses are residual ones
    std::vector<double> position;         ///< [m]
    std::vector<double> depth;            ///< [m]
    /// Von Mises stress, xx, yy, zz, yz, xz, xy of the stress [Pa], and the accumulated plastic strain [1] of
    /// a body that may flow, see SliceField; NaN outside of the body.
    std::vector<std::vector<double>> values;
    /// du_Z over the path along the outward normal of the contact frame, in slices of an unloaded body that
    /// were given for it: the plastic shear that goes forward at the surface [1].
    std::vector<double> forward_shear;
  };

  /// Adds slices as the next tick of a file: one group per slice with the attributes of its plane,
  /// `position`, `depth` and the fields as datasets with the attribute `unit`. To be called on one rank.
  void
  append_slices(TickFile &file, double time, double travelled, const std::vector<Slice> &slices);
} // namespace wheelrail
