#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/profiles/profile_orientation.h>
#include <wheelrail/profiles/profile_text.h>

#include <algorithm>
#include <cmath>
#include <utility>

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

    /// A piece of the line of points.
    struct Piece
    {
      double height, width; ///< of its middle; along x, negative where x falls [m]
    };

    std::vector<Piece>
    pieces_of(const Points &points)
    {
      std::vector<Piece> pieces;
      for (std::size_t i = 1; i < points.size(); ++i)
        {
          const Point2 a = points[i - 1].position, b = points[i].position;
          pieces.push_back({0.5 * (a.y + b.y), b.x - a.x});
        }
      return pieces;
    }

    /// Height of the tread: half of the width lies above it, half below, however densely which part was
    /// measured. Upright faces have no width.
    double
    tread_height(const Points &points)
    {
      std::vector<Piece> pieces = pieces_of(points);
      std::sort(
        pieces.begin(), pieces.end(), [](const Piece &a, const Piece &b) { return a.height < b.height; });
      double whole = 0, below = 0;
      for (const Piece &piece : pieces)
        whole += std::abs(piece.width);
      for (const Piece &piece : pieces)
        if ((below += std::abs(piece.width)) >= 0.5 * whole)
          return piece.height;
      return points.front().position.y;
    }

    /// Whether the flange of a wheel points up: more area stands up than hangs down by more than 5 mm. The
    /// face of a rim, however high and noisy, has no area.
    bool
    flange_points_up(const Points &points)
    {
      constexpr double tread  = 5e-3;
      const double     middle = tread_height(points);
      double           up = 0, down = 0;
      for (const Piece &piece : pieces_of(points))
        {
          up += piece.width * std::max(0., piece.height - middle - tread);
          down += piece.width * std::max(0., middle - piece.height - tread);
        }
      return std::abs(up) > std::abs(down);
    }

    const char *const points_down = "the vertical coordinate of the file points down";

    void
    turn_over(Points &points, const std::string &why, std::vector<std::string> &notes)
    {
      for (FilePoint &p : points)
        p.position.y = -p.position.y;
      notes.push_back("turned upside down: " + why);
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
      const double width = box.high.x - box.low.x, depth = tread_height(points) - box.low.y;
      if (width < 0.06 || depth < 0.015)
        throw InputError(
          file + ": no wheel profile: " + in_mm(width, 10) + " wide, its lowest part " + in_mm(depth, 10) +
          " below the tread; a tread with its flange is needed, at least 60 mm "
          "wide and 15 mm deep" +
          (width > 0.04 && width < 0.095 ? " (this may be a rail: Profiles/Rail takes those)" : ""));
      if (width > 0.2 || depth > 0.045)
        throw InputError(file + ": no wheel profile: " + in_mm(width, 10) + " wide, its lowest part " +
                         in_mm(depth, 10) + " below the tread; up to 200 mm and 45 mm are accepted");
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

    /// The faces of the rim far above the tread, at both ends, belong to no running surface.
    Points
    without_rim(const Points &points, std::vector<std::string> &notes)
    {
      const double most   = tread_height(points) + 15e-3;
      const auto   inside = [most](const FilePoint &p) { return p.position.y < most; };
      const auto   begin  = std::find_if(points.begin(), points.end(), inside);
      const auto   end    = std::find_if(points.rbegin(), points.rend(), inside).base();
      const Points kept(begin, end);
      if (kept.size() < points.size())
        notes.push_back(counted(points.size() - kept.size(), "point") +
                        " more than 15 mm above the tread left out");
      return kept;
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
      // a crown is wide, sides are upright, and a web is narrower
      const double third = (box.high.y - box.low.y) / 3;
      double       high = 0, low = 0;
      for (const Piece &piece : pieces_of(points))
        {
          high += piece.height > box.high.y - third ? piece.width : 0;
          low += piece.height < box.low.y + third ? piece.width : 0;
        }
      return std::abs(low) > std::abs(high);
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
                 const ProfileMirror       turn,
                 std::vector<std::string> &notes)
  {
    if (turn == ProfileMirror::yes || (turn == ProfileMirror::automatic && flange_points_up(points)))
      turn_over(points, turn == ProfileMirror::yes ? "Profiles/Wheel upside down = yes" : points_down, notes);
    check_wheel(points, file);
    points = without_rim(std::move(points), notes);

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
                const ProfileMirror       turn,
                const bool                gauge_right,
                std::vector<std::string> &notes)
  {
    if (turn == ProfileMirror::yes || (turn == ProfileMirror::automatic && hangs_down(points)))
      turn_over(points, turn == ProfileMirror::yes ? "Profiles/Rail upside down = yes" : points_down, notes);
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
