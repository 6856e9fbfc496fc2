#pragma once

#include <wheelrail/output/fields.h>

namespace wheelrail
{
  /// The figures of one contact patch. Lengths and areas are those of the projection on the
  /// (along, s) plane of the contact frame. Forces are sums of the stored tractions, so they act
  /// on the rail; the force on the wheel has the opposite sign.
  struct PatchMeasures
  {
    double peak_pressure              = 0; ///< largest nodal value [Pa]: the main figure
    double peak_pressure_fitted       = 0; ///< top of the quadratic fitted to the 3 x 3 nodes around it [Pa]
    double area                       = 0; ///< inside the edge line, all separate patches together [m2]
    double width                      = 0; ///< lateral extent of the whole [m]
    double length                     = 0; ///< extent along the track of the whole [m]
    double centre_along               = 0; ///< middle of that extent [m]
    double centre_lateral             = 0;
    double centre_of_pressure_along   = 0; ///< position weighted with p A [m]
    double centre_of_pressure_lateral = 0;
    double max_traction         = 0; ///< largest shear traction, also between nodes [Pa], see largest_shear()
    double stick_fraction       = 0; ///< sticking part of the loaded tributary area [1], 0 without load
    double normal_force         = 0; ///< sum of p A [N]
    double traction_force_along = 0; ///< sum of traction_along A, on the rail [N]
    /// Work of friction for each metre rolled: the sum of traction times relative slip times A, which in
    /// steady rolling is the T-gamma of wear laws, spin included [N = J/m]; NaN for a patch without slip.
    double t_gamma = 0;

    /// Nodes across the highest pressure, along or across, whichever is less: how far it exceeds half the
    /// peak on the lines through it, over 0.866 (sqrt(3)/2), which is the chord of an ellipse with that peak.
    double cells_across = 0;

    /// How far the pressure between the nodes exceeds the largest nodal value, over it, on the lines of nodes
    /// along and across through it: modified Akima's curve (Boost), which edges beside the peak do not lift.
    double       between_nodes  = 0;
    unsigned int n_loaded       = 0;     ///< nodes with pressure
    unsigned int n_patches      = 0;     ///< separate patches, minus holes
    bool         touches_border = false; ///< loaded nodes on the rim of the grid: the patch is cut off
  };

  /// Measures a patch. A node counts as loaded when its pressure is above a thousandth of the
  /// largest.
  ///
  /// The edge is sought on every grid line between a loaded and an open node. It is the mean of two
  /// extrapolations, each exact to leading order at the edge of a smooth contact (Hertz, 1882): p^2
  /// falls to zero like a parabola on the inside (three nodes), gap^(2/3) rises linearly on the
  /// outside (two nodes). A straight line through the gap alone would put the edge 5 to 10 % of the
  /// area too far inside on cells of 1 mm, because the gap is a small -p/eps inside and opens like
  /// the power 3/2 outside. The area is that of the polygon through these points plus the segments
  /// that its chords cut off (see doc/theory/patch.md for the measured errors). Width and length use the
  /// outermost point of each grid line and the parabola through the three lines at the extreme.
  ///
  /// Throws RunError when a field has not n_along x n_lateral values. A patch without load gives
  /// zeros.
  PatchMeasures
  measure_patch(const PatchFields &patch);
} // namespace wheelrail
