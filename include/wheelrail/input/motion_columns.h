#pragma once

#include <wheelrail/base/quantity.h>
#include <wheelrail/input/motion_file.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// A column that a table of rows may have.
  struct MotionColumn
  {
    MotionQuantity quantity;
    const char    *name;
    Dimension      dimension;
    double         least, most; ///< accepted [SI]
    const char    *range;       ///< the same in words
  };
  using MotionColumns = std::vector<MotionColumn>;

  /// Of a vehicle simulation.
  const MotionColumns &
  motion_columns();

  /// Of kinds of traffic.
  const MotionColumns &
  mix_columns();

  /// Of wheels that pass one after the other.
  const MotionColumns &
  passage_columns();

  /// Of the points of a creep curve.
  const MotionColumns &
  curve_columns();

  /// Of a receptance over frequency.
  const MotionColumns &
  receptance_columns();

  /// SI value of one of the unit of a column; throws InputError for a unit of something else.
  double
  unit_factor(const MotionColumn &column, const std::string &unit);
} // namespace wheelrail
