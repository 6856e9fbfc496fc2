#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/model/scene_motion.h>

#include <algorithm>
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


  namespace
  {
    void
    widen(Range &range, const double value)
    {
      range.s0 = std::min(range.s0, value);
      range.s1 = std::max(range.s1, value);
    }

    /// Where the place s of a sample lies across both surfaces of the start [m].
    void
    widen_across(const SceneGeometry &start, const SceneGeometry &there, const double s, Range &across)
    {
      const ContactGeometry    &now   = there.contact;
      const FrameProfile::Value wheel = there.wheel_heights().at(s);
      const Point2              rail  = now.frame.to_track({s, there.rail_heights().at(s).n});
      widen(across, start.contact.frame.to_frame(rail).x);

      const Point2 outline = now.frame.to_track({s, wheel.n});
      const double along =
        now.axis.surface_point(outline, now.frame.angle + std::atan(wheel.slope)).along - now.along;
      const Point2 section = now.wheel.to_section(now.pose.on_section({outline.x, outline.y, along}));
      widen(across, start.contact.tread_frame.to_frame(start.contact.wheel.to_track(section)).x);
    }
  } // namespace


  double
  drive_torque(const ContactGeometry &geometry, const double driving, const double vertical)
  {
    const double ahead = geometry.ahead, radius = geometry.rolling_radius;
    return driving * std::sqrt(radius * radius - ahead * ahead) + vertical * ahead;
  }


  std::vector<PathSample>
  sample_path(const Scene &scene, const SceneGeometry &geometry)
  {
    constexpr double        spacing = 5e-3, most = 60;
    std::vector<PathSample> samples;
    if (scene.motion == "none")
      return samples;
    const SceneMotion motion(scene);
    const double      distance = scene.mesh_distance();
    const int         parts    = static_cast<int>(std::clamp(std::ceil(distance / spacing), 2., most));
    for (int k = 0; k <= parts; ++k)
      {
        const double rolled = distance * k / parts;
        const Scene  at     = motion.at(rolled);
        try
          {
            samples.push_back(
              {rolled, at, make_geometry(at, {geometry.rail, geometry.wheel, {}, geometry.files})});
          }
        catch (const InputError &error)
          {
            throw InputError("Wheelset/Motion = " + scene.motion + ", " + in_mm(rolled) +
                             " rolled: " + error.what());
          }
      }
    return samples;
  }


  void
  plan_for_path(const SceneGeometry &start, const std::vector<PathSample> &samples, SweepSizes &sizes)
  {
    for (const PathSample &sample : samples)
      {
        const SceneGeometry &there = sample.geometry;
        for (const Range &part :
             interpenetration(there.wheel_heights(), there.rail_heights(), sizes.approach))
          for (const double s : {part.s0, part.s1})
            widen_across(start, there, s, sizes.across);
        const Range overlap = overlap_along(there, sizes.approach, sizes.fine_margin);
        widen(sizes.along, overlap.s0);
        widen(sizes.along, overlap.s1);
        widen(sizes.ahead, there.contact.along - start.contact.along);
        widen(sizes.ahead, there.contact.ahead - start.contact.ahead);
      }
  }


  GuidedPath
  make_path(const Scene &scene, const std::vector<PathSample> &samples, const double wheel_load)
  {
    using Q = MotionQuantity;
    const SceneMotion motion(scene);
    const auto        sampled = [&](const auto &of) {
      std::vector<double> rolled, values;
      for (const PathSample &sample : samples)
        {
          rolled.push_back(sample.rolled);
          values.push_back(of(sample));
        }
      return SmoothCurve(rolled, values);
    };
    const auto seen = [&](const SmoothCurve &curve) { return scene.left_wheel ? curve.mirrored() : curve; };
    const auto load = [&](const PathSample &sample) {
      return motion.has(Q::load) ? sample.scene.wheel_load : wheel_load;
    };
    GuidedPath path;
    path.half_width    = running_circle_distance(scene.track);
    path.lateral_shift = seen(motion.lateral_shift());
    path.roll          = motion.has(Q::roll)
                           ? seen(motion.curve(Q::roll, 0))
                           : sampled([](const PathSample &sample) { return sample.geometry.contact.roll; });
    path.yaw           = seen(motion.curve(Q::yaw, scene.yaw));
    path.velocity      = motion.curve(Q::velocity, scene.velocity);
    path.load          = motion.curve(Q::load, wheel_load);
    path.torque        = sampled([&](const PathSample &sample) {
      const ContactGeometry &contact = sample.geometry.contact;
      const double           driving = motion.has(Q::torque)
                                                ? motion.value(Q::torque, sample.rolled) / contact.rolling_radius
                                                : sample.scene.traction_coefficient * load(sample);
      return drive_torque(contact, driving, load(sample));
    });
    path.pitch_rate    = sampled([](const PathSample &sample) {
      return sample.scene.velocity / sample.geometry.contact.forward_radius * (1 + sample.scene.creepage);
    });
    path.contact_along = sampled([](const PathSample &sample) { return sample.geometry.contact.along; });
    path.contact_ahead = sampled([](const PathSample &sample) { return sample.geometry.contact.ahead; });
    path.forward_radius =
      sampled([](const PathSample &sample) { return sample.geometry.contact.forward_radius; });
    return path;
  }
} // namespace wheelrail
