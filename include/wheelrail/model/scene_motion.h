#pragma once

#include <wheelrail/base/smooth_curve.h>
#include <wheelrail/input/motion_file.h>
#include <wheelrail/mesh/sweep_plan.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/wheelset/guided_path.h>

#include <map>
#include <vector>

namespace wheelrail
{
  /// What the columns of Wheelset/Motion say over the path rolled since the start of the run, as smooth
  /// curves through the rows (SmoothCurve), so that velocities of the wheelset are continuous, and a load
  /// that comes down to zero does not fall below. Rows over time count at the path that the velocities cover,
  /// with the mean of neighbouring rows between them.
  class SceneMotion
  {
  public:
    /// Reads the file of the scene. Throws InputError when it cannot be read, when the run leaves it, has no
    /// load where it starts, or passes several times, when the wheelset would be accelerated by more than
    /// some 1000 g, or time, distance and velocity say different things.
    explicit SceneMotion(const Scene &scene);

    /// The scene at a place of its path [m]: columns in the place of its entries, the lateral creepage
    /// from the change of the lateral shift. A torque is not an entry, see torque().
    Scene
    at(double rolled) const;

    /// Time that the path takes [s].
    double
    duration(double rolled) const;

    /// Whether the file has the column.
    bool
    has(MotionQuantity quantity) const
    {
      return curves_.count(quantity) > 0;
    }

    /// A column over the path [SI], or the constant that the scene has in its place.
    SmoothCurve
    curve(MotionQuantity quantity, double constant) const
    {
      return has(quantity) ? curves_.at(quantity) : SmoothCurve(constant);
    }

    /// A column at a place of the path [SI]; it must be there.
    double
    value(MotionQuantity quantity, double rolled) const
    {
      return curves_.at(quantity).at(rolled);
    }

    /// Lateral shift of the wheelset; without its column the one of the scene, drifting with the lateral
    /// creepage [m].
    const SmoothCurve &
    lateral_shift() const
    {
      return shift_;
    }

  private:
    std::vector<double>
    rows_along(const MotionFile &motion) const;
    void
    check(const MotionFile &motion, const std::vector<double> &along, double start) const;
    void
    check_times(const MotionFile &motion) const;
    void
    check_accelerations(const std::vector<double> &rolled) const;
    void
    make_shift(const MotionFile &motion, const std::vector<double> &rolled);

    Scene                                 scene_;
    std::map<MotionQuantity, SmoothCurve> curves_; ///< over the path rolled
    SmoothCurve                           shift_;
  };

  /// Time of a run [s].
  double
  run_duration(const Scene &scene);

  /// The scene at a place of its path [m]; without a motion the scene itself.
  Scene
  scene_on_path(const Scene &scene, double rolled);

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
