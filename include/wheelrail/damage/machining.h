#pragma once

#include <wheelrail/damage/worn_shape.h>

#include <vector>

namespace wheelrail
{
  /// What grinding or turning takes off a shape.
  struct Machining
  {
    std::vector<double> sections;    ///< at the points of the shape [m2], for take_off()
    double              depth   = 0; ///< largest, along the normals [m]
    double              section = 0; ///< all together [m2]
    double              shift   = 0; ///< of the target into the steel, vertically [m]
  };

  /// What has to be taken off a shape until it has the form of a target: the target is moved vertically to
  /// where the least steel has to go, with no place of it outside the steel but on flanks steeper than
  /// `steepest` [rad against the horizontal]. There steel that is missing stays missing.
  Machining
  machining(const WornShape &shape, const std::vector<Point2> &target, double steepest);
} // namespace wheelrail
