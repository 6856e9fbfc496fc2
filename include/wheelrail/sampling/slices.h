#pragma once

#include <wheelrail/model/model.h>
#include <wheelrail/output/slice_file.h>
#include <wheelrail/solid/stress_recovery.h>

#include <vector>

namespace wheelrail
{
  /// Deepest point of a slice [m]: deep enough for the stresses of a patch of some 20 mm.
  constexpr double depth_of_slices = 15e-3;

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
} // namespace wheelrail
