#pragma once

#include <wheelrail/model/model.h>
#include <wheelrail/output/tick_file.h>
#include <wheelrail/solid/stress_recovery.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Deepest point of a slice [m]: deep enough for the stresses of a patch of some 20 mm.
  constexpr double depth_of_slices = 15e-3;

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
    /// a body that may flow; NaN outside of the body.
    std::vector<std::vector<double>> values;
    /// du_Z over the way along the outward normal of the contact frame, in slices of an unloaded body that
    /// were asked for it: the plastic shear that goes forward at the surface [1].
    std::vector<double> forward_shear;
  };

  /// The cuts of Ma, Markine, Mashal and Ren (2017), figures 7 to 31, through rail and wheel: AA,
  /// longitudinal-vertical, and BB, lateral-vertical, both through the first contact point; and the same two
  /// through the node of the largest pressure (AA_peak, BB_peak). Of a rail that may yield, when enough of it
  /// was rolled, also the unloaded part behind the wheel: AA_behind through the lateral place of the largest
  /// pressure from the start to unloaded_distance() behind the axle, BB_behind at its end. Their depth counts
  /// from the undeformed surface.
  ///
  /// Stresses are Cauchy's in the axes X, Y, Z of the track, interpolated in the cells from the nodal means;
  /// the plastic strain is that of the cell. `nodal`: see nodal_stress(). Collective; the same on all ranks.
  std::vector<Slice>
  make_slices(const Model &model, const NodalStress &nodal, double travelled, MPI_Comm communicator);

  /// The cuts AA_behind and BB_behind of make_slices() through the lateral place of the largest pressure, of
  /// the rail that the wheel left at least `behind` [m] behind: none when that is less than two stations.
  /// `forward`, where given, is one number a node, Slice::forward_shear.
  std::vector<Slice>
  slices_behind(const Model               &model,
                const NodalStress         &nodal,
                double                     travelled,
                double                     behind,
                MPI_Comm                   communicator,
                const std::vector<double> *forward = nullptr);

  /// Adds slices as the next tick of a file: one group per slice with the attributes of its plane,
  /// `position`, `depth` and the fields as datasets with the attribute `unit`. To be called on one rank.
  void
  append_slices(TickFile &file, double time, double travelled, const std::vector<Slice> &slices);
} // namespace wheelrail
