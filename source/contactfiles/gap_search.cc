#include <wheelrail/contactfiles/gap_search.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// The point of the wheel's locus at a parameter of its section, where it inclines along the track as
    /// given.
    std::optional<Vector3>
    locus_point(const ProfileLine &line,
                const RigidMotion &to_track,
                const double       radius,
                const double       t,
                const double       slope)
    {
      const ProfileLine::Place p = line.at(t);
      // the normal (dy sin, -dz, dy cos) lies across the inclined track
      const Vector3 row = to_track.rows[0] + slope * to_track.rows[2];
      const double  a = row[0] * p.dy, b = row[2] * p.dy, c = row[1] * p.dz;
      const double  largest = std::hypot(a, b);
      if (std::abs(c) > largest)
        return {};
      const double angle = std::asin(c / largest) - std::atan2(b, a), rho = radius + p.z;
      return to_track({rho * std::sin(angle), p.y, rho * std::cos(angle) - radius});
    }

    /// How far a roller falls below its top at x.
    double
    fall(const double radius, const double x)
    {
      return radius - std::sqrt(std::max(0., radius * radius - x * x));
    }

    /// The same over a roller, whose radius depends on y: by rounds, each of which would go too far by the
    /// ratio of the radii.
    std::optional<Vector3>
    locus_over_roller(const ProfileLine                   &line,
                      const WheelRailPose                 &pose,
                      const RigidMotion                   &to_track,
                      const std::function<double(double)> &radius_at,
                      const double                         t)
    {
      double slope = 0;
      for (int round = 0;; ++round)
        {
          const auto point = locus_point(line, to_track, pose.wheel_radius, t, slope);
          if (!point || round == 20)
            return point;
          const double x = (*point)[0], radius = radius_at((*point)[1]);
          if (std::abs(x) >= radius)
            return {};
          const double change = x / std::sqrt(radius * radius - x * x) - slope;
          if (std::abs(change) < 1e-10)
            return point;
          slope += change * radius / (radius + pose.wheel_radius);
        }
    }

    double
    distance(const PatchPlace &outer, const PatchPlace &inner)
    {
      return std::hypot(outer.y_low - inner.y_high, outer.z_low - inner.z_high);
    }

    /// The overlap of the places from `first` to `last`, whose neighbours are apart.
    PatchPlace
    overlap(const std::vector<GapPlace> &gaps,
            const std::size_t            first,
            const std::size_t            last,
            const double                 height,
            const double                 radius)
    {
      const double curvature = 0.5 / radius;
      PatchPlace   patch;
      double       x = 0, y = 0, angle = 0;
      patch.x_low  = 1e3;
      patch.x_high = -1e3;
      for (std::size_t k = first; k <= last; ++k)
        {
          // the square of the overlap over a slice, where it is a parabola
          const double depth = height - gaps[k].gap, half = std::sqrt(depth / curvature),
                       weight = std::max(depth * depth * half, 1e-30);
          patch.weight += weight;
          x += weight * gaps[k].x;
          y += weight * gaps[k].y;
          angle += weight * gaps[k].angle;
          patch.x_low  = std::min(patch.x_low, gaps[k].x - half);
          patch.x_high = std::max(patch.x_high, gaps[k].x + half);
        }
      patch.reference = {x / patch.weight, y / patch.weight, 0};
      patch.angle     = angle / patch.weight;
      const auto end  = [&](const std::size_t inside, const std::size_t outside, double &at_y, double &at_z) {
        const double a = gaps[inside].gap - height, b = gaps[outside].gap - height;
        const double part = b > a ? std::min(1., -a / (b - a)) : 0;
        at_y              = gaps[inside].y + part * (gaps[outside].y - gaps[inside].y);
        at_z              = gaps[inside].rail_z + part * (gaps[outside].rail_z - gaps[inside].rail_z);
      };
      end(first, first > 0 ? first - 1 : first, patch.y_low, patch.z_low);
      end(last, std::min(last + 1, gaps.size() - 1), patch.y_high, patch.z_high);
      return patch;
    }

    /// Two overlaps as one patch.
    PatchPlace
    joined(const PatchPlace &outer, const PatchPlace &inner)
    {
      PatchPlace both = outer;
      both.weight     = outer.weight + inner.weight;
      const double w  = inner.weight / both.weight;
      both.reference  = (1 - w) * outer.reference + w * inner.reference;
      both.angle      = (1 - w) * outer.angle + w * inner.angle;
      both.x_low      = std::min(outer.x_low, inner.x_low);
      both.x_high     = std::max(outer.x_high, inner.x_high);
      both.y_low      = inner.y_low;
      both.z_low      = inner.z_low;
      both.divisions.insert(both.divisions.begin(), inner.divisions.begin(), inner.divisions.end());
      return both;
    }

    /// Patches that D_SEP and A_SEP leave apart, as their planes turn to each other up to D_TURN.
    void
    turn_planes(std::vector<PatchPlace> &patches, const ContactElements &elements)
    {
      const double sep = 1e-3 * elements.d_sep, turn = 1e-3 * elements.d_turn;
      if (turn <= sep)
        return;
      const std::vector<PatchPlace> before = patches;
      for (std::size_t k = 0; k + 1 < patches.size(); ++k)
        {
          const PatchPlace &outer = before[k], &inner = before[k + 1];
          const double      apart = distance(outer, inner);
          if (std::abs(outer.angle - inner.angle) > elements.a_sep || apart < sep || apart > turn)
            continue;
          const double part = (turn - apart) / (turn - sep);
          const double mean =
            (outer.angle * outer.weight + inner.angle * inner.weight) / (outer.weight + inner.weight);
          patches[k].angle += part * (mean - outer.angle);
          patches[k + 1].angle += part * (mean - inner.angle);
        }
    }

    /// Sets the reference on the rail and the ends of the patch as lengths from it.
    void
    set_on_rail(PatchPlace                  &patch,
                const std::vector<GapPlace> &gaps,
                const RigidMotion           &to_track,
                const ProfileLine           &rail)
    {
      const double spacing = gaps.size() > 1 ? gaps[1].y - gaps[0].y : 1;
      const auto   at      = [&](const double y) { // parameter on the rail
        const double place = std::clamp((y - gaps.front().y) / spacing, 0., double(gaps.size()) - 1.001);
        const auto   k     = std::size_t(place);
        double       t     = gaps[k].line + (place - double(k)) * (gaps[k + 1].line - gaps[k].line);
        for (int step = 0; step < 3; ++step)
          {
                   const ProfileLine::Place p    = rail.at(t);
                   const double             rate = to_track.turned({0, p.dy, p.dz})[1];
                   if (rate > 0)
              t = std::clamp(t + (y - to_track({0, p.y, p.z})[1]) / rate, 0., rail.end());
          }
               return t;
      };
      patch.line                     = at(patch.reference[1]);
      const ProfileLine::Place p     = rail.at(patch.line);
      const Vector3            there = to_track({0, p.y, p.z});
      patch.reference                = {patch.reference[0], there[1], there[2]};
      patch.arc                      = rail.arc(patch.line);
      patch.s_low                    = rail.arc(at(patch.y_low)) - patch.arc;
      patch.s_high                   = rail.arc(at(patch.y_high)) - patch.arc;
    }
  } // namespace


  std::vector<std::optional<PointOver>>
  points_over(const std::vector<double> &samples,
              const CurveAt             &at,
              const double               first,
              const double               spacing,
              const std::size_t          n,
              const double               down)
  {
    std::vector<std::optional<PointOver>> found(n);
    std::optional<PointOver>              before;
    for (const double t : samples)
      {
        const std::optional<Vector3> there = at(t);
        if (before && there)
          {
            const double a = before->place[1], b = (*there)[1], low = std::min(a, b), high = std::max(a, b);
            const double k0 = std::ceil((low - first) / spacing), k1 = std::floor((high - first) / spacing);
            for (double k = std::max(0., k0); k <= std::min(double(n) - 1, k1); ++k)
              {
                const double y = first + k * spacing;
                PointOver    point;
                const double part            = b == a ? 0 : (y - a) / (b - a);
                point.t                      = before->t + part * (t - before->t);
                std::optional<Vector3> exact = at(point.t);
                if (!exact)
                  continue;
                if (b != a) // one secant more
                  {
                    point.t += (y - (*exact)[1]) * (t - before->t) / (b - a);
                    if (const auto better = at(point.t))
                      exact = better;
                  }
                point.place = *exact;
                auto &kept  = found[std::size_t(k)];
                if (!kept || down * (point.place[2] - kept->place[2]) > 0)
                  kept = point;
              }
          }
        before = there ? std::optional<PointOver>({t, *there}) : std::nullopt;
      }
    return found;
  }


  std::vector<GapPlace>
  gap_places(const WheelRailPose &pose, const ProfileLine &rail, const ProfileLine &wheel, const double most)
  {
    const RigidMotion to_track = then(pose.wheel, pose.wheelset);
    const CurveAt     on_rail  = [&](const double t) {
      const ProfileLine::Place p = rail.at(t);
      return std::optional<Vector3>(pose.rail({0, p.y, p.z}));
    };
    double low = 1e9, high = -1e9;
    for (const double t : rail.samples())
      {
        const double y = (*on_rail(t))[1];
        low            = std::min(low, y);
        high           = std::max(high, y);
      }
    const double spacing   = std::min(most, 0.1 * (high - low)); // more than one place, whatever the elements
    const auto   n         = std::size_t((high - low) / spacing) + 1;
    const auto   on_rails  = points_over(rail.samples(), on_rail, low, spacing, n, -1);
    const double centre    = pose.rail.move[2] + pose.axle[2]; // of a roller
    const auto   radius_at = [&](const double y) {
      const auto k = std::size_t(std::clamp((y - low) / spacing, 0., double(n) - 1));
      return on_rails[k] ? centre - on_rails[k]->place[2] : pose.axle[2];
    };
    const auto on_wheels = points_over(
      wheel.samples(),
      [&](const double t) {
        return pose.roller ? locus_over_roller(wheel, pose, to_track, radius_at, t)
                           : locus_point(wheel, to_track, pose.wheel_radius, t, 0);
      },
      low,
      spacing,
      n,
      1);
    constexpr double      apart = 1; // [m], beyond one of the sections
    std::vector<GapPlace> gaps;
    for (std::size_t k = 0; k < n; ++k)
      {
        GapPlace gap;
        gap.y   = low + double(k) * spacing;
        gap.gap = apart;
        if (on_rails[k])
          {
            const ProfileLine::Place p       = rail.at(on_rails[k]->t);
            const Vector3            tangent = pose.rail.turned({0, p.dy, p.dz});
            gap.rail_z                       = on_rails[k]->place[2];
            gap.line                         = on_rails[k]->t;
            gap.angle                        = std::atan2(tangent[2], tangent[1]);
            if (on_wheels[k])
              {
                gap.x = on_wheels[k]->place[0];
                if (pose.roller)
                  gap.rail_z += fall(centre - gap.rail_z, gap.x);
                gap.gap = gap.rail_z - on_wheels[k]->place[2];
              }
          }
        gaps.push_back(gap);
      }
    return gaps;
  }


  std::vector<PatchPlace>
  joined_patches(std::vector<PatchPlace> patches, const ContactElements &elements)
  {
    for (std::size_t k = 0; k + 1 < patches.size();)
      {
        const double apart = distance(patches[k], patches[k + 1]);
        if (std::abs(patches[k].angle - patches[k + 1].angle) > elements.a_sep ||
            apart > 1e-3 * elements.d_sep)
          {
            ++k;
            continue;
          }
        PatchPlace both = joined(patches[k], patches[k + 1]);
        if (apart > 1e-3 * elements.d_comb)
          both.divisions.insert(
            both.divisions.begin() + std::ptrdiff_t(patches[k + 1].divisions.size()),
            {0.5 * (patches[k].y_low + patches[k + 1].y_high),
             std::pow((elements.d_sep - 1e3 * apart) / (elements.d_sep - elements.d_comb), 0.8)});
        patches[k] = both;
        patches.erase(patches.begin() + std::ptrdiff_t(k) + 1);
      }
    turn_planes(patches, elements);
    return patches;
  }


  std::vector<PatchPlace>
  patch_places(const std::vector<GapPlace> &gaps,
               const WheelRailPose         &pose,
               const ProfileLine           &rail,
               const ContactElements       &elements)
  {
    const double radius =
      pose.roller ? 1 / (1 / pose.wheel_radius + 1 / pose.axle[2]) : pose.wheel_radius; // of the gap along
    std::vector<PatchPlace> patches;
    for (std::size_t k = gaps.size(); k-- > 0;)
      if (gaps[k].gap < pose.height)
        {
          const std::size_t last = k;
          while (k > 0 && gaps[k - 1].gap < pose.height)
            --k;
          patches.push_back(overlap(gaps, k, last, pose.height, radius));
        }
    patches = joined_patches(std::move(patches), elements);
    for (PatchPlace &patch : patches)
      {
        set_on_rail(patch, gaps, pose.rail, rail);
        if (pose.roller)
          patch.reference[2] +=
            fall(pose.rail.move[2] + pose.axle[2] - patch.reference[2], patch.reference[0]);
      }
    return patches;
  }
} // namespace wheelrail
