#include <wheelrail/contactfiles/patch_solver.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// The patch seen in a mirror along the track.
    void
    mirror(WheelRailPatch &patch)
    {
      HalfspaceSolution &s = patch.solution;
      s.grid.y0            = -s.grid.y(s.grid.my - 1);
      const auto turn_rows = [&](auto &field) {
        for (int j = 0; field.size() == std::size_t(s.grid.size()) && j < s.grid.my / 2; ++j)
          std::swap_ranges(field.begin() + s.grid.mx * j,
                           field.begin() + s.grid.mx * (j + 1),
                           field.begin() + s.grid.mx * (s.grid.my - 1 - j));
      };
      for (auto *field : {&s.pressure,
                          &s.traction_x,
                          &s.traction_y,
                          &s.displacement_n,
                          &s.displacement_x,
                          &s.displacement_y,
                          &s.gap,
                          &s.slip_x,
                          &s.slip_y,
                          &s.friction,
                          &s.yield_stress,
                          &s.plastic_x,
                          &s.plastic_y,
                          &s.temperature[0],
                          &s.temperature[1]})
        turn_rows(*field);
      turn_rows(s.state);
      for (auto *field : {&s.traction_y, &s.displacement_y, &s.slip_y, &s.plastic_y})
        for (double &value : *field)
          value = -value;
      for (double *value : {&s.fy,
                            &s.eta,
                            &s.phi,
                            &s.spin_moment,
                            &patch.angle,
                            &patch.lateral_creepage,
                            &patch.spin,
                            &patch.origin_y,
                            &patch.lateral_force,
                            &patch.spin_moment})
        *value = -*value;
      for (Vector3 *vector :
           {&patch.in_track, &patch.on_rail, &patch.on_wheel, &patch.force_track, &patch.force_wheelset})
        (*vector)[1] = -(*vector)[1];
      for (Vector3 *moment : {&patch.moment_rail, &patch.moment_wheelset})
        *moment = {-(*moment)[0], (*moment)[1], -(*moment)[2]};
      std::swap(patch.y_low, patch.y_high);
      patch.y_low  = -patch.y_low;
      patch.y_high = -patch.y_high;
    }
  } // namespace


  void
  mirror(WheelRailCase &result)
  {
    for (WheelRailPatch &patch : result.patches)
      mirror(patch);
    for (Vector3 *force : {&result.force_track, &result.force_wheelset})
      (*force)[1] = -(*force)[1];
  }
} // namespace wheelrail
