#pragma once

namespace wheelrail
{
  /// Forces over creepages of an elliptic contact (Kalker 1967 for small ones; Vermeulen and Johnson 1964 up
  /// to sliding), good to some ten per cent: what small changes are judged by. [SI]
  struct CreepScale
  {
    double friction_bound = 0; ///< friction times normal force [N]
    double stiffness      = 0; ///< force over small creepage along the track, G a b C11 [N]
    double lateral        = 0; ///< and across it, G a b C22 [N]

    /// Creepage at half of the friction bound.
    double
    half_saturation() const;

    /// What is left of the stiffness at a longitudinal force, as its slope over that at small creepage: 0
    /// where the whole patch slides.
    double
    tangent(double force) const;
  };

  /// Of a patch with the extents `length` along the track and `width` across it, between bodies of the shear
  /// modulus G and Poisson's ratio near 0.3.
  CreepScale
  creep_scale(double friction_bound, double shear_modulus, double length, double width);
} // namespace wheelrail
