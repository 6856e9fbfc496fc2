#include <wheelrail/base/errors.h>
#include <wheelrail/contactfiles/case_problem.h>
#include <wheelrail/contactfiles/patch_problem.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace wheelrail
{
  namespace
  {
    constexpr double far_apart = 1; // [m]
    constexpr double none      = std::numeric_limits<double>::quiet_NaN();

    /// Heights n of the rail over the rows s of a plane, counted into the rail; NaN beside it.
    std::vector<double>
    rail_heights(const ProfileLine         &rail,
                 const RigidMotion         &to_plane,
                 const double               first_line,
                 const std::vector<double> &rows)
    {
      std::vector<double> heights(rows.size(), none);
      const auto          middle = std::size_t(
        std::min_element(
          rows.begin(), rows.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
        rows.begin());
      const auto follow = [&](const std::ptrdiff_t step) {
        double t = first_line, low = 0, high = 0;
        for (auto j = std::ptrdiff_t(middle); j >= 0 && j < std::ptrdiff_t(rows.size()); j += step)
          {
            for (int k = 0; k < 60; ++k)
              {
                if (k == 8) // to and fro over a corner: by halving
                  {
                    low  = std::max(0., t - 2);
                    high = std::min(rail.end(), t + 2);
                    t    = 0.5 * (low + high);
                  }
                const ProfileLine::Place p = rail.at(t);
                const Vector3 there = to_plane({0, p.y, p.z}), rate = to_plane.turned({0, p.dy, p.dz});
                const double  missed = rows[std::size_t(j)] - there[1];
                if (!(rate[1] > 0.1 * std::abs(rate[2])) || t < 0 || t > rail.end())
                  return; // beyond an end, or too steep for the plane
                heights[std::size_t(j)] = there[2] + missed * rate[2] / rate[1];
                if (std::abs(missed) < 1e-10)
                  break;
                if (k < 8)
                  {
                    t += missed / rate[1];
                    continue;
                  }
                (missed > 0 ? low : high) = t;
                t                         = 0.5 * (low + high);
              }
          }
      };
      follow(1);
      follow(-1);
      return heights;
    }

    /// The parameter of the sample nearest to the origin of a plane.
    double
    nearest_line(const ProfileLine &rail, const RigidMotion &to_plane)
    {
      double least = std::numeric_limits<double>::infinity(), nearest = 0;
      for (const double t : rail.samples())
        {
          const ProfileLine::Place p     = rail.at(t);
          const Vector3            there = to_plane({0, p.y, p.z});
          if (const double d = std::hypot(there[1], there[2]); d < least)
            {
              least   = d;
              nearest = t;
            }
        }
      return nearest;
    }

    /// The same over all columns of a grid, of the section of each; x counts from the reference.
    std::vector<std::vector<double>>
    rail_heights(const RailShape           &rail,
                 const RigidMotion         &to_plane,
                 const PatchPlace          &place,
                 const HalfspaceGrid       &grid,
                 const double               origin_x,
                 const std::vector<double> &rows)
    {
      const auto n = std::size_t(grid.mx);
      if (!rail.varies())
        return std::vector<std::vector<double>>(n, rail_heights(rail.middle(), to_plane, place.line, rows));
      std::vector<std::vector<double>> heights(n, std::vector<double>(rows.size(), none));
      for (int i = 0; i < grid.mx; ++i)
        if (const auto section = rail.at(place.reference[0] + grid.x(i) - origin_x))
          heights[std::size_t(i)] = rail_heights(*section, to_plane, nearest_line(*section, to_plane), rows);
      return heights;
    }

    /// Where lines along the normal of a plane meet a wheel.
    class WheelBelow
    {
    public:
      struct Hit
      {
        double n = 0, t = 0; ///< along the normal, parameter on the section
      };

      /// `line`: of a round wheel the section in place of its own.
      WheelBelow(const ProfileLine &line,
                 const WheelShape  &wheel,
                 const RigidMotion &to_wheel,
                 const double       radius)
        : line_(line)
        , wheel_(wheel)
        , to_wheel_(to_wheel)
        , radius_(radius)
        , along_(to_wheel.turned({0, 0, 1}))
      {
      }

      /// From a guess, by Newton's method.
      std::optional<Hit>
      at(const double x, const double s, Hit hit) const
      {
        const Vector3 foot = to_wheel_({x, s, 0});
        for (int k = 0; k < (wheel_.out_of_round() ? 40 : 12); ++k)
          {
            const Vector3            q = foot + hit.n * along_;
            const ProfileLine::Place p =
              wheel_.out_of_round() ? wheel_.at(std::atan2(q[0], q[2] + radius_), hit.t) : line_.at(hit.t);
            const double rho = std::hypot(q[0], q[2] + radius_);
            const double f = p.y - q[1], g = radius_ + p.z - rho;
            const double rate = (q[0] * along_[0] + (q[2] + radius_) * along_[2]) / rho;
            const double det  = -p.dy * rate + p.dz * along_[1];
            if (!(std::abs(det) > 0))
              return {};
            // f + dy dt - along_y dn = 0, g + dz dt - rate dn = 0
            const double dt = (f * rate - g * along_[1]) / det, dn = (f * p.dz - g * p.dy) / det;
            hit.t += std::clamp(dt, -2., 2.);
            hit.n += dn;
            if (!(hit.t > -1 && hit.t < line_.end() + 1))
              return {};
            if (std::abs(dn) < (k < 6 ? 1e-11 : 1e-9) && std::abs(dt) < 2) // corners may send it to and fro
              return hit.t >= 0 && hit.t <= line_.end() ? std::optional<Hit>(hit) : std::nullopt;
          }
        return {};
      }

      /// A guess: the place of the section nearest to a point of the plane.
      Hit
      guess(const double x, const double s) const
      {
        const Vector3 q       = to_wheel_({x, s, 0});
        const double  z       = std::hypot(q[0], q[2] + radius_) - radius_;
        double        nearest = std::numeric_limits<double>::infinity();
        Hit           hit;
        for (const double t : line_.samples())
          {
            const ProfileLine::Place p = line_.at(t);
            const double             d = std::hypot(p.y - q[1], p.z - z);
            if (d < nearest)
              {
                nearest = d;
                hit.t   = t;
              }
          }
        return hit;
      }

    private:
      const ProfileLine &line_;
      const WheelShape  &wheel_;
      const RigidMotion &to_wheel_;
      double             radius_;
      Vector3            along_; ///< the normal, in the axes of the wheel's section
    };
  } // namespace


  RigidMotion
  patch_axes(const PatchPlace &place)
  {
    RigidMotion axes = turned_by(place.angle, 0);
    axes.move        = place.reference;
    return axes;
  }


  PatchCreepages
  patch_creepages(const WheelRailPose &pose, const PatchPlace &place, const double approach, const bool shift)
  {
    const RigidMotion  axes    = patch_axes(place);
    const Vector3      touched = axes({0, 0, approach});
    const BodyVelocity rail = pose.rail_at(place.reference), wheel = pose.wheel_at(touched);
    // over a roller its surface stands for the track that passes the wheelset
    const double rolling = pose.rolling_at(touched)[0],
                 forward = pose.roller ? -pose.roller_at(place.reference)[0] : wheel.velocity[0] - rolling;
    const Vector3 slip   = axes.turned_back(rail.velocity - wheel.velocity),
                  turn   = axes.turned_back(rail.rotation - wheel.rotation);
    PatchCreepages found;
    found.velocity  = shift ? 1 : 0.5 * (std::abs(forward) + std::abs(rolling));
    found.backwards = !shift && !(std::abs(forward) >= std::abs(rolling) ? forward >= 0 : rolling <= 0);
    if (found.velocity == 0 && norm(slip) == 0 && turn[2] == 0) // at rest
      return found;
    found.x    = slip[0] / found.velocity;
    found.y    = slip[1] / found.velocity;
    found.spin = turn[2] / found.velocity;
    return found;
  }


  HalfspaceGrid
  patch_grid(const ContactCase &one, const PatchPlace &place, const double origin_x, const double origin_y)
  {
    const bool   fixed  = one.digits.motion == 1 || one.digits.motion == 2;
    const double low_x  = place.x_low - place.reference[0] + origin_x,
                 high_x = place.x_high - place.reference[0] + origin_x, low_y = place.s_low + origin_y,
                 high_y = place.s_high + origin_y;
    HalfspaceGrid grid;
    grid.dx        = millimetre * one.elements.dx;
    grid.dy        = millimetre * one.elements.ds;
    const auto lay = [&]() {
      const double ix = std::floor(low_x / grid.dx) - 1, iy = std::floor(low_y / grid.dy) - 1;
      grid.mx = int(std::ceil(high_x / grid.dx) + 1 - ix) + 1;
      grid.my = int(std::ceil(high_y / grid.dy) + 1 - iy) + 1;
      grid.x0 = ix * grid.dx;
      grid.y0 = iy * grid.dy;
    };
    if (!((high_x - low_x) / grid.dx < most_contact_elements &&
          (high_y - low_y) / grid.dy < most_contact_elements))
      throw InputError(
        "Half-spaces: the overlap of wheel and rail is more than 1000000 elements long: a position or force "
        "out of scale");
    lay();
    const double most = one.iteration.largest;
    while (!fixed && most >= 100 && double(grid.mx) * grid.my >= most && std::max(grid.mx, grid.my) > 10)
      {
        const bool wide = grid.mx > 10, long_ = grid.my > 10;
        grid.dx *= wide ? 2 : 1;
        grid.dy *= long_ ? 2 : 1;
        lay();
      }
    return grid;
  }


  SurfaceDistance
  patch_distance(const WheelRailPose       &pose,
                 const RailShape           &rail,
                 const WheelShape          &wheel,
                 const PatchPlace          &place,
                 const HalfspaceGrid       &grid,
                 const double               origin_x,
                 const double               origin_y,
                 const std::vector<double> &rows)
  {
    const RigidMotion axes = patch_axes(place);
    // from the section of the rail to the plane, and from the plane to the wheel
    const RigidMotion to_plane = then(pose.rail, inverse(axes)),
                      to_wheel = then(axes, inverse(pose.wheel_to_track()));

    const auto         heights = rail_heights(rail, to_plane, place, grid, origin_x, rows);
    const ProfileLine &line    = wheel.middle();
    const ProfileLine  mesh    = wheel.out_of_round()
                                   ? line
                                   : line.chords(arc_at_y(line, to_wheel({-origin_x, -origin_y, 0})[1]), grid.dy);
    const WheelBelow   below(mesh, wheel, to_wheel, pose.wheel_radius);
    SurfaceDistance    distance;
    distance.gap.assign(std::size_t(grid.size()), far_apart);
    distance.rail.assign(distance.gap.size(), 0.);
    const auto near = [](const double place, const int n) {
      return std::clamp(int(std::lround(place)), 0, n - 1);
    };
    const int  column = near((origin_x - grid.x0) / grid.dx, grid.mx);
    const int  row    = near((origin_y - grid.y0) / grid.dy, grid.my);
    const auto follow = [&](const int step) {
      WheelBelow::Hit start = below.guess(grid.x(column) - origin_x, rows[std::size_t(row)]);
      for (int j = row; j >= 0 && j < grid.my; j += step)
        for (const int way : {1, -1})
          {
            WheelBelow::Hit last = start;
            for (int i = column; i >= 0 && i < grid.mx; i += way)
              {
                const auto hit = below.at(grid.x(i) - origin_x, rows[std::size_t(j)], last);
                if (!hit)
                  continue;
                last = *hit;
                if (i == column)
                  start = *hit;
                const auto   e = std::size_t(i) + std::size_t(grid.mx) * std::size_t(j);
                const double h = heights[std::size_t(i)][std::size_t(j)];
                if (std::isnan(h))
                  continue;
                distance.gap[e]  = h - hit->n;
                distance.rail[e] = h;
              }
          }
    };
    follow(1);
    follow(-1);
    return distance;
  }


  ContactFrictionLine
  patch_friction(const ContactCase &one, const double wheel_angle)
  {
    const auto &lines = one.friction.lines;
    if (one.digits.variation == 0)
      return lines.front();
    const double place = one.digits.variation == 1 ? wheel_angle : one.wheelset.position[0];
    if (place <= lines.front().place)
      return lines.front();
    for (std::size_t k = 0; k + 1 < lines.size(); ++k)
      if (place < lines[k + 1].place)
        {
          const double        part    = (place - lines[k].place) / (lines[k + 1].place - lines[k].place);
          ContactFrictionLine between = lines[k];
          for (std::size_t c = 0; c < between.constants.size(); ++c)
            between.constants[c] += part * (lines[k + 1].constants[c] - between.constants[c]);
          return between;
        }
    return lines.back();
  }
} // namespace wheelrail
