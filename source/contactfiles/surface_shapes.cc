#include <wheelrail/base/errors.h>
#include <wheelrail/contactfiles/surface_shapes.h>
#include <wheelrail/sections/slices_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace wheelrail
{
  RailShape::RailShape(const ContactCase &one)
    : points_(is_slices_file(one.track.profile.file) ? std::vector<Point2>()
                                                     : section_points(one.track.profile, false))
    , radius_(one.digits.side >= 4 ? millimetre * one.track.roller_radius : 0)
    , along_(millimetre * one.wheelset.position[0])
    , slices_(points_.empty() ? contact_slices(one.track.profile, false) : nullptr)
    , middle_(slices_ ? section_at(*slices_, along_) : ProfileLine(points_, one.track.profile.file))
  {
  }


  std::optional<ProfileLine>
  RailShape::at(const double x) const
  {
    if (!varies())
      return middle_;
    if (slices_)
      {
        const SectionColumn column = slices_->column(along_ + x);
        if (column.empty())
          return {};
        return section_at(*slices_, along_ + x);
      }
    std::vector<Point2> points;
    for (const Point2 &p : points_)
      {
        // around the axle at z = R: (R - z)^2 of the section = x^2 + (R - z)^2
        const double out = (radius_ - p.y) * (radius_ - p.y) - x * x;
        if (out > 0)
          points.push_back({p.x, radius_ - std::sqrt(out)});
      }
    if (points.size() < 4)
      return {};
    return ProfileLine::straight(std::move(points)); // as in CONTACT, between the points of the profile
  }


  WheelShape::WheelShape(const ContactCase &one)
    : line_(is_slices_file(one.wheelset.profile.file) ? ProfileLine()
                                                      : section_line(one.wheelset.profile, true))
  {
    if (!is_slices_file(one.wheelset.profile.file))
      return;
    const auto   slices = contact_slices(one.wheelset.profile, true);
    const double pitch  = one.wheelset.position[5] + one.wheelset.flexible[5];
    const int    half   = int(std::ceil(0.2 * one.wheelset.radius / std::min(one.elements.dx, 1.)));
    step_               = 0.2 / half;
    for (int k = -half; k <= half; ++k)
      {
        // the wheel has turned by the pitch; around it sections begin anew
        const double angle = std::remainder(k * step_ - pitch, 2 * M_PI);
        columns_.push_back(section_at(*slices, angle, true));
        if (columns_.back().end() != columns_.front().end())
          throw InputError(slices->path() +
                           ": parts of the wheel begin or end between slices; all need the same");
      }
  }


  ProfileLine::Place
  WheelShape::at(const double ahead, const double t) const
  {
    if (!out_of_round())
      return line_.at(t);
    // a cubic through the four columns around the angle (Lagrange)
    const std::size_t below = columns_.size() / 2; // the axle
    const double      place = std::clamp(ahead / step_ + double(below), 0., double(columns_.size() - 1));
    const auto        first = std::size_t(std::clamp(std::floor(place) - 1, 0., double(columns_.size() - 4)));
    const double      u     = place - double(first);
    const std::array<double, 4> weight{{-(u - 1) * (u - 2) * (u - 3) / 6,
                                        u * (u - 2) * (u - 3) / 2,
                                        -u * (u - 1) * (u - 3) / 2,
                                        u * (u - 1) * (u - 2) / 6}};
    ProfileLine::Place          sum;
    for (std::size_t k = 0; k < 4; ++k)
      {
        const ProfileLine::Place p = columns_[first + k].at(t);
        sum.y += weight[k] * p.y;
        sum.z += weight[k] * p.z;
        sum.dy += weight[k] * p.dy;
        sum.dz += weight[k] * p.dz;
      }
    return sum;
  }


  std::optional<Vector3>
  wheel_point(const WheelShape  &wheel,
              const RigidMotion &to_track,
              const double       radius,
              const double       x,
              const double       t)
  {
    const Vector3 &row   = to_track.rows[0];
    double         angle = 0;
    for (int step = 0; step < (wheel.out_of_round() ? 4 : 1); ++step)
      {
        const ProfileLine::Place p       = wheel.at(angle, t);
        const double             rho     = radius + p.z;
        const double             largest = rho * std::hypot(row[0], row[2]);
        // x = row . (rho sin, y, rho cos - R) + move
        const double c = x - to_track.move[0] - row[1] * p.y + row[2] * radius;
        if (std::abs(c) >= largest)
          return {};
        angle = std::asin(c / largest) - std::atan2(row[2], row[0]);
      }
    const ProfileLine::Place p   = wheel.at(angle, t);
    const double             rho = radius + p.z;
    return to_track({rho * std::sin(angle), p.y, rho * std::cos(angle) - radius});
  }
} // namespace wheelrail
