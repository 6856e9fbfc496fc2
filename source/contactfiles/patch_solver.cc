#include <wheelrail/contactfiles/case_problem.h>
#include <wheelrail/contactfiles/patch_solver.h>
#include <wheelrail/contactfiles/solve_cases.h>
#include <wheelrail/contactfiles/weakened_rows.h>
#include <wheelrail/halfspace/turned_rows.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

namespace wheelrail
{
  namespace
  {
    /// The rows and columns of a grid that a solution has in contact, as the grid of their elements.
    HalfspaceGrid
    contact_of(const HalfspaceSolution &s)
    {
      int low_x = s.grid.mx, high_x = -1, low_y = s.grid.my, high_y = -1;
      for (int j = 0; j < s.grid.my; ++j)
        for (int i = 0; i < s.grid.mx; ++i)
          if (s.pressure[std::size_t(i) + std::size_t(s.grid.mx) * j] > 0)
            {
              low_x  = std::min(low_x, i);
              high_x = std::max(high_x, i);
              low_y  = std::min(low_y, j);
              high_y = std::max(high_y, j);
            }
      HalfspaceGrid grid = s.grid;
      grid.mx            = std::max(0, high_x - low_x + 1);
      grid.my            = std::max(0, high_y - low_y + 1);
      grid.x0            = s.grid.x(low_x);
      grid.y0            = s.grid.y(low_y);
      return grid;
    }

    /// A grid that covers another of equal elements, too.
    void
    cover(HalfspaceGrid &grid, const HalfspaceGrid &other)
    {
      if (other.size() == 0)
        return;
      const auto left = [](double a, double b, double d) {
        return std::max(0, int(std::lround((a - b) / d)));
      };
      const int    x = left(grid.x0, other.x0, grid.dx), y = left(grid.y0, other.y0, grid.dy);
      const double last_x = std::max(grid.x(grid.mx - 1), other.x(other.mx - 1)),
                   last_y = std::max(grid.y(grid.my - 1), other.y(other.my - 1));
      grid.x0 -= x * grid.dx;
      grid.y0 -= y * grid.dy;
      grid.mx = int(std::lround((last_x - grid.x0) / grid.dx)) + 1;
      grid.my = int(std::lround((last_y - grid.y0) / grid.dy)) + 1;
    }

    /// Elements of the problem beyond its patch, which the state before reached, do not touch.
    void
    keep_within(const HalfspaceGrid &patch, HalfspaceProblem &problem)
    {
      const HalfspaceGrid &grid = problem.grid;
      for (int j = 0; j < grid.my; ++j)
        for (int i = 0; i < grid.mx; ++i)
          {
            const double x = (grid.x(i) - patch.x0) / grid.dx, y = (grid.y(j) - patch.y0) / grid.dy;
            if (x < -0.5 || y < -0.5 || x > patch.mx - 0.5 || y > patch.my - 0.5)
              problem.undeformed_distance[std::size_t(i) + std::size_t(grid.mx) * j] = 1;
          }
    }

    /// The approach of bodies that stand where they stand: as far as they would overlap.
    void
    set_approach(HalfspaceProblem &problem)
    {
      const double nearest =
        *std::min_element(problem.undeformed_distance.begin(), problem.undeformed_distance.end());
      for (double &h : problem.undeformed_distance)
        h -= nearest;
      problem.force_given = false;
      problem.approach    = std::max(0., -nearest);
    }

    /// With rows that turn (C = 4), or with divisions between them.
    HalfspaceSolution
    solved(const ContactCase                 &one,
           const HalfspaceProblem            &problem,
           const std::vector<RowDivision>    &divisions,
           const std::vector<double>         &angles,
           std::shared_ptr<HalfspaceKernels> &kernels,
           const HalfspaceSolution           *guess)
    {
      if (one.digits.influence == 4)
        return solve_turned(problem, angles, one.iteration.maxout, kernels, guess);
      return divisions.empty() ? solve_rolling(problem, kernels, guess)
                               : solve_weakened(problem, divisions, kernels, guess);
    }
  } // namespace


  PatchSolver::PatchSolver(const ContactCase   &one,
                           const RailShape     &rail,
                           const WheelShape    &wheel,
                           const WheelRailPose &pose,
                           const WheelRailCase *before)
    : one_(one)
    , rail_(rail)
    , wheel_(wheel)
    , pose_(pose)
    , before_(before)
    , shift_(one.digits.motion == 1)
    , transient_(shift_ || one.digits.motion == 2)
  {
  }

  WheelRailPatch
  PatchSolver::solve(const std::vector<PatchPlace> &places,
                     const bool                     rolls,
                     const std::size_t              number,
                     const HalfspaceSolution *const last,
                     KeptKernels                   &kernels) const
  {
    const PatchPlace &place = places[number];
    WheelRailPatch    patch;
    set_place(place, patch);
    HalfspaceProblem problem;
    set_bodies(one_, problem);
    problem.grid = patch_grid(one_, place, patch.origin_x, patch.origin_y);
    const HalfspaceSolution earlier =
      rolls && transient_ ? earlier_state(places, number, patch, problem.grid) : HalfspaceSolution();
    const HalfspaceGrid own  = patch_grid(one_, place, patch.origin_x, patch.origin_y);
    const CurvedRows    rows = rows_of(place, problem.grid, patch);
    SurfaceDistance     surfaces =
      patch_distance(pose_, rail_, wheel_, place, problem.grid, patch.origin_x, patch.origin_y, rows.plane);
    problem.undeformed_distance = surfaces.gap;
    for (std::size_t e = 0; patch.curved && e < surfaces.gap.size(); ++e)
      problem.undeformed_distance[e] *= std::cos(rows.angle[e / std::size_t(problem.grid.mx)] - place.angle);
    keep_within(own, problem);
    set_approach(problem);
    if (rolls)
      set_motion(place, rows, surfaces, problem, patch);
    else
      problem.motion = HalfspaceMotion::none;
    if (rolls && transient_ && !earlier.pressure.empty())
      problem.previous = &earlier;
    const HalfspaceSolution *guess = nullptr;
    HalfspaceSolution        moved;
    if (last && std::abs(last->grid.dx - problem.grid.dx) < 1e-9 &&
        std::abs(last->grid.dy - problem.grid.dy) < 1e-9)
      {
        moved = on_grid(*last, problem.grid);
        guess = &moved;
      }
    std::vector<RowDivision> divisions = place.divisions;
    for (RowDivision &d : divisions)
      d.place = patch.curved ? rows.arc_at(d.place, problem.grid.y0, problem.grid.dy)
                             : (d.place - place.reference[1]) / std::cos(place.angle) + patch.origin_y;
    if (patch.backwards)
      {
        turn_problem(problem);
        turn_solution(moved);
        for (RowDivision &d : divisions)
          d.place = -d.place;
        std::reverse(divisions.begin(), divisions.end());
      }
    patch.solution = solved(one_,
                            problem,
                            divisions,
                            patch.backwards ? half_turn(rows.angle) : rows.angle,
                            kernels.of(problem),
                            guess);
    if (patch.backwards)
      turn_solution(patch.solution);
    if (problem.max_coupling_rounds == 1 && patch.solution.normal_converged &&
        (!rolls || patch.solution.tangential_converged))
      {
        patch.solution.coupling_converged = true;
        patch.solution.not_reached.clear();
      }
    set_forces(place, rows, patch);
    return patch;
  }


  CurvedRows
  PatchSolver::rows_of(const PatchPlace &place, const HalfspaceGrid &grid, WheelRailPatch &patch) const
  {
    patch.curved = one_.digits.grid == 4;
    if (patch.curved)
      return curved_rows(pose_, rail_.middle(), wheel_, place, grid, patch.origin_y);
    CurvedRows rows;
    for (int j = 0; j < grid.my; ++j)
      {
        rows.plane.push_back(grid.y(j) - patch.origin_y);
        if (one_.digits.grid == 3) // slip of the surfaces, in the plane
          rows.angle.push_back(place.angle);
      }
    return rows;
  }


  void
  PatchSolver::set_place(const PatchPlace &place, WheelRailPatch &patch) const
  {
    patch.in_track = place.reference;
    patch.on_rail  = pose_.rail.back(place.reference);
    patch.on_wheel = pose_.wheel_to_track().back(place.reference);
    patch.angle    = place.angle;
    patch.y_low    = place.y_low;
    patch.y_high   = place.y_high;
    patch.arc      = place.arc;
    if (transient_)
      {
        // shifts leave the grid on the rail, rolling takes it along
        patch.origin_x = place.reference[0] + (shift_ ? millimetre * one_.wheelset.position[0] : 0);
        patch.origin_y = patch.arc;
      }
  }


  void
  PatchSolver::set_motion(const PatchPlace      &place,
                          const CurvedRows      &rows,
                          const SurfaceDistance &surfaces,
                          HalfspaceProblem      &problem,
                          WheelRailPatch        &patch) const
  {
    const ContactFrictionLine line = patch_friction(one_, wheel_angle(place, place.angle));
    problem.friction               = friction_of(one_, line);
    problem.hot_friction           = hot_friction_of(one_, {line});
    patch.friction                 = problem.friction.at(0);
    patch.friction_constants       = line.constants;
    const PatchCreepages creepages = patch_creepages(pose_, place, problem.approach, shift_);
    patch.velocity                 = creepages.velocity;
    patch.backwards                = creepages.backwards;
    patch.creepage                 = creepages.x;
    patch.lateral_creepage         = creepages.y;
    patch.spin                     = creepages.spin;
    problem.motion                 = shift_       ? HalfspaceMotion::shift
                                     : transient_ ? HalfspaceMotion::transient
                                                  : HalfspaceMotion::steady;
    const bool at_rest             = creepages.velocity == 0 && creepages.x == 0; // any velocity will do
    problem.velocity               = at_rest ? 1 : creepages.velocity;
    // creepages count at the contact reference, those of the problem at its origin
    problem.xi  = creepages.x + creepages.spin * patch.origin_y;
    problem.eta = creepages.y - creepages.spin * patch.origin_x;
    problem.phi = creepages.spin;
    if (one_.digits.motion == 2 || one_.digits.solver == 2)
      problem.step = one_.elements.relative_step * problem.grid.dx;
    patch.step = shift_ ? 1 : problem.step > 0 ? problem.step : problem.grid.dx;
    if (rows.angle.empty())
      return;
    if (!shift_ && !pose_.roller)
      problem.velocity = patch.velocity = std::abs(pose_.wheelset_motion.velocity[0]);
    const PatchCreepages nearest =
      set_surface_slip(pose_, place, rows, surfaces, patch.origin_x, patch.origin_y, problem);
    patch.creepage         = nearest.x;
    patch.lateral_creepage = nearest.y;
    patch.spin             = nearest.spin;
    if (!patch.curved || one_.digits.variation != 1)
      return;
    std::vector<ContactFrictionLine> lines;
    for (const double angle : rows.angle)
      lines.push_back(patch_friction(one_, wheel_angle(place, angle)));
    for (const ContactFrictionLine &row : lines)
      problem.row_friction.push_back(friction_of(one_, row));
    problem.hot_friction = hot_friction_of(one_, lines);
    patch.friction       = 1; // forces are printed over the normal force
  }


  double
  PatchSolver::wheel_angle(PatchPlace place, const double angle) const
  {
    place.angle          = angle;
    const Vector3 across = pose_.wheel_to_track().turned_back(patch_axes(place).turned({0, 1, 0}));
    return std::atan2(across[2], across[1]);
  }


  HalfspaceSolution
  PatchSolver::earlier_state(const std::vector<PatchPlace> &places,
                             const std::size_t              number,
                             WheelRailPatch                &patch,
                             HalfspaceGrid                 &grid) const
  {
    std::vector<HalfspaceSolution> states;
    for (std::size_t k = 0; before_ && k < before_->patches.size(); ++k)
      {
        const WheelRailPatch &old     = before_->patches[k];
        const auto            goes_on = [&](const PatchPlace &place) {
          return place.y_low <= old.y_high && place.y_high >= old.y_low;
        };
        if (!goes_on(places[number]))
          continue;
        const auto here = places.begin() + std::ptrdiff_t(number);
        const bool last_of_it =
          std::any_of(places.begin(), here, goes_on) && std::none_of(here + 1, places.end(), goes_on);
        patch.earlier.push_back(int(k) + 1);
        HalfspaceSolution state = old.solution;
        if (old.origin_x == 0 && old.origin_y == 0) // of steady rolling: to the fixed grid
          {
            const double x = old.in_track[0] + (shift_ ? before_->along : 0);
            state.grid.x0 += std::round(x / grid.dx) * grid.dx;
            state.grid.y0 += std::round(old.arc / grid.dy) * grid.dy;
          }
        // at a height given CONTACT cuts the last of several off where it ends
        if (!last_of_it || one_.digits.normal == 1)
          cover(grid, contact_of(state));
        states.push_back(std::move(state));
      }
    HalfspaceSolution sum;
    for (const HalfspaceSolution &state : states)
      {
        const HalfspaceSolution moved = on_grid(state, grid);
        if (sum.pressure.empty())
          {
            sum = moved;
            continue;
          }
        for (std::size_t e = 0; e < moved.pressure.size(); ++e)
          {
            if (moved.pressure[e] > 0)
              sum.friction[e] = moved.friction[e];
            sum.pressure[e] += moved.pressure[e];
            sum.traction_x[e] += moved.traction_x[e];
            sum.traction_y[e] += moved.traction_y[e];
          }
      }
    return sum;
  }


  void
  PatchSolver::set_forces(const PatchPlace &place, const CurvedRows &rows, WheelRailPatch &patch) const
  {
    const HalfspaceSolution &s        = patch.solution;
    const RigidMotion        axes     = patch_axes(place);
    const RigidMotion        wheelset = pose_.wheelset_to_track(), wheel = pose_.wheel_to_track();
    patch.spin_moment = s.spin_moment - patch.origin_x * s.fy + patch.origin_y * s.fx;
    // moments of the pressure about the axes in the plane, through the contact reference
    Vector3 moment{0, 0, patch.spin_moment};
    for (int j = 0; j < s.grid.my; ++j)
      for (int i = 0; i < s.grid.mx; ++i)
        {
          const double force =
            s.pressure[std::size_t(i) + std::size_t(s.grid.mx) * j] * s.grid.element_area();
          moment[0] += (s.grid.y(j) - patch.origin_y) * force;
          moment[1] -= (s.grid.x(i) - patch.origin_x) * force;
        }
    moment              = axes.turned(moment);
    patch.force_track   = axes.turned({s.fx, s.fy, s.fn});
    patch.normal_force  = s.fn;
    patch.lateral_force = s.fy;
    if (patch.curved)
      {
        const PatchForce sum = curved_force(place, rows, patch.origin_x, s);
        patch.force_track    = sum.force;
        moment               = sum.moment;
        const Vector3 own = axes.back(sum.force + axes.move), turning = axes.back(sum.moment + axes.move);
        patch.normal_force  = own[2];
        patch.lateral_force = own[1];
        patch.spin_moment   = turning[2];
      }
    const auto back = [&](const Vector3 &v) { // to the axes of the wheelset
      return wheelset.back(v + wheelset.move);
    };
    patch.force_wheelset  = back(patch.force_track);
    patch.moment_rail     = cross(place.reference - pose_.rail.move, patch.force_track) + moment;
    patch.moment_wheelset = back(cross(place.reference - wheel.move, patch.force_track) + moment);
  }
} // namespace wheelrail
