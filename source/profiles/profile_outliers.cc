#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/profiles/measurement_noise.h>
#include <wheelrail/profiles/profile_outliers.h>
#include <wheelrail/profiles/profile_text.h>
#include <wheelrail/profiles/smoothing_spline.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    using Points = std::vector<FilePoint>;

    /// Place of p along the chord from a to b and distance to its left [m].
    Point2
    against_chord(const Point2 &p, const Point2 &a, const Point2 &b)
    {
      const double length = norm(b - a);
      if (!(length > 0))
        return {0, norm(p - a)};
      return {dot(p - a, b - a) / length, cross(b - a, p - a) / length};
    }

    /// How the outline goes on beyond a neighbour of a point that is judged.
    struct Beyond
    {
      double off       = 0; ///< distance of the neighbour from the chord of those around it [m]
      double curvature = 0; ///< of the outline through the three, without the point that is judged [1/m]
    };

    /// Of the neighbour `from`, with `across` on the other side of the point and the points in direction
    /// `step`: the next one that is half of `width` away, so that short steps beside long ones do not hide a
    /// kink, or the one behind it, since the next one may be an outlier itself.
    Beyond
    beyond(const std::vector<Point2> &points,
           const std::size_t          from,
           const Point2              &across,
           const int                  step,
           const double               width)
    {
      const auto exists = [&](const std::size_t i) { return i < points.size(); }; // 0 - 1 does not
      if (!exists(from + step))
        return {};
      const Point2 p  = points[from];
      const auto   of = [&](const Point2 &q) {
        const double off = against_chord(p, across, q).y, sides = norm(p - across) * norm(q - p);
        return Beyond{std::abs(off), sides > 0 ? -step * 2 * off / sides : 0};
      };
      std::size_t k = from + step;
      while (exists(k + step) && norm(points[k] - p) < 0.499 * width)
        k += step;
      const Beyond next = of(points[k]), far = exists(k + step) ? of(points[k + step]) : next;
      return far.off < next.off ? far : next;
    }

    /// How far the points first to last - 1 (one or two) stand off the outline if they are outliers: the
    /// least of their distances from the line between the points before and after them, less what an arc
    /// makes of it; 0 if they are none.
    ///
    /// Without an outlier its neighbours lie on a line or an arc with theirs, whatever its size. Without the
    /// point of a kink they do not: they stand off the chord of those around them by about as much as the
    /// point stood out. A pair is one only where its walls are steeper than any that is measured: profiles
    /// have real steps. A point beyond its neighbours along the line counts where these are near, `usual`
    /// being the distance of points: elsewhere it is the end of a piece that another one overlaps.
    double
    distance_from_neighbours(const std::vector<Point2> &points,
                             const std::size_t          first,
                             const std::size_t          last,
                             const double               usual)
    {
      constexpr double among = 0.6;
      if (first == 0 || last >= points.size())
        return 0;
      const Point2 before = points[first - 1], after = points[last];
      const double width = norm(after - before);
      const Beyond left  = beyond(points, first - 1, after, -1, width),
                   right = beyond(points, last, before, 1, width);
      const auto off_at  = [&](const Point2 &p) {
        const Point2 q     = against_chord(p, before, after);
        const double along = std::clamp(q.x, 0., width);
        // a curve that turns left lies to the right of its chord
        const double arc = -0.25 * (left.curvature + right.curvature) * along * (width - along);
        return std::copysign(width < 4 * usual ? std::hypot(q.x - along, q.y - arc) : q.y - arc, q.y - arc);
      };
      double off = std::abs(off_at(points[first]));
      if (last > first + 1)
        {
          const double other = off_at(points[first + 1]);
          if (off_at(points[first]) * other < 0 || std::min(off, std::abs(other)) < width)
            return 0;
          off = std::min(off, std::abs(other));
        }
      return left.off < among * off && right.off < among * off ? off : 0;
    }
  } // namespace


  std::vector<FilePoint>
  without_outliers(std::vector<FilePoint> points, const std::string &file, std::vector<std::string> &notes)
  {
    const std::size_t most  = std::max<std::size_t>(1, points.size() / 20);
    std::size_t       count = 0;
    double            worst = 0;
    unsigned int      line  = 0;
    for (bool again = true; again;)
      {
        const std::vector<Point2> all     = positions(points);
        const std::vector<double> scatter = estimated_scatter(all);
        const double              usual   = median_step(all);
        Points                    kept;
        again = false;
        for (std::size_t i = 0; i < points.size();)
          {
            // of a pair the first point alone would not do: the second one spoils its chord
            const double limit = std::max(8 * scatter[i], 5e-5);
            std::size_t  n     = 1;
            double       off   = distance_from_neighbours(all, i, i + 1, usual);
            if (!(off > limit) && i + 1 < points.size())
              off = distance_from_neighbours(all, i, i + (n = 2), usual);
            if (!(off > limit) || (!kept.empty() && kept.back().line != points[i - 1].line))
              {
                kept.push_back(points[i++]);
                continue;
              }
            count += n;
            again = true;
            if (off > worst)
              {
                worst = off;
                line  = points[i].line;
              }
            i += n;
          }
        points = kept;
        if (count > most)
          throw InputError(file + ": more than " + std::to_string(most) +
                           " points lie off the line of their neighbours, the worst by " + in_mm(worst) +
                           " in line " + std::to_string(line) +
                           "; single outliers are dropped, a profile of them cannot be mended: "
                           "measure again or smooth the file");
      }
    if (count > 0)
      notes.push_back(counted(count, "outlier") + " dropped, the largest " + in_mm(worst) + " off in line " +
                      std::to_string(line));
    return points;
  }

} // namespace wheelrail
