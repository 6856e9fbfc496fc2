#include <wheelrail/contactfiles/curved_patch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace wheelrail
{
  namespace
  {
    /// The axes of a row: x along the track, y across its surface, z into the rail.
    RigidMotion
    row_axes(const PatchPlace &place, const double angle)
    {
      PatchPlace row = place;
      row.angle      = angle;
      return patch_axes(row);
    }
  } // namespace


  double
  CurvedRows::arc_at(const double y, const double first, const double spacing) const
  {
    for (std::size_t j = 0; j + 1 < place.size(); ++j)
      if (y < place[j + 1][1])
        return first + spacing * (double(j) + (y - place[j][1]) / (place[j + 1][1] - place[j][1]));
    return first + spacing * double(place.size() - 1);
  }


  CurvedRows
  curved_rows(const WheelRailPose &pose,
              const ProfileLine   &rail,
              const WheelShape    &wheel,
              const PatchPlace    &place,
              const HalfspaceGrid &grid,
              const double         origin_y)
  {
    const RigidMotion axes = patch_axes(place), to_track = pose.wheel_to_track();
    const double      wheel_arc = arc_at_y(wheel.middle(), to_track.back(place.reference)[1]);
    constexpr double  beside    = 1e-3; // of a piece, to both sides for the slope
    CurvedRows        rows;
    for (int j = 0; j < grid.my; ++j)
      {
        const double             arc = grid.y(j) - origin_y;
        const ProfileLine::Place p   = rail.at(rail.parameter(place.arc + arc));
        const Vector3 on_rail = pose.rail({0, p.y, p.z}), tangent = pose.rail.turned({0, p.dy, p.dz});
        const double  t  = wheel.middle().parameter(wheel_arc + arc);
        const auto    on = [&](const double at) {
          return wheel_point(wheel, to_track, pose.wheel_radius, place.reference[0], at).value_or(on_rail);
        };
        const Vector3 on_wheel = on(t), before = on(t - beside), behind = on(t + beside);
        const Vector3 mean  = 0.5 * (on_rail + on_wheel);
        const double  dy    = behind[1] - before[1];
        const double  slope = dy != 0 ? (behind[2] - before[2]) / dy : tangent[2] / tangent[1];
        rows.angle.push_back(std::atan(0.5 * (tangent[2] / tangent[1] + slope)));
        rows.place.push_back({place.reference[0], mean[1], mean[2]});
        rows.plane.push_back(axes.back(rows.place.back())[1]);
      }
    return rows;
  }


  namespace
  {
    /// Slip of two velocities, rail and wheel, in axes that move with the contact: along their mean path and
    /// across. `share`: of the rail in that mean.
    std::array<double, 2>
    slip_along_path(const Vector3 &rail, const Vector3 &wheel, const double share)
    {
      const Vector3 mean   = share * rail + (1 - share) * wheel;
      const double  length = std::max(1e-8, std::hypot(mean[0], mean[2])), sign = mean[0] > 0 ? 1 : -1;
      const auto    forward = [&](const Vector3 &v) {
        return sign * (v[0] * mean[0] + v[2] * mean[2]) / length;
      };
      return {{forward(rail) - forward(wheel), rail[1] - wheel[1]}};
    }

    /// Creepages and spin nearest to a field of slip in the overlap, by least squares; x counts `ahead` of an
    /// element.
    PatchCreepages
    nearest_creepages(const HalfspaceProblem &problem,
                      const double            origin_x,
                      const double            origin_y,
                      const double            ahead)
    {
      const HalfspaceGrid &grid = problem.grid;
      double               n = 0, x = 0, y = 0, squares = 0, along = 0, across = 0, turning = 0;
      for (int j = 0; j < grid.my; ++j)
        for (int i = 0; i < grid.mx; ++i)
          {
            const auto e = std::size_t(i) + std::size_t(grid.mx) * std::size_t(j);
            if (problem.undeformed_distance[e] >= problem.approach)
              continue;
            const double here_x = grid.x(i) - origin_x + ahead, here_y = grid.y(j) - origin_y;
            n += 1;
            x += here_x;
            y += here_y;
            squares += here_x * here_x + here_y * here_y;
            along += problem.rigid_slip_x[e];
            across += problem.rigid_slip_y[e];
            turning += here_x * problem.rigid_slip_y[e] - here_y * problem.rigid_slip_x[e];
          }
      PatchCreepages found;
      if (n == 0)
        return found;
      for (double *value : {&x, &y, &squares, &along, &across, &turning})
        *value /= n;
      const double spread = squares - x * x - y * y;
      if (spread > 1e-18)
        found.spin = (turning + y * along - x * across) / spread;
      found.x = along + y * found.spin;
      found.y = across - x * found.spin;
      return found;
    }
  } // namespace


  PatchCreepages
  set_surface_slip(const WheelRailPose   &pose,
                   const PatchPlace      &place,
                   const CurvedRows      &rows,
                   const SurfaceDistance &surfaces,
                   const double           origin_x,
                   const double           origin_y,
                   HalfspaceProblem      &problem)
  {
    const HalfspaceGrid &grid  = problem.grid;
    const bool           shift = problem.motion == HalfspaceMotion::shift;
    const RigidMotion    plane = patch_axes(place);
    const auto           given = [](const HalfspaceBody &body) {
      return (1 - body.poisson_ratio) / body.shear_modulus;
    };
    const double share = given(problem.body1) / (given(problem.body1) + given(problem.body2));
    problem.xi = problem.eta = problem.phi = 0;
    problem.rigid_slip_x.assign(std::size_t(grid.size()), 0.);
    problem.rigid_slip_y = problem.rigid_slip_x;
    // axes move with the wheelset; in shifts CONTACT lets them move by 1 mm
    const double forward = shift ? 1e-3 : pose.wheelset_motion.velocity[0];
    const double over    = shift ? 1 : problem.velocity;
    for (int j = 0; j < grid.my; ++j)
      {
        const RigidMotion axes = row_axes(place, rows.angle[std::size_t(j)]);
        for (int i = 0; i < grid.mx; ++i)
          {
            const auto   e       = std::size_t(i) + std::size_t(grid.mx) * std::size_t(j);
            const double on_rail = surfaces.rail[e], on_wheel = on_rail - std::min(surfaces.gap[e], 1e-3),
                         x = grid.x(i) - origin_x;
            Vector3 rail   = pose.rail_at(plane({x, rows.plane[std::size_t(j)], on_rail})).velocity,
                    wheel  = pose.wheel_at(plane({x, rows.plane[std::size_t(j)], on_wheel})).velocity;
            if (!pose.roller)
              for (Vector3 *v : {&rail, &wheel})
                (*v)[0] -= forward;
            const auto slip =
              slip_along_path(axes.back(rail + axes.move), axes.back(wheel + axes.move), share);
            problem.rigid_slip_x[e] = slip[0] / over;
            problem.rigid_slip_y[e] = slip[1] / over;
          }
      }
    const double step = problem.step > 0 ? problem.step : grid.dx;
    return nearest_creepages(
      problem, origin_x, origin_y, shift ? 0 : (forward < 0 ? -1 : 1) * problem.spin_offset * step);
  }


  PatchForce
  curved_force(const PatchPlace        &place,
               const CurvedRows        &rows,
               const double             origin_x,
               const HalfspaceSolution &s)
  {
    PatchForce sum;
    for (int j = 0; j < s.grid.my; ++j)
      {
        const auto        row  = std::size_t(j);
        const RigidMotion axes = row_axes(place, rows.angle[row]);
        for (int i = 0; i < s.grid.mx; ++i)
          {
            const auto    e = std::size_t(i) + std::size_t(s.grid.mx) * std::size_t(j);
            const Vector3 force =
              s.grid.element_area() * axes.turned({s.traction_x[e], s.traction_y[e], s.pressure[e]});
            const Vector3 arm = rows.place[row] + Vector3{s.grid.x(i) - origin_x, 0, 0} - place.reference;
            add(sum.force, 1, force);
            add(sum.moment, 1, cross(arm, force));
          }
      }
    return sum;
  }
} // namespace wheelrail
