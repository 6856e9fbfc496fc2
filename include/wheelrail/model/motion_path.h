#pragma once

#include <wheelrail/mesh/sweep_plan.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/wheelset/guided_path.h>

#include <vector>

namespace wheelrail
{
  /// The rigid contact at a place of the path of a run that follows a motion.
  struct PathSample
  {
    double        rolled = 0; ///< since the start [m]
    Scene         scene;
    SceneGeometry geometry;
  };

  /// Samples over the whole path, each 5 mm and at most 60; none without a motion. Throws InputError where
  /// wheel and rail do not touch.
  std::vector<PathSample>
  sample_path(const Scene &scene, const SceneGeometry &geometry);

  /// Adds to the sizes of a sweep plan where the patches of the samples come to lie on both surfaces of the
  /// start, besides that of the start.
  void
  plan_for_path(const SceneGeometry &start, const std::vector<PathSample> &samples, SweepSizes &sizes);

  /// What leads the wheelset. `wheel_load`: where the motion has none [N].
  GuidedPath
  make_path(const Scene &scene, const std::vector<PathSample> &samples, double wheel_load);

  /// The torque that drives a wheel with a force along the wheelset [N m]: with yaw the vertical force has
  /// an arm, too, since it acts ahead of the axle or behind it.
  double
  drive_torque(const ContactGeometry &geometry, double driving, double vertical);
} // namespace wheelrail
