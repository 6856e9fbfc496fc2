#pragma once

#include <wheelrail/damage/worn_shape.h>
#include <wheelrail/model/scene_geometry.h>

#include <string>

namespace wheelrail
{
  /// The running surfaces of profiles with a point each 0.25 mm: of the rail down to 30 mm below its top, of
  /// the wheel all.
  WornShape
  rail_shape(const RailProfile &rail);
  WornShape
  wheel_shape(const WheelProfile &wheel);

  /// Points as a table of two columns, which Profiles/Rail and Profiles/Wheel take [mm], with the worn depth
  /// [mm] and the damage behind them; `what` is its heading.
  std::string
  shape_as_text(const WornShape &shape, const std::string &what);

  /// Profiles through the points of both shapes. Throws InputError where no profile follows.
  SceneProfiles
  profiles_of(const WornShape &rail, const WornShape &wheel, const Scene &scene);

  /// What wear limits are set for. Wheel (EN 15313): flange height Sh from the tread at the running circle
  /// down to the tip, flange thickness Sd from the flange back to the flange face 10 mm below that tread,
  /// flange gradient qR, across, from there to the face 2 mm above the tip [m]. Rail: what the top at the
  /// axis has lost, and the gauge face 14 mm below the new top [m].
  struct WornDimensions
  {
    double flange_height = 0, flange_thickness = 0, flange_gradient = 0;
    double rail_height = 0, rail_side = 0;
  };
  WornDimensions
  worn_dimensions(const WornShape &new_rail, const WornShape &rail, const WornShape &wheel);
} // namespace wheelrail
