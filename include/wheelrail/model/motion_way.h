#pragma once

#include <wheelrail/mesh/sweep_plan.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/wheelset/guided_way.h>

#include <vector>

namespace wheelrail
{
  /// The rigid contact at a place of the way of a run that follows a motion.
  struct WaySample
  {
    double        rolled = 0; ///< since the start [m]
    Scene         scene;
    SceneGeometry geometry;
  };

  /// Samples over the whole way, each 5 mm and at most 60; none without a motion. Throws InputError where
  /// wheel and rail do not touch.
  std::vector<WaySample>
  sample_way(const Scene &scene, const SceneGeometry &geometry);

  /// Adds to the sizes of a sweep plan where the patches of the samples come to lie on both surfaces of the
  /// start, besides that of the start.
  void
  plan_for_way(const SceneGeometry &start, const std::vector<WaySample> &samples, SweepSizes &sizes);

  /// What leads the wheelset. `wheel_load`: where the motion has none [N].
  GuidedWay
  make_way(const Scene &scene, const std::vector<WaySample> &samples, double wheel_load);

  /// The torque that drives a wheel with a force along the wheelset [N m]: with yaw the vertical force has
  /// an arm, too, since it acts ahead of the axle or behind it.
  double
  drive_torque(const ContactGeometry &geometry, double driving, double vertical);
} // namespace wheelrail
