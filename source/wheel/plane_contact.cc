#include <wheelrail/model/expected_patch.h>
#include <wheelrail/wheel/contact_reference.h>
#include <wheelrail/wheel/halfspace_parts.h>
#include <wheelrail/wheel/plane_contact.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace wheelrail
{
  namespace
  {
    // interpenetration at 0.55 of the approach has about the size of the patch (Kik and Piotrowski, 1996),
    // the rest is room for it to grow
    constexpr double part_of_approach = 0.75;
  } // namespace


  PlaneContact::PlaneContact(const Scene          &scene,
                             const SceneGeometry  &geometry,
                             const SectionOffsets &offsets,
                             const ContactRegion  &region)
    : sections(geometry, offsets, region)
    , motion(plane_motion(scene, geometry.contact))
    , problem(halfspace_problem(scene))
    , expected_force_(expected_load(scene))
    , expected_approach_(expected_approach(scene, geometry.contact.rolling_radius))
    , element_(scene.halfspace_element_size)
  {
  }


  void
  PlaneContact::set_distance()
  {
    problem.undeformed_distance = own_distance_;
    if (added_distance)
      for (int j = 0; j < problem.grid.my; ++j)
        for (int i = 0; i < problem.grid.mx; ++i)
          problem.undeformed_distance[i + problem.grid.mx * j] +=
            added_distance(problem.grid.x(i), problem.grid.y(j));
  }


  void
  PlaneContact::press_on_grid(const double first_approach)
  {
    constexpr double nearly = 0.2; // of the approach: a tenth of the extents
    problem.rigid_slip_x.clear();  // of the grid before
    problem.rigid_slip_y.clear();
    bool kept = laid_for_ > 0 && std::abs(first_approach - laid_for_) < nearly * laid_for_;
    if (kept)
      {
        set_distance();
        problem.motion = HalfspaceMotion::none;
        solution       = solve_rolling(problem, kernels_, &solution);
        kept           = !solution.touches_grid_edge;
      }
    if (!kept)
      {
        const auto lay_grid = [&](const double reached, const double size) {
          problem.grid = sections.grid(reached, size);
          sections.set_distance(problem);
          own_distance_ = problem.undeformed_distance;
          set_distance();
        };
        solution =
          solve_on_growing_grid(problem, first_approach, element_, 6, lay_grid, enlargements, kernels_);
        laid_for_ = first_approach;
      }
    if (solution.contact_elements > 0)
      means = pressure_means(sections, solution);
  }


  void
  PlaneContact::press(const double normal_force, const double room)
  {
    problem.force_given  = true;
    problem.normal_force = normal_force;
    press_on_grid(room * part_of_approach * expected_approach_ *
                  std::pow(std::max(1., normal_force / expected_force_), 2. / 3));
  }


  void
  PlaneContact::press_by(const double approach)
  {
    problem.force_given = false;
    problem.approach    = approach;
    press_on_grid(part_of_approach * approach);
  }


  void
  PlaneContact::roll(const double creepage)
  {
    problem.force_given              = true;
    problem.normal_force             = solution.fn;
    problem.motion                   = HalfspaceMotion::steady;
    problem.longitudinal_force_given = false;
    problem.xi                       = creepage;
    set_slip(sections, means, motion, creepage, problem);
    solution = solve_rolling(problem, kernels_, &solution);
  }


  void
  PlaneContact::carry_on_grid(const WheelRailLoad &load)
  {
    constexpr int    most_rounds = 12;
    constexpr double enough = 1e-3, enough_driven = 1e-4; // of the load
    const double     c = std::cos(means.rail_angle), s = std::sin(means.rail_angle);
    const double     yaw             = load.along_track ? 0 : sections.geometry().yaw;
    problem.motion                   = HalfspaceMotion::steady;
    problem.longitudinal_force_given = !load.rate_held;
    problem.xi                       = load.rate_held ? load.creepage : 0;
    // without the forces of what was solved before, which is a first guess alone
    const HalfspaceSolution pressed = std::exchange(solution, {});
    double                  before = 0, missed_before = 0, missed = 0, not_driven = 0;
    for (int round = 0; round < (load.vertical || yaw != 0 ? most_rounds : 1); ++round)
      {
        const double now = problem.normal_force;
        if (load.vertical && round < 2)
          problem.normal_force = (load.force + solution.fy * s) / c;
        else if (load.vertical && std::abs(missed) >= 0.1 * enough * load.force)
          problem.normal_force = now - missed * (now - before) / (missed - missed_before);
        before        = now;
        missed_before = missed;
        // a force that no friction carries, where all of the patch is known to slide
        problem.fx = load.slides ? -std::copysign(10 * load.force, load.longitudinal)
                                 : -(load.longitudinal - lateral() * std::sin(yaw)) / std::cos(yaw);
        set_slip(sections, means, motion, problem.xi, problem);
        solution = solve_carried(problem, kernels_, round > 0 ? &solution : &pressed);
        if (solution.within_friction)
          problem.xi = solution.xi;
        missed     = vertical() - load.force;
        not_driven = load.rate_held || !solution.within_friction
                       ? 0
                       : -solution.fx * std::cos(yaw) + lateral() * std::sin(yaw) - load.longitudinal;
        if (round > 0 && (!load.vertical || std::abs(missed) < enough * load.force) &&
            std::abs(not_driven) < enough_driven * load.force)
          break;
      }
    if (!solution.within_friction)
      {
        problem.longitudinal_force_given = false;
        problem.xi                       = solution.xi;
      }
    if ((load.vertical && std::abs(missed) > 10 * enough * load.force) ||
        std::abs(not_driven) > 10 * enough * load.force)
      load_not_found();
  }


  void
  PlaneContact::load_not_found()
  {
    solution.coupling_converged = false;
    solution.not_reached += "The normal force that carries the wheel load was not found. ";
  }


  void
  PlaneContact::carry(const WheelRailLoad &load)
  {
    // patch and mean angle hardly change with less: widths go with the cube root of the force
    constexpr double alike         = 0.2;
    constexpr int    most_pressed  = 6;
    double           pressed_under = problem.normal_force, room = 1;
    carry_on_grid(load);
    for (int k = 0; k < most_pressed; ++k)
      {
        const double force = solution.fn;
        if (!(force > 0) ||
            (!solution.touches_grid_edge && std::abs(force - pressed_under) < alike * pressed_under))
          return;
        // tractions may widen a contact that kept off the edge under the same force
        if (solution.touches_grid_edge && force < (1 + alike) * pressed_under)
          room *= 1.5;
        press(force, room);
        pressed_under = force;
        carry_on_grid(load);
      }
    if (std::abs(solution.fn - pressed_under) >= alike * pressed_under)
      load_not_found();
  }


  double
  PlaneContact::lateral() const
  {
    return -solution.fn * std::sin(means.rail_angle) - solution.fy * std::cos(means.rail_angle);
  }


  double
  PlaneContact::vertical() const
  {
    return solution.fn * std::cos(means.rail_angle) - solution.fy * std::sin(means.rail_angle);
  }


  double
  PlaneContact::turn_across(const PatchMeasures &measures) const
  {
    const auto   angle  = [&](const double place) { return std::atan(sections.rail().at(place).slope); };
    const double middle = measures.centre_lateral, half = 0.5 * measures.width;
    return std::abs(angle(middle + half) - angle(middle - half));
  }


  WheelRailSolution
  PlaneContact::result() const
  {
    WheelRailSolution result;
    result.enlargements = enlargements;
    result.solution     = solution;
    result.problem      = problem;
    result.angle        = means.rail_angle;
    result.spin         = std::sin(means.wheel_angle) / sections.geometry().rolling_radius;
    result.lateral      = lateral();
    result.vertical     = vertical();
    result.roll         = sections.geometry().roll;
    result.ahead        = sections.region().ahead;
    result.reference    = contact_reference(sections, means, motion, solution);
    result.patch        = halfspace_patch(solution);
    for (int j = 0; j <= problem.grid.my; ++j)
      result.row_edges.push_back(sections.rail_place(problem.grid.y(j) - 0.5 * problem.grid.dy));
    result.measures = measure_patch(result.patch);
    result.centre   = sections.rail_place(result.measures.centre_lateral);
    result.rail     = sections.geometry().rail;
    result.turn     = turn_across(result.measures);
    std::vector<double> places;
    for (int j = 0; j < problem.grid.my; ++j)
      places.push_back(problem.grid.y(j));
    result.kinks = sections.kinks_under(solution, places);
    return result;
  }
} // namespace wheelrail
