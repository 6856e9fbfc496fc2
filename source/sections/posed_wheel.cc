#include <wheelrail/geometry/wheel_outline.h>
#include <wheelrail/sections/posed_wheel.h>

#include <cmath>

namespace wheelrail
{
  namespace
  {
    constexpr double steepest = 5; ///< slope of the part of the tread and the flange that may touch
  }


  PosedWheel::PosedWheel(const WheelProfile &wheel, const TrackDimensions &track, const WheelsetPose &pose)
    : tread_(wheel.tread, Placement(), ContactFrame(), steepest)
    , nominal_radius_(track.nominal_radius)
  {
    const double    roll      = pose.roll == RollMode::given ? pose.roll_angle : 0;
    const Placement placement = place_wheel(track, pose.lateral_shift, roll, track.nominal_radius);
    const AxleLine  line      = axle_line(placement, track, pose.yaw);
    axis_                     = line.direction;
    centre_ = Vector3{line.middle.x, line.middle.y, 0} - running_circle_distance(track) * axis_;
  }


  std::optional<double>
  PosedWheel::distance(const Vector3 &P, const Vector3 &direction, const double height) const
  {
    const Vector3 d     = P - (centre_ + Vector3{0, height, 0});
    const double  rise  = dot(direction, axis_);
    const Vector3 slant = direction - rise * axis_;
    const double  at    = dot(d, axis_);
    const Vector3 out   = d - at * axis_;
    // first guess: the cylinder of the radius beside P
    const auto   first = tread_.at(at);
    const double a = dot(slant, slant), b = dot(out, slant), r0 = nominal_radius_ - first.n,
                 root = b * b - a * (dot(out, out) - r0 * r0);
    if (!(root > 0))
      return {};
    double t = (-b - std::sqrt(root)) / a;
    for (int round = 0; round < 20; ++round)
      {
        const double  s      = at + t * rise;
        const auto    tread  = tread_.at(s);
        const Vector3 q      = out + t * slant;
        const double  radius = norm(q), miss = nominal_radius_ - tread.n - radius;
        const double  change = miss / (-tread.slope * rise - dot(q, slant) / radius);
        t -= change;
        if (std::abs(change) < 1e-13)
          {
            const double end = at + t * rise;
            if (end < tread_.s_min() || end > tread_.s_max())
              return {};
            return t;
          }
      }
    return {};
  }


  double
  PosedWheel::ahead(const Vector3 &P) const
  {
    return dot(P - centre_, normalised(cross(axis_, {0, 1, 0})));
  }


  PosedWheel::OnSection
  PosedWheel::on_section(const Vector3 &P, const double height) const
  {
    const Vector3 d  = P - (centre_ + Vector3{0, height, 0});
    const double  at = dot(d, axis_);
    return {-at, norm(d - at * axis_)};
  }
} // namespace wheelrail
