#pragma once

#include <wheelrail/base/smooth_curve.h>
#include <wheelrail/input/motion_file.h>
#include <wheelrail/scene/scene.h>

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
} // namespace wheelrail
