#pragma once

// The wheel and the rail of the Manchester contact benchmark.

#include <wheelrail/scene/scene.h>

#include <string>

namespace test
{
  /// A scene with the profiles and the track of the benchmark.
  inline wheelrail::Scene
  manchester_scene()
  {
    const std::string profiles = std::string(WHEELRAIL_TEST_DIR) + "/profiles/manchester_";
    wheelrail::Scene  scene;
    scene.wheel_profile     = profiles + "S1002.txt";
    scene.rail_profile      = profiles + "UIC60.txt";
    scene.track.inclination = 0;            // the file has it
    scene.track.gauge       = 1435.0022e-3; // puts the file's origin 760.5326 mm from the middle
    return scene;
  }
} // namespace test
