#pragma once

#include <wheelrail/scene/scene.h>
#include <wheelrail/sections/posed_wheel.h>
#include <wheelrail/sections/section_column.h>

#include <optional>
#include <vector>

namespace wheelrail
{
  /// Of places across the surface of a crossing [m].
  constexpr double crossing_spacing = 0.25e-3;

  /// The lowest line of the wheel over places across, running circle at the height 0 [m].
  struct WheelLine
  {
    std::vector<double> across, height;
  };

  /// That line around the running circle, as far as it is no steeper than a strip of fine cells may be.
  WheelLine
  wheel_line(const Scene &scene, const WheelProfile &profile);

  /// How far the wheel, lifted by `height`, lies above a point of a rail's section [m]: negative inside;
  /// nothing where it does not lie above.
  std::optional<double>
  above_section(const PosedWheel &wheel, const Point2 &p, const TrackDimensions &track, double height);

  /// Heights of a section over places across, and of lines that fall from its edges 1:1.
  std::vector<double>
  heights_of(const SectionColumn &column, const std::vector<double> &across);

  /// Width of a head 5 mm below its top [m].
  double
  width_of(const SectionColumn &column);
} // namespace wheelrail
