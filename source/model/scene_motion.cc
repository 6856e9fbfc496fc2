#include <wheelrail/base/errors.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/model/scene_motion.h>

#include <cmath>
#include <cstddef>

namespace wheelrail
{
  namespace
  {
    using Q = MotionQuantity;
  } // namespace


  SceneMotion::SceneMotion(const Scene &scene)
    : scene_(scene)
  {
    const MotionFile    motion = of_wheel(read_motion_file(scene.motion), scene.left_wheel);
    std::vector<double> along  = rows_along(motion);
    const double        start  = std::isfinite(scene.motion_start) ? scene.motion_start : along.front();
    check(motion, along, start);
    for (double &place : along)
      place -= start;
    for (std::size_t k = 0; k < motion.quantities.size(); ++k)
      // a run rolls straight on, without the curve of the rows
      if (const Q of = motion.quantities[k]; of != Q::time && of != Q::distance && of != Q::radius)
        curves_.emplace(motion.quantities[k], SmoothCurve(along, motion.columns[k]));
    make_shift(motion, along);
    check_accelerations(along);
    if (has(Q::load) && !(value(Q::load, 0) > 0))
      throw InputError(entry_text(scene, "Wheelset", "Motion start") +
                       ": without a load there is no contact; "
                       "start where " +
                       scene.motion + " has one");
  }


  std::vector<double>
  SceneMotion::rows_along(const MotionFile &motion) const
  {
    if (const auto *const distance = motion.find(Q::distance))
      return *distance;
    const std::vector<double> &time       = *motion.find(Q::time);
    const auto *const          velocities = motion.find(Q::velocity);
    std::vector<double>        along      = {0};
    for (std::size_t row = 1; row < time.size(); ++row)
      along.push_back(along.back() +
                      (time[row] - time[row - 1]) *
                        (velocities ? 0.5 * ((*velocities)[row] + (*velocities)[row - 1]) : scene_.velocity));
    return along;
  }


  void
  SceneMotion::make_shift(const MotionFile &motion, const std::vector<double> &rolled)
  {
    const auto *const drift = motion.find(Q::lateral_creepage);
    if (has(Q::lateral_shift))
      shift_ = curves_.at(Q::lateral_shift);
    else if (!drift)
      {
        const double end = rolled.back();
        shift_ =
          SmoothCurve({0, end}, {scene_.lateral_shift, scene_.lateral_shift + scene_.lateral_creepage * end});
      }
    else
      {
        std::vector<double> shift = {0};
        for (std::size_t row = 1; row < rolled.size(); ++row)
          shift.push_back(shift.back() +
                          0.5 * ((*drift)[row] + (*drift)[row - 1]) * (rolled[row] - rolled[row - 1]));
        const double at_start = SmoothCurve(rolled, shift).at(0);
        for (double &place : shift)
          place += scene_.lateral_shift - at_start;
        shift_ = SmoothCurve(rolled, shift);
      }
  }


  Scene
  SceneMotion::at(const double rolled) const
  {
    Scene      scene = scene_;
    const auto set   = [&](const Q quantity, double &entry) {
      if (!has(quantity))
        return false;
      entry = value(quantity, rolled);
      return true;
    };
    scene.lateral_shift    = shift_.at(rolled);
    scene.lateral_creepage = shift_.slope(rolled);
    if (set(Q::roll, scene.roll_angle))
      scene.roll = RollMode::given;
    set(Q::yaw, scene.yaw);
    set(Q::load, scene.wheel_load);
    set(Q::velocity, scene.velocity);
    if (has(Q::torque) || set(Q::traction, scene.traction_coefficient))
      scene.drive = Drive::torque;
    if (set(Q::creepage, scene.creepage))
      scene.drive = Drive::rate;
    return scene;
  }


  double
  SceneMotion::duration(const double rolled) const
  {
    if (!has(Q::velocity))
      return rolled / scene_.velocity;
    // Simpson's rule; velocities change little over the path of a run
    constexpr int parts = 200;
    double        sum   = 0;
    for (int k = 0; k <= parts; ++k)
      sum += (k == 0 || k == parts ? 1 : k % 2 == 1 ? 4 : 2) / value(Q::velocity, rolled * k / parts);
    return rolled / parts / 3 * sum;
  }


  double
  run_duration(const Scene &scene)
  {
    return scene.motion == "none" ? scene.path() / scene.velocity : SceneMotion(scene).duration(scene.path());
  }


  Scene
  scene_on_path(const Scene &scene, const double rolled)
  {
    return scene.motion == "none" ? scene : SceneMotion(scene).at(rolled);
  }
} // namespace wheelrail
