#include <wheelrail/geometry/wheel_pose.h>

#include <cmath>

namespace wheelrail
{
  Vector3
  WheelPose::position(const double x, const double radius, const double angle) const
  {
    const Point2 foot = section.to_track({x, nominal_radius - radius * std::cos(angle)});
    return motion({foot.x, foot.y, radius * std::sin(angle)});
  }


  double
  WheelPose::angle(const Vector3 &X) const
  {
    const Vector3 straight = motion.back(X);
    return std::atan2(straight[2], nominal_radius - section.to_section({straight[0], straight[1]}).y);
  }


  Point2
  WheelPose::on_section(const Vector3 &X) const
  {
    const Vector3 straight = motion.back(X);
    const Point2  own      = section.to_section({straight[0], straight[1]});
    const double  down     = nominal_radius - own.y;
    const double  radius   = std::sqrt(down * down + straight[2] * straight[2]);
    return section.to_track({own.x, nominal_radius - radius});
  }


  Vector3
  WheelPose::centre() const
  {
    const Point2 middle = section.to_track({0, nominal_radius});
    return motion({middle.x, middle.y, 0});
  }


  Vector3
  WheelPose::axis() const
  {
    return motion.turned({std::cos(section.angle), std::sin(section.angle), 0});
  }


  Vector3
  WheelPose::rolling(const Vector3 &X) const
  {
    const Vector3 straight = motion.back(X);
    const double  down     = nominal_radius - section.to_section({straight[0], straight[1]}).y;
    return motion.turned(
      {straight[2] * std::sin(section.angle), -straight[2] * std::cos(section.angle), -down});
  }
} // namespace wheelrail
