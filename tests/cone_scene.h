// A wheelset of cones, whose rolling follows from kinematics.

#pragma once

#include <wheelrail/vehicle/axle_contact.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

namespace test
{
  using namespace wheelrail;

  constexpr double conicity = 0.05, crown = 300; // [1], [mm]

  /// A line for each place from `begin` to `end` [mm].
  inline void
  write_shape(const std::string &path, const double begin, const double end, double (*height)(double))
  {
    std::ofstream file(path);
    file << "# lateral, height [mm]\n";
    char line[80];
    for (double x = begin; x <= end + 1e-9; x += 0.2)
      {
        std::snprintf(line, sizeof(line), "%.3f %.9f\n", x, height(x));
        file << line;
      }
  }

  /// Cones with a flange on heads of one radius.
  inline Scene
  cones()
  {
    write_shape("axle_cone.txt", -69.4, 60, [](const double x) {
      const double off = (x + 56) / 9;
      return conicity * x - 28 * std::exp(-off * off);
    });
    write_shape("axle_head.txt", -36, 36, [](const double x) {
      const double beyond = std::max(0., std::abs(x) - 27);
      return -x * x / (2 * crown) - 0.25 * beyond * beyond;
    });
    Scene scene;
    scene.wheel_profile          = "axle_cone.txt";
    scene.rail_profile           = "axle_head.txt";
    scene.track.inclination      = 0;
    scene.wheel_load             = 80e3;
    scene.halfspace_element_size = 0.8e-3;
    return scene;
  }

  /// The right-hand or the left-hand wheel of a scene under its load [N].
  inline WheelOnAxle
  wheel_of(const Scene &scene, const bool left, const double load)
  {
    Scene at      = scene;
    at.left_wheel = left;
    at.wheel_load = load;
    return {at, make_geometry(at), load};
  }
} // namespace test
