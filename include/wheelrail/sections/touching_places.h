#pragma once

#include <wheelrail/sections/posed_wheel.h>
#include <wheelrail/sections/sections_surface.h>

#include <cstddef>
#include <vector>

namespace wheelrail
{
  /// A place where a rigid wheel touches the surface of a rail, or nearly: a local minimum of the vertical
  /// gap.
  struct TouchingPlace
  {
    std::size_t rail   = 0;      ///< number of the surface
    double      line   = 0;      ///< of the surface, also between two
    double      height = 0;      ///< of the wheel at which it touches here [m]
    double      gap    = 0;      ///< vertical, when the wheel touches where it first does [m]
    Vector3     place{};         ///< on the rail, Z from the middle of the wheelset [m]
    Vector3     normal{};        ///< out of the rail
    double      angle = 0;       ///< contact angle, positive when the tangent falls to the gauge side [rad]
    double      slope = 0;       ///< of the surface along the track, positive rising
    double      ahead = 0;       ///< of the axle [m]
    PosedWheel::OnSection wheel; ///< place on the wheel
    bool                  at_end = false; ///< at the edge of a rail, where there is no common tangent
  };

  /// Unit vector out of a rail at a point of its section; `along` none: as if the section did not change.
  Vector3
  rail_normal(const SectionColumn::Point &point, bool along = true);

  /// All places at which the gap of the wheel, its wheelset at the place `at` of the track [m], has a local
  /// minimum with a height of touch no more than `within` [m] below the first; the first touch comes first.
  /// Searched coarsely up to a fifth of the wheel radius ahead and behind, then each minimum is refined.
  /// Throws InputError where wheel and rails do not touch at all.
  std::vector<TouchingPlace>
  touching_places(const std::vector<SectionsSurface> &rails,
                  const PosedWheel                   &wheel,
                  double                              at,
                  double                              within = 1e-3);
} // namespace wheelrail
