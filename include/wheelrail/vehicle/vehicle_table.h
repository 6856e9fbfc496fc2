#pragma once

#include <wheelrail/input/motion_file.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/vehicle/vehicle.h>
#include <wheelrail/verdict/verdict.h>

namespace wheelrail
{
  /// That of its figures; a row without figures is not trusted.
  Grade
  grade_of_row(const VehicleWheel &wheel, std::size_t row);

  /// A column of each quantity that the rows give ("given_..."), then the figures of each wheel ("right_...",
  /// "left_..."), of each of its patches, its verdict, and the figures of the axle; a line a row.
  FigureTable
  vehicle_table(const MotionFile &motion, const VehicleResult &vehicle);
} // namespace wheelrail
