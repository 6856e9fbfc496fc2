#include <wheelrail/contactfiles/rail_shape.h>
#include <wheelrail/contactfiles/section_line.h>
#include <wheelrail/profiles/slices_file.h>

#include <cmath>
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
} // namespace wheelrail
