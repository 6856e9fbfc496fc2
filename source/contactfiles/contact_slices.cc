#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/contactfiles/contact_slices.h>
#include <wheelrail/profiles/slices_file.h>

#include <cmath>
#include <utility>
#include <vector>

namespace wheelrail
{
  std::shared_ptr<const SectionsSurface>
  contact_slices(const ContactProfile &profile, const bool wheel)
  {
    const bool in_metres = profile.scale == 1000;
    Slices slices = read_slices_file(profile.file, in_metres ? ProfileUnit::metre : ProfileUnit::millimetre);
    if (slices.wheel != wheel)
      throw InputError(profile.file + (wheel ? ": slices of a rail (.slcs) stand for a wheel"
                                             : ": slices of a wheel (.slcw) stand for a rail"));
    const double scale = in_metres ? 1 : profile.scale;
    for (Slices::Slice &slice : slices.slices)
      for (Point2 &p : slice.points)
        p = {(profile.mirror_y == 1 ? -1 : 1) * scale * p.x, (profile.mirror_z == 1 ? -1 : 1) * scale * p.y};
    return std::make_shared<const SectionsSurface>(slices, Placement{{0, 0}, 0}, 0, profile.file);
  }


  ProfileLine
  section_at(const SectionsSurface &slices, const double place, const bool wheel)
  {
    const SectionColumn column = slices.column(place);
    if (column.empty())
      throw InputError(slices.path() + ": nothing is at " +
                       (wheel ? text("%.4g degrees", place * 180 / M_PI) : text("%g mm", 1e3 * place)));
    slices.refuse_jump(place);
    std::vector<Point2> points;
    for (const Point2 &p : column.points()) // there y to the track centre and z up
      points.push_back({-p.x, -p.y});
    return ProfileLine(std::move(points), slices.path(), false);
  }
} // namespace wheelrail
