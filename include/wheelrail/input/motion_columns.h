#pragma once

#include <wheelrail/input/motion_file.h>
#include <wheelrail/tables/table.h>

#include <vector>

namespace wheelrail
{
  /// A column that a table of rows may have.
  struct MotionColumn
  {
    MotionQuantity quantity;
    TableColumn    as;
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
} // namespace wheelrail
