#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/profiles/profile_cleaning.h>
#include <wheelrail/profiles/profile_outliers.h>
#include <wheelrail/profiles/profile_text.h>
#include <wheelrail/profiles/smoothing_spline.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace wheelrail
{
  namespace
  {
    using Points = std::vector<FilePoint>;

    std::string
    lines(const FilePoint &a, const FilePoint &b)
    {
      return "lines " + std::to_string(std::min(a.line, b.line)) + " and " +
             std::to_string(std::max(a.line, b.line));
    }

    double
    length_of(const Points &points)
    {
      double sum = 0;
      for (std::size_t i = 1; i < points.size(); ++i)
        sum += norm(points[i].position - points[i - 1].position);
      return sum;
    }

    Points
    without_repeated(const Points &points, std::vector<std::string> &notes)
    {
      Points kept;
      for (const FilePoint &p : points)
        if (kept.empty() || norm(p.position - kept.back().position) > 1e-6)
          kept.push_back(p);
      if (kept.size() < points.size())
        notes.push_back(counted(points.size() - kept.size(), "repeated point") + " dropped");
      return kept;
    }

    /// Points listed in no order along the outline are sorted by x, when that makes the line through
    /// them much shorter.
    void
    sort_if_shorter(Points &points, std::vector<std::string> &notes)
    {
      Points sorted = points;
      std::stable_sort(sorted.begin(), sorted.end(), [](const FilePoint &a, const FilePoint &b) {
        return a.position.x < b.position.x;
      });
      if (length_of(sorted) < 0.5 * length_of(points))
        {
          points = sorted;
          notes.push_back(
            "the points, listed in no order along the outline, sorted by the lateral coordinate");
        }
    }

    /// Where the line jumps back by b and then repeats a stretch, the two pieces are merged in the
    /// direction that the line had before.
    void
    merge_overlaps(Points &points, const std::string &file, std::vector<std::string> &notes)
    {
      constexpr unsigned int most_overlaps = 5;
      for (unsigned int found = 0; found < most_overlaps; ++found)
        {
          const double step       = median_step(positions(points));
          std::size_t  i          = 2;
          const auto   turns_back = [&](const std::size_t k) {
            const Point2 before = points[k - 1].position - points[k - 2].position,
                         after  = points[k].position - points[k - 1].position,
                         beyond = points[k + 1].position - points[k].position;
            return norm(after) > 1.5 * step && dot(before, after) < -0.8 * norm(before) * norm(after) &&
                   dot(after, beyond) < -0.8 * norm(after) * norm(beyond);
          };
          while (i + 1 < points.size() && !turns_back(i))
            ++i;
          if (i + 1 >= points.size())
            return;
          const Point2 d     = points[i - 1].position - points[i].position;
          const Point2 e     = (1 / norm(d)) * d;
          const auto   along = [&](const FilePoint &p) { return dot(p.position - points[i].position, e); };
          std::size_t  first = i, last = i;
          while (first > 0 && along(points[first - 1]) >= 0)
            --first;
          while (last + 1 < points.size() && along(points[last]) <= norm(d))
            ++last;
          if (norm(d) > 0.03)
            throw InputError(file + ": between " + lines(points[i - 1], points[i]) +
                             " the line of points turns back by " + in_mm(norm(d)) +
                             "; pieces that overlap by at most 30 mm are merged, write each place once");
          // the second piece against the line through the first one
          double worst = 0;
          for (std::size_t k = i; k < last; ++k)
            for (std::size_t j = std::max<std::size_t>(first, 1); j < i; ++j)
              {
                const Point2 a = points[j - 1].position, b = points[j].position, q = points[k].position;
                const double length = norm(b - a), place = dot(q - a, b - a) / (length * length);
                if (place >= 0 && place <= 1)
                  worst = std::max(worst, std::abs(cross(b - a, q - a)) / length);
              }
          if (worst > 5e-4)
            throw InputError(file + ": the pieces that overlap at " + lines(points[i - 1], points[i]) +
                             " are " + in_mm(worst) + " apart; up to 0.5 mm is merged: align or cut them");
          const std::string where = lines(points[i - 1], points[i]);
          const std::size_t size  = last - first;
          const Point2      base  = points[i].position;
          std::stable_sort(
            points.begin() + first, points.begin() + last, [&](const FilePoint &a, const FilePoint &b) {
              return dot(a.position - base, e) < dot(b.position - base, e);
            });
          notes.push_back("two pieces that overlap by " + in_mm(norm(d)) + " at " + where + " merged (" +
                          std::to_string(size) + " points, at most " + in_mm(worst) + " apart)");
        }
      throw InputError(file + ": the line of points turns back more than " + std::to_string(most_overlaps) +
                       " times; write the points in their order along the outline");
    }

    /// Points much closer than the smoothing can use are averaged over 0.1 mm.
    void
    average_close(Points &points, std::vector<std::string> &notes)
    {
      constexpr double least = 1e-4;
      if (median_step(positions(points)) > 0.6 * least)
        return;
      Points            result;
      const std::size_t before = points.size();
      for (std::size_t i = 0; i < points.size();)
        {
          Point2      sum;
          std::size_t n = 0, k = i;
          for (; k < points.size() && norm(points[k].position - points[i].position) < least; ++k, ++n)
            sum = sum + points[k].position;
          result.push_back({(1. / static_cast<double>(n)) * sum, points[i].line});
          i = k;
        }
      points = result;
      notes.push_back("points closer than 0.1 mm averaged: " + std::to_string(points.size()) + " of " +
                      std::to_string(before) + " left");
    }

    /// The distance across the profile; throws when it is no profile.
    double
    check_size(const Points &points, const std::string &file)
    {
      if (points.size() < 20)
        throw InputError(file + ": " + counted(points.size(), "different point") +
                         "; a profile needs at least 20, some 200 are usual");
      // a line of points that wriggles is long at any unit: the extent tells
      Point2 low = points[0].position, high = low;
      for (const FilePoint &p : points)
        {
          low  = {std::min(low.x, p.position.x), std::min(low.y, p.position.y)};
          high = {std::max(high.x, p.position.x), std::max(high.y, p.position.y)};
        }
      const double extent = norm(high - low);
      if (extent >= 5e-3 && extent <= 0.5)
        return extent;
      std::string fit;
      for (const auto &[name, factor] :
           std::map<std::string, double>{{"mm", 1e-3}, {"m", 1e3}, {"inch", 25.4}})
        if (const double other = extent * factor; fit.empty() && other >= 0.03 && other <= 0.3)
          fit = "; multiplied by " + format_number(factor) + " it would be " + in_mm(other, 10) +
                ", so the unit may be wrong";
      throw InputError(file + ": the profile is " + format_number(std::round(extent * 1e7) / 1e4) +
                       " mm across; 5 mm to 500 mm is accepted" + fit +
                       ". Set Profiles/Wheel unit or Profiles/Rail unit");
    }

    /// Direction of the outline at point i against its order (`sense` = -1) or along it (+1), taken over 2 mm
    /// or more; nothing beyond the ends.
    std::optional<Point2>
    direction_from(const Points &points, const std::size_t i, const int sense)
    {
      std::size_t k = i;
      while ((sense > 0 ? k + 1 < points.size() : k > 0) &&
             norm(points[k].position - points[i].position) < 2e-3)
        k += sense;
      const Point2 d = sense * (points[k].position - points[i].position);
      if (k == i)
        return {};
      return (1 / norm(d)) * d;
    }

    /// Whether a long step from point i - 1 to point i is a straight face: the outline on both sides goes on
    /// in its direction, within 3 degrees where it is steep and half a degree where wheels and rails touch
    /// (an arc of R300 turns by 1.1 degrees against a chord of 12 mm); or it is an upright face at the
    /// lateral end of the profile, whatever corners it has: back of a flange, face of a rim or a roller, side
    /// of a head.
    bool
    is_straight_face(const Points &points, const std::size_t i)
    {
      const double degree = M_PI / 180;
      const Point2 d      = points[i].position - points[i - 1].position;
      const double most   = std::abs(d.y) > std::abs(d.x) ? 3 * degree : 0.5 * degree;
      const auto   agrees = [&](const std::optional<Point2> &other) {
        return !other || std::atan2(std::abs(cross(d, *other)), dot(d, *other)) < most;
      };
      if (agrees(direction_from(points, i - 1, -1)) && agrees(direction_from(points, i, 1)))
        return true;
      if (std::abs(d.y) < 4 * std::abs(d.x))
        return false;
      double low = points[i].position.x, high = low;
      for (const FilePoint &p : points)
        {
          low  = std::min(low, p.position.x);
          high = std::max(high, p.position.x);
        }
      const double a = points[i - 1].position.x, b = points[i].position.x;
      return std::max(a, b) < low + 2e-3 || std::min(a, b) > high - 2e-3;
    }

    /// Tells gaps that the smoothing bridges, fills longer steps on straight faces by points on the line, and
    /// refuses other ones.
    Points
    bridge_gaps(const Points &points, const std::string &file, std::vector<std::string> &notes)
    {
      constexpr double longest = 30e-3;
      const double     usual = median_step(positions(points)), fill = std::clamp(usual, 0.25e-3, 2e-3);
      std::size_t      gaps  = 0;
      double           worst = 0;
      std::string      where;
      Points           result{points[0]};
      for (std::size_t i = 1; i < points.size(); ++i)
        {
          const Point2 a = points[i - 1].position, d = points[i].position - a;
          const double step = norm(d);
          if (step > 10e-3 * (1 + 1e-9))
            {
              if (step > longest || !is_straight_face(points, i))
                throw InputError(file + ": a gap of " + in_mm(step) + " between " +
                                 lines(points[i - 1], points[i]) +
                                 "; up to 10 mm is bridged, on a straight face up to " + in_mm(longest) +
                                 ": measure again or add points");
              notes.push_back("step of " + in_mm(step) + " between " + lines(points[i - 1], points[i]) +
                              " taken as a straight face");
              const int n = static_cast<int>(std::ceil(step / fill));
              for (int k = 1; k < n; ++k)
                result.push_back({a + (static_cast<double>(k) / n) * d, points[i - 1].line});
            }
          else if (is_gap(step, usual))
            {
              ++gaps;
              if (step > worst)
                {
                  worst = step;
                  where = lines(points[i - 1], points[i]);
                }
            }
          result.push_back(points[i]);
        }
      if (gaps > 0)
        notes.push_back(counted(gaps, "gap") + " bridged, the largest " + in_mm(worst) + " between " + where);
      return result;
    }

    bool
    cross_each_other(const Point2 &a, const Point2 &b, const Point2 &c, const Point2 &d)
    {
      // pieces of one straight line, such as a cone's, lie on either side of each other by round-off
      const bool apart = std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
                         std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y);
      return !apart && cross(b - a, c - a) * cross(b - a, d - a) < 0 &&
             cross(d - c, a - c) * cross(d - c, b - c) < 0;
    }

    /// Pieces of the line are compared within the squares of a grid that they touch.
    void
    check_loops(const Points &points, const std::string &file)
    {
      const double                                            cell = 2e-3;
      std::map<std::pair<int, int>, std::vector<std::size_t>> squares;
      const auto index = [cell](const double v) { return static_cast<int>(std::floor(v / cell)); };
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
        {
          const Point2 a = points[i].position, b = points[i + 1].position;
          for (int x = index(std::min(a.x, b.x)); x <= index(std::max(a.x, b.x)); ++x)
            for (int y = index(std::min(a.y, b.y)); y <= index(std::max(a.y, b.y)); ++y)
              {
                std::vector<std::size_t> &square = squares[{x, y}];
                for (const std::size_t k : square)
                  if (k + 1 < i && cross_each_other(points[k].position, points[k + 1].position, a, b))
                    throw InputError(file + ": the line of points crosses itself between line " +
                                     std::to_string(std::min(points[k].line, points[i].line)) + " and line " +
                                     std::to_string(std::max(points[k].line, points[i].line)) +
                                     "; a profile without loops is needed: remove the points of the loop");
                square.push_back(i);
              }
        }
    }
  } // namespace


  std::vector<FilePoint>
  cleaned_points(std::vector<FilePoint> points, const std::string &file, std::vector<std::string> &notes)
  {
    points              = without_repeated(points, notes);
    const double extent = check_size(points, file);
    sort_if_shorter(points, notes);
    // also a bound on the work of what follows
    if (const double length = length_of(points); length > 6 * extent)
      throw InputError(file + ": the line of points is " + in_mm(length, 10) + " long and the profile only " +
                       in_mm(extent, 10) +
                       " across; write the points in their order along the outline, without loops");
    average_close(points, notes);
    // a point that is off along the outline looks like an overlap, and pieces that were merged may hold
    // others
    points = without_outliers(points, file, notes);
    merge_overlaps(points, file, notes);
    points = without_repeated(points, notes);
    points = without_outliers(points, file, notes);
    check_size(points, file);
    return points;
  }


  std::vector<FilePoint>
  bridged_points(const std::vector<FilePoint> &points,
                 const std::string            &file,
                 std::vector<std::string>     &notes)
  {
    Points result = bridge_gaps(points, file, notes);
    check_loops(result, file);
    return result;
  }

} // namespace wheelrail
