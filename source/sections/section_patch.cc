#include <wheelrail/sections/section_patch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace wheelrail
{
  namespace
  {
    constexpr double beside = 30e-3;  ///< of the surface that is there on either side of a contact [m]
    constexpr double around = 7.5e-3; ///< looked through for parts that overlap on either side of it [m]
    constexpr double far    = 10e-3;  ///< distance where there is no surface [m]

    /// Columns of a surface around a line.
    SectionColumn
    column_around(const SectionsSurface &rail, const double place, const double line)
    {
      const double lines = beside / rail.spacing();
      return rail.column(
        place, static_cast<std::size_t>(std::max(0., line - lines)), static_cast<std::size_t>(line + lines));
    }

    /// Arc length of a section at X [m], near that of `start`.
    double
    arc_at(const SectionColumn &column, const double start, const double X)
    {
      double s = start;
      for (int round = 0; round < 8; ++round)
        {
          const SectionColumn::Point p = column.at(s);
          s = std::clamp(s + (X - p.position.x) / p.tangent.x, 0., column.length());
        }
      return s;
    }

    /// A point of the overlap of wheel and rail.
    struct OverlapPoint
    {
      Vector3 place{};
      double  weight = 0;
      double  line   = 0;
      Vector3 normal{};
    };

    /// The connected overlap around a place, looked at on a grid of steps along and across.
    std::vector<OverlapPoint>
    overlap_around(const SectionsSurface &rail,
                   const PosedWheel      &wheel,
                   const TouchingPlace   &place,
                   const double           at,
                   const double           height,
                   const double           dx,
                   const double           dy)
    {
      constexpr int most = 400; // columns on one side
      struct Row
      {
        SectionColumn             column;
        std::vector<OverlapPoint> points;
        bool                      done = false;
      };
      const int                 half = static_cast<int>(around / dy);
      std::vector<OverlapPoint> points;
      // columns are added on both sides as long as the overlap goes on
      const auto add = [&](const int i) {
        const double        Z      = place.place[2] + i * dx;
        const SectionColumn column = column_around(rail, at + Z, place.line);
        bool                any    = false;
        if (column.empty())
          return false;
        const double middle = column.arc(place.line);
        const auto   look   = [&](const int j) {
          const double s = middle + j * dy;
          if (s < 0 || s > column.length())
            return false;
          const SectionColumn::Point p = column.at(s);
          const Vector3              P{p.position.x, p.position.y, Z};
          const auto                 gap = wheel.distance(P, {0, 1, 0}, height);
          if (!gap || *gap >= 0)
            return false;
          any = true;
          points.push_back({P, *gap * *gap, column.line(s), rail_normal(p)});
          return true;
        };
        for (int j = -half + 1; j < half; ++j)
          look(j);
        // from there on only as far as the overlap goes on: of profiles that lie into each other it is wide
        for (int j = half; look(j); ++j)
          ;
        for (int j = -half; look(j); --j)
          ;
        return any;
      };
      for (int i = 0; i < most && (add(i) || i == 0); ++i)
        ;
      for (int i = -1; i > -most && add(i); --i)
        ;
      return points;
    }
  } // namespace


  SectionPatch::SectionPatch(const SectionsSurface &rail_surface,
                             const PosedWheel      &wheel,
                             const SectionRolling  &rolling,
                             const TouchingPlace   &place,
                             const double           at,
                             const double           height)
    : rail(place.rail)
    , problem(rolling.problem)
    , surface_(&rail_surface)
    , wheel_(&wheel)
    , rolling_(&rolling)
    , at_(at)
  {
    set_reference(place, height);
    set_rail_distance();
  }


  void
  SectionPatch::set_reference(const TouchingPlace &place, const double height)
  {
    const double dx = rolling_->dx, dy = rolling_->dy;
    auto         points = overlap_around(*surface_, *wheel_, place, at_, height, dx, 0.5 * dy);
    if (points.empty())
      points.push_back({place.place, 1, place.line, place.normal});
    double sum = 0, X = 0, Z = 0;
    line_ = 0;
    Vector3 mean{};
    for (const OverlapPoint &p : points)
      {
        sum += p.weight;
        X += p.weight * p.place[0];
        Z += p.weight * p.place[2];
        line_ += p.weight * p.line;
        add(mean, p.weight, p.normal);
      }
    X /= sum;
    Z /= sum;
    line_ /= sum;
    normal                     = normalised(mean);
    const SectionColumn column = column_around(*surface_, at_ + Z, line_);
    const double        s      = arc_at(column, column.arc(line_), X);
    reference                  = {X, column.at(s).position.y, Z};
    if (rolling_->section_normal)
      {
        // the section under the axle, at the same lateral places
        const SectionColumn under = column_around(*surface_, at_ + wheel_->centre()[2], line_);
        double              turn  = 0;
        for (const OverlapPoint &p : points)
          {
            const SectionColumn &c = under.empty() ? column : under;
            const Vector3        n = rail_normal(c.at(arc_at(c, c.arc(p.line), p.place[0])), false);
            turn += p.weight / sum * std::atan2(-n[0], n[1]);
          }
        normal = {-std::sin(turn), std::cos(turn), 0};
      }
    along         = normalised(Vector3{0, 0, 1} - normal[2] * normal);
    across        = cross(normal, along);
    angle         = -std::atan2(across[1], across[0]);
    double half_x = 0, half_y = 0;
    for (const OverlapPoint &p : points)
      {
        half_x = std::max(half_x, std::abs(dot(p.place - reference, along)));
        half_y = std::max(half_y, std::abs(dot(p.place - reference, across)));
      }
    constexpr double room =
      1.15; // the contact of surfaces that do not curve evenly may be wider than their overlap
    problem.grid = centred_grid(room * half_x + 2 * dx, room * half_y + 2 * dy, dx, dy);
  }


  void
  SectionPatch::set_rail_distance()
  {
    const HalfspaceGrid &grid = problem.grid;
    rail_distance_.assign(grid.size(), std::numeric_limits<double>::quiet_NaN());
    for (int i = 0; i < grid.mx; ++i)
      {
        const double        Z0     = reference[2] + grid.x(i) * along[2];
        const SectionColumn column = column_around(*surface_, at_ + Z0, line_);
        if (column.empty())
          continue;
        for (int j = 0; j < grid.my; ++j)
          {
            Vector3 P = reference;
            add(P, grid.x(i), along);
            add(P, grid.y(j), across);
            double t = 0, s = arc_at(column, column.arc(line_), P[0]);
            for (int round = 0; round < 12; ++round)
              {
                const SectionColumn::Point p = column.at(s);
                const double               Z = P[2] + t * normal[2] - Z0;
                // column(s) + Z along = P + t normal
                const Point2 miss{P[0] + t * normal[0] - p.position.x - Z * p.along.x,
                                  P[1] + t * normal[1] - p.position.y - Z * p.along.y},
                  n{normal[0] - normal[2] * p.along.x, normal[1] - normal[2] * p.along.y};
                const double determinant = cross(p.tangent, n);
                const double ds = cross(miss, n) / determinant, dt = -cross(p.tangent, miss) / determinant;
                s += ds;
                t += dt;
                if (std::abs(ds) + std::abs(dt) < 1e-12)
                  {
                    if (s >= 0 && s <= column.length())
                      rail_distance_[i + std::size_t(grid.mx) * j] = t;
                    break;
                  }
              }
          }
      }
  }


  void
  SectionPatch::press(const double height)
  {
    const HalfspaceGrid &grid = problem.grid;
    height_                   = height;
    std::vector<double> &d    = problem.undeformed_distance;
    d.assign(grid.size(), far);
    double least = far;
    for (int j = 0; j < grid.my; ++j)
      for (int i = 0; i < grid.mx; ++i)
        {
          const std::size_t e = i + std::size_t(grid.mx) * j;
          if (!std::isfinite(rail_distance_[e]))
            continue;
          Vector3 P = reference;
          add(P, grid.x(i), along);
          add(P, grid.y(j), across);
          if (const auto to_wheel = wheel_->distance(P, normal, height))
            d[e] = std::min(far, *to_wheel - rail_distance_[e]);
          least = std::min(least, d[e]);
        }
    approach = -least;
    if (!(approach > 0))
      {
        solution = {};
        approach = 0;
        return;
      }
    for (double &value : d)
      value -= least;
    problem.pressure.clear();
    problem.force_given = false;
    problem.approach    = approach;
    problem.motion      = HalfspaceMotion::none;
    const bool known =
      solution.contact_elements > 0 && solution.grid.mx == grid.mx && solution.grid.my == grid.my;
    const HalfspaceSolution before = known ? std::move(solution) : HalfspaceSolution();
    solution                       = solve_rolling(problem, kernels_, known ? &before : nullptr);
  }


  void
  SectionPatch::roll()
  {
    Vector3 P = reference;
    add(P, -approach, normal); // on the wheel
    const Vector3 centre = wheel_->centre() + Vector3{0, height_, 0};
    const Vector3 turns = rolling_->turning * wheel_->axis(), rolls = cross(turns, P - centre);
    const double  V  = problem.velocity;
    radius           = centre[1] - P[1];
    wheel_x          = wheel_->on_section(P, height_).x;
    Vector3 velocity = Vector3{0, 0, V} + rolls;
    if (!rolling_->section_normal) // the wheel rises or falls with the rail
      velocity[1] -= dot(velocity, normal) / normal[1];
    const double mean = 0.5 * (V - rolls[2]);
    problem.motion    = HalfspaceMotion::steady;
    problem.xi        = -dot(velocity, along) / mean;
    problem.eta       = -dot(velocity, across) / mean;
    problem.phi       = -dot(turns, normal) / mean;
    problem.pressure  = solution.pressure;
    solution          = solve_rolling(problem, kernels_, &solution);
    problem.pressure.clear();
  }


  Vector3
  SectionPatch::force() const
  {
    if (!(normal_force() > 0))
      return {};
    Vector3 f = -solution.fn * normal;
    add(f, solution.fx, along);
    add(f, solution.fy, across);
    return f;
  }
} // namespace wheelrail
