#include <wheelrail/base/errors.h>
#include <wheelrail/profiles/profile_crown.h>
#include <wheelrail/profiles/profile_orientation.h>

#include <algorithm>

namespace wheelrail
{
  bool
  is_crown(const std::vector<FilePoint> &points, const ProfileKind kind)
  {
    if (kind == ProfileKind::wheel)
      try
        {
          std::vector<std::string> unread;
          oriented_wheel(points, "", ProfileMirror::automatic, ProfileMirror::automatic, unread);
          return false;
        }
      catch (const InputError &)
        {
          return true;
        }
    constexpr double gauge_height = 14e-3;
    double           top          = points.front().position.y;
    for (const FilePoint &p : points)
      top = std::max(top, p.position.y);
    return std::min(points.front().position.y, points.back().position.y) > top - gauge_height;
  }


  std::vector<FilePoint>
  oriented_crown(std::vector<FilePoint>    points,
                 const std::string        &turned,
                 const ProfileMirror       mirror,
                 const int                 outwards,
                 std::vector<std::string> &notes)
  {
    for (FilePoint &p : points)
      p.position = {mirror == ProfileMirror::yes ? -p.position.x : p.position.x,
                    turned.empty() ? p.position.y : -p.position.y};
    if (!turned.empty())
      notes.push_back("turned upside down: " + turned);
    if (mirror == ProfileMirror::yes)
      notes.push_back("mirrored, as Profiles asks");
    if (points.front().position.x < points.back().position.x)
      std::reverse(points.begin(), points.end());
    const Point2 from = points.front().position, chord = points.back().position - from;
    double       out = 0; // of all points over the line between the ends, twice an area
    for (const FilePoint &p : points)
      out += cross(p.position - from, chord);
    // the ends lie at +x and -x: what lies above the line is on its right
    if (outwards * out < 0)
      notes.push_back("concave crown, a groove, as the sign of its y says; change the sign for a convex one");
    return points;
  }
} // namespace wheelrail
