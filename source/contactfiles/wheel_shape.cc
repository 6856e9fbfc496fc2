#include <wheelrail/base/errors.h>
#include <wheelrail/contactfiles/section_line.h>
#include <wheelrail/contactfiles/wheel_shape.h>
#include <wheelrail/profiles/slices_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace wheelrail
{
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
