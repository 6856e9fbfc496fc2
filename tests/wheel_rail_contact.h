#pragma once

// S1002 on 54E1 at shift 0 as a half-space problem, in the contact frame in which CONTACT solved it.

#include <wheelrail/geometry/contact_geometry.h>
#include <wheelrail/halfspace/problem.h>

#include <algorithm>
#include <cmath>

namespace test
{
  /// Steady rolling at 100 kN vertical load on elements of dx x dx [m]: body 1 is the rail (x forwards, y to
  /// the track centre, n down), spin as CONTACT found it, `fx` [N] on the rail. The frame is CONTACT's: its
  /// origin and angle are those of the row of contact_wheel_rail_54E1.csv.
  inline wheelrail::HalfspaceProblem
  wheel_rail_contact(const double dx, const double fx, const double spin)
  {
    using namespace wheelrail;
    const RailProfile     rail  = rail_profile("54E1");
    const WheelProfile    wheel = wheel_profile("S1002");
    const ContactGeometry c     = find_contact(rail, wheel, TrackDimensions(), {0, RollMode::none});
    ContactFrame          frame;
    frame.origin = {4.2698e-3, -0.3191e-3};
    frame.angle  = -0.0509;
    const FrameProfile rail_profile(rail.head, c.rail, frame), wheel_profile(wheel.tread, c.wheel, frame);
    double             lowest = 1;
    for (double s = 3e-3; s < 6e-3; s += 1e-6)
      lowest = std::min(lowest, undeformed_distance(wheel_profile, rail_profile, s));

    HalfspaceProblem problem;
    const int        nx = int(std::round(8e-3 / dx)), y0 = int(std::round(-13.5e-3 / dx)),
              y1                     = int(std::round(9e-3 / dx));
    problem.grid                     = {2 * nx + 1, y1 - y0 + 1, dx, dx, -nx * dx, y0 * dx};
    problem.undeformed_distance      = sampled_distance(problem.grid, [&](const double x, const double s) {
      // The tread rises by x^2 / (2 r) vertically; at fixed s the distance along n follows from its slope.
      const auto   w     = wheel_profile.at(s);
      const double angle = std::atan(w.slope), r = c.axle.y - frame.to_track({s, w.n}).y;
      return undeformed_distance(wheel_profile, rail_profile, s) - lowest +
             x * x / (2 * r) * std::cos(angle + frame.angle) / std::cos(angle);
    });
    problem.normal_force             = 99920;
    problem.longitudinal_force_given = true;
    problem.fx                       = fx;
    problem.phi                      = spin;
    return problem;
  }
} // namespace test
