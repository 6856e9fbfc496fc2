#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/profiles/profile_orientation.h>
#include <wheelrail/profiles/profile_text.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    using Points = std::vector<FilePoint>;

    struct Box
    {
      Point2 low, high;
    };

    Box
    box_of(const Points &points)
    {
      Box box{points.at(0).position, points.at(0).position};
      for (const FilePoint &p : points)
        {
          box.low  = {std::min(box.low.x, p.position.x), std::min(box.low.y, p.position.y)};
          box.high = {std::max(box.high.x, p.position.x), std::max(box.high.y, p.position.y)};
        }
      return box;
    }

    double
    median_y(const Points &points)
    {
      std::vector<double> y;
      for (const FilePoint &p : points)
        y.push_back(p.position.y);
      std::nth_element(y.begin(), y.begin() + y.size() / 2, y.end());
      return y[y.size() / 2];
    }

    void
    turn_over(Points &points, std::vector<std::string> &notes)
    {
      for (FilePoint &p : points)
        p.position.y = -p.position.y;
      notes.push_back("turned upside down: the vertical coordinate of the file points down");
    }

    void
    mirror_x(Points &points, const std::string &why, std::vector<std::string> &notes)
    {
      for (FilePoint &p : points)
        p.position.x = -p.position.x;
      notes.push_back("mirrored: " + why);
    }

    void
    start_at_field_side(Points &points, std::vector<std::string> &notes)
    {
      if (points.front().position.x >= points.back().position.x)
        return;
      std::reverse(points.begin(), points.end());
      notes.push_back("order of the points reversed");
    }

    // --- wheel -----------------------------------------------------------------------------------

    std::size_t
    lowest(const Points &points)
    {
      return std::min_element(
               points.begin(),
               points.end(),
               [](const FilePoint &a, const FilePoint &b) { return a.position.y < b.position.y; }) -
             points.begin();
    }

    void
    check_wheel(const Points &points, const std::string &file)
    {
      const Box    box   = box_of(points);
      const double width = box.high.x - box.low.x, depth = median_y(points) - box.low.y;
      if (width < 0.06 || depth < 0.015)
        throw InputError(
          file + ": no wheel profile: " + in_mm(width, 10) + " wide, its lowest part " + in_mm(depth, 10) +
          " below the middle one; a tread with its flange is needed, at least 60 mm "
          "wide and 15 mm deep" +
          (width > 0.04 && width < 0.095 ? " (this may be a rail: Profiles/Rail takes those)" : ""));
      if (width > 0.2 || depth > 0.045)
        throw InputError(file + ": no wheel profile: " + in_mm(width, 10) + " wide, its lowest part " +
                         in_mm(depth, 10) + " below the middle one; up to 200 mm and 45 mm are accepted");
      const std::size_t tip  = lowest(points);
      const FilePoint  &free = std::abs(points.front().position.x - points[tip].position.x) >
                                  std::abs(points.back().position.x - points[tip].position.x)
                                 ? points.front()
                                 : points.back();
      if (free.position.y - box.low.y < 0.012)
        throw InputError(
          file + ": no wheel profile: both of its ends hang down, the one without the flange to " +
          in_mm(free.position.y - box.low.y, 10) +
          " above the lowest point; a tread with its flange on one side is needed (this may be a rail: "
          "Profiles/Rail takes those)");
    }

    // --- rail ------------------------------------------------------------------------------------

    std::size_t
    highest(const Points &points)
    {
      return std::max_element(
               points.begin(),
               points.end(),
               [](const FilePoint &a, const FilePoint &b) { return a.position.y < b.position.y; }) -
             points.begin();
    }

    /// Width of the part within `depth` of the top.
    double
    width_near_top(const Points &points, const double depth)
    {
      const double top = box_of(points).high.y;
      double       low = 1, high = -1;
      for (const FilePoint &p : points)
        if (p.position.y > top - depth)
          {
            low  = std::min(low, p.position.x);
            high = std::max(high, p.position.x);
          }
      return high - low;
    }

    bool
    hangs_down(const Points &points)
    {
      const Box box = box_of(points);
      if (box.high.y - box.low.y > 0.1) // a whole rail: its head is narrower than its foot
        {
          Points turned = points;
          for (FilePoint &p : turned)
            p.position.y = -p.position.y;
          return width_near_top(turned, 0.02) < width_near_top(points, 0.02);
        }
      double       middle = 0, ends = 0;
      unsigned int n_middle = 0, n_ends = 0;
      for (const FilePoint &p : points)
        {
          const double place = (p.position.x - box.low.x) / (box.high.x - box.low.x);
          if (place > 1. / 3 && place < 2. / 3)
            {
              middle += p.position.y;
              ++n_middle;
            }
          else if (place < 0.15 || place > 0.85)
            {
              ends += p.position.y;
              ++n_ends;
            }
        }
      return n_middle > 0 && n_ends > 0 && middle / n_middle < ends / n_ends;
    }

    /// The run of points around the top that stays within 35 mm of it; on a closed outline it may
    /// pass over the first point.
    Points
    head_of(Points points, std::vector<std::string> &notes)
    {
      constexpr double  depth  = 0.035;
      const std::size_t before = points.size();
      const double      top    = box_of(points).high.y;
      const auto        inside = [&](const FilePoint &p) { return p.position.y > top - depth; };
      if (norm(points.front().position - points.back().position) < 0.01)
        if (const auto low = std::find_if_not(points.begin(), points.end(), inside); low != points.end())
          std::rotate(points.begin(), low, points.end());
      std::size_t first = highest(points), last = first;
      while (first > 0 && inside(points[first - 1]))
        --first;
      while (last + 1 < points.size() && inside(points[last + 1]))
        ++last;
      const Points head(points.begin() + first, points.begin() + last + 1);
      if (head.size() < before)
        notes.push_back(counted(before - head.size(), "point") + " more than 35 mm below the top left out");
      return head;
    }

    void
    check_rail(const Points &points, const std::string &file)
    {
      const Box    box   = box_of(points);
      const double width = box.high.x - box.low.x;
      const double left  = box.high.y - points.front().position.y,
                   right = box.high.y - points.back().position.y;
      if (points.size() < 20)
        throw InputError(file + ": only " + counted(points.size(), "point") +
                         " of a rail head; at least 20 are needed");
      if (width < 0.04 || width > 0.095)
        throw InputError(file + ": no rail head: " + in_mm(width, 10) + " wide; 40 mm to 95 mm is accepted" +
                         (width > 0.095 ? " (this may be a wheel: Profiles/Wheel takes those)" : ""));
      if (std::max(left, right) < 5e-3 || std::min(left, right) < 0.5e-3)
        throw InputError(
          file + ": not enough of a rail head: its ends lie " + in_mm(left, 10) + " and " + in_mm(right, 10) +
          " below its top; the gauge side down to the gauge height (14 mm) is needed, and the crown");
    }
  } // namespace


  std::vector<FilePoint>
  oriented_wheel(std::vector<FilePoint>    points,
                 const std::string        &file,
                 const ProfileMirror       mirror,
                 std::vector<std::string> &notes)
  {
    const Box    box    = box_of(points);
    const double middle = median_y(points);
    if (box.high.y - middle > middle - box.low.y)
      turn_over(points, notes);
    check_wheel(points, file);

    const auto flange_right = [&]() {
      return points[lowest(points)].position.x > 0.5 * (box_of(points).low.x + box_of(points).high.x);
    };
    if (mirror == ProfileMirror::automatic && flange_right())
      mirror_x(points, "the flange of the file lies at positive lateral coordinates", notes);
    else if (mirror == ProfileMirror::yes)
      mirror_x(points, "Profiles/Wheel mirror = yes", notes);
    if (flange_right())
      throw InputError(
        file + ": with Profiles/Wheel mirror = " + (mirror == ProfileMirror::yes ? "yes" : "no") +
        " the flange lies on the field side; write auto or " + (mirror == ProfileMirror::yes ? "no" : "yes"));
    start_at_field_side(points, notes);
    return points;
  }


  std::vector<FilePoint>
  oriented_rail(std::vector<FilePoint>    points,
                const std::string        &file,
                const ProfileMirror       mirror,
                const bool                gauge_right,
                std::vector<std::string> &notes)
  {
    if (hangs_down(points))
      turn_over(points, notes);
    points = head_of(points, notes);
    if (mirror == ProfileMirror::yes)
      mirror_x(points, "Profiles/Rail mirror = yes", notes);
    else if (mirror == ProfileMirror::automatic && gauge_right)
      mirror_x(points,
               "files of this format have the gauge side on the right; Profiles/Rail mirror changes it",
               notes);
    else if (mirror == ProfileMirror::automatic)
      notes.push_back("not mirrored: x taken as positive to the field side; Profiles/Rail mirror changes it");
    start_at_field_side(points, notes);
    check_rail(points, file);
    return points;
  }
} // namespace wheelrail
