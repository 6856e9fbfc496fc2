#include <wheelrail/model/expected_patch.h>
#include <wheelrail/reference/halfspace_case.h>
#include <wheelrail/reference/halfspace_parts.h>
#include <wheelrail/reference/wheel_load.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// The normal problem alone, on a grid that is enlarged until the contact keeps off its edge.
    HalfspaceSolution
    solve_pressure(const Scene           &scene,
                   const ContactSections &sections,
                   HalfspaceProblem      &problem,
                   int                   &enlargements)
    {
      // a first grid: interpenetration at 0.55 of the approach has about the size of the patch (Kik and
      // Piotrowski, 1996), the rest is room for it to grow
      const double approach = 0.75 * expected_approach(scene, sections.geometry().rolling_radius) *
                              std::pow(std::max(1., problem.normal_force / expected_load(scene)), 2. / 3);
      const auto lay_grid = [&](const double reached, const double element) {
        problem.grid = sections.grid(reached, element);
        sections.set_distance(problem);
      };
      return solve_on_growing_grid(
        problem, approach, scene.halfspace_element_size, 6, lay_grid, enlargements);
    }

    WheelMotion
    wheel_motion(const Scene &scene)
    {
      const bool given = std::isfinite(scene.halfspace_given_spin);
      return {given || scene.halfspace_spin == HalfspaceSpin::contact,
              given ? scene.halfspace_given_spin : std::nan(""),
              lateral_creepage(scene)};
    }

    /// Forces on the wheel along X and upwards [N]. The contact plane is inclined by the mean angle of the
    /// rail.
    double
    lateral_force(const HalfspaceSolution &solution, const PressureMeans &means)
    {
      return -solution.fn * std::sin(means.rail_angle) - solution.fy * std::cos(means.rail_angle);
    }
    double
    vertical_force(const HalfspaceSolution &solution, const PressureMeans &means)
    {
      return solution.fn * std::cos(means.rail_angle) - solution.fy * std::sin(means.rail_angle);
    }

    /// Solves the problem under its load. The lateral traction carries a part of a vertical load: on the
    /// tread it hardly depends on the normal force, on the flange it grows with it, so that secants have to
    /// find the balance. What drives acts along the wheelset, so that with yaw the lateral force takes a part
    /// of it.
    HalfspaceSolution
    solve_loaded(const ContactSections &sections,
                 const PressureMeans   &means,
                 const WheelMotion     &motion,
                 const WheelRailLoad   &load,
                 HalfspaceProblem      &problem)
    {
      constexpr int    most_rounds = 12;
      constexpr double enough = 1e-3, enough_driven = 1e-4; // of the load
      const double     c = std::cos(means.rail_angle), s = std::sin(means.rail_angle);
      const double     yaw             = sections.geometry().yaw;
      problem.motion                   = HalfspaceMotion::steady;
      problem.longitudinal_force_given = !load.rate_held;
      problem.xi                       = load.rate_held ? load.creepage : 0;
      HalfspaceSolution solution;
      double            before = 0, missed_before = 0, missed = 0, not_driven = 0;
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
                                   : -(load.longitudinal - lateral_force(solution, means) * std::sin(yaw)) /
                                       std::cos(yaw);
          set_slip(sections, means, motion, problem.xi, problem);
          solution = solve_carried(problem);
          if (solution.within_friction)
            problem.xi = solution.xi;
          missed     = vertical_force(solution, means) - load.force;
          not_driven = load.rate_held || !solution.within_friction
                         ? 0
                         : -solution.fx * std::cos(yaw) + lateral_force(solution, means) * std::sin(yaw) -
                             load.longitudinal;
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
        {
          solution.coupling_converged = false;
          solution.not_reached += "The normal force that carries the wheel load was not found. ";
        }
      return solution;
    }

    /// Between the edges of the patch [rad].
    double
    turn_across(const ContactSections &sections, const PatchMeasures &measures)
    {
      const auto   angle  = [&](const double place) { return std::atan(sections.rail().at(place).slope); };
      const double middle = measures.centre_lateral, half = 0.5 * measures.width;
      return std::abs(angle(middle + half) - angle(middle - half));
    }
  } // namespace


  WheelRailLoad
  scene_load(const Scene &scene, const SceneGeometry &geometry)
  {
    WheelRailLoad load;
    load.force        = static_wheel_load(scene, geometry);
    load.vertical     = true;
    load.longitudinal = scene.traction_coefficient * load.force;
    load.rate_held    = scene.drive == Drive::rate;
    load.creepage     = scene.creepage;
    return load;
  }


  SectionOffsets
  scene_offsets(const Scene &scene)
  {
    return {scene.halfspace_lateral, -scene.halfspace_inclination, 0};
  }


  WheelRailSolution
  solve_wheel_rail(const Scene          &scene,
                   const SceneGeometry  &geometry,
                   const WheelRailLoad  &load,
                   const SectionOffsets &offsets)
  {
    const auto            begin = std::chrono::steady_clock::now();
    const ContactSections sections(geometry, offsets);
    HalfspaceProblem      problem = halfspace_problem(scene);
    problem.normal_force          = load.force;

    WheelRailSolution   result;
    const PressureMeans means =
      pressure_means(sections, solve_pressure(scene, sections, problem, result.enlargements));
    result.solution  = solve_loaded(sections, means, wheel_motion(scene), load, problem);
    result.angle     = means.rail_angle;
    result.problem   = problem;
    result.spin      = std::sin(means.wheel_angle) / sections.geometry().rolling_radius;
    result.lateral   = lateral_force(result.solution, means);
    result.vertical  = vertical_force(result.solution, means);
    result.roll      = geometry.contact.roll;
    result.ahead     = geometry.contact.ahead;
    result.reference = contact_reference(sections, means, wheel_motion(scene), result.solution);
    result.patch     = halfspace_patch(result.solution);
    result.measures  = measure_patch(result.patch);
    result.turn      = turn_across(sections, result.measures);
    result.time      = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
  }


  HalfspacePressure
  halfspace_pressure(const Scene          &scene,
                     const SceneGeometry  &geometry,
                     const double          normal_force,
                     const SectionOffsets &offsets)
  {
    const ContactSections sections(geometry, offsets);
    HalfspaceProblem      problem = halfspace_problem(scene);
    problem.normal_force          = normal_force;
    int                     ignored;
    const HalfspaceSolution solution = solve_pressure(scene, sections, problem, ignored);
    const PatchMeasures     measures = measure_patch(halfspace_patch(solution));
    return {solution.peak_pressure,
            solution.approach,
            measures.width,
            measures.length,
            turn_across(sections, measures)};
  }


  HalfspacePressure
  halfspace_pressure(const WheelRailSolution &result)
  {
    return {result.solution.peak_pressure,
            result.solution.approach,
            result.measures.width,
            result.measures.length,
            result.turn};
  }


  namespace
  {
    void
    add_reference(const Scene             &scene,
                  const WheelRailSolution &result,
                  const bool               determined,
                  Summary                 &summary)
    {
      if (!result.reference)
        return;
      const ContactReference &at = *result.reference;
      const auto   set       = [&](const char *key, const double value) { set_figure(summary, key, value); };
      const double of_motion = determined ? 1 : Summary::none;
      set("yaw_rad", wheelset_pose(scene).yaw);
      set("wheelset_roll_rad", result.roll);
      set("reference_lateral_m", at.place.x);
      set("reference_vertical_m", at.place.y);
      set("reference_along_m", at.along);
      set("reference_ahead_of_axle_m", at.ahead);
      set("reference_angle_rad", at.angle);
      set("reference_creepage", of_motion * at.creepage);
      set("reference_lateral_creepage", of_motion * at.lateral_creepage);
      set("reference_spin_per_m", of_motion * at.spin);
      set("reference_spin_moment_Nm", at.spin_moment);
      set("tangential_lateral_force_N", at.traction);
      set("wheelset_longitudinal_force_N", at.driving);
      set("wheelset_lateral_force_N", at.across);
      set("drive_torque_Nm", at.torque);
      set("yaw_moment_Nm", at.yaw_moment);
    }
  } // namespace


  Summary
  halfspace_summary(const Scene &scene, const WheelRailSolution &result)
  {
    const HalfspaceSolution &s = result.solution;
    Summary                  summary;
    summary.title                     = scene.title;
    summary.program_version           = WHEELRAIL_VERSION;
    summary.normal_force              = s.fn;
    summary.vertical_force            = result.vertical;
    summary.longitudinal_force        = -s.fx;
    summary.lateral_force             = result.lateral;
    summary.max_pressure              = s.peak_pressure;
    summary.max_pressure_fitted       = result.measures.peak_pressure_fitted;
    summary.contact_area              = result.measures.area;
    summary.patch_lateral             = result.measures.width;
    summary.patch_longitudinal        = result.measures.length;
    summary.patch_centre_lateral      = result.measures.centre_lateral;
    summary.patch_centre_longitudinal = result.measures.centre_along + result.ahead;
    summary.max_shear_traction        = result.measures.max_traction;
    summary.stick_fraction            = result.measures.stick_fraction;
    // a wheel that spins up has no steady creepage, and without friction there is none to find
    const bool determined        = !frictionless(result.problem.friction) && (s.within_friction || s.xi < 0);
    summary.creepage             = determined ? s.xi : Summary::none;
    summary.friction_coefficient = scene.friction_coefficient;
    summary.velocity             = scene.velocity;
    summary.elements             = s.contact_elements;
    summary.wall_time            = result.time;
    summary.further              = {{"approach_m", s.approach},
                                    {"spin_per_m", result.spin},
                                    {"contact_angle_rad", -result.angle},
                                    {"area_of_whole_elements_m2", s.area},
                                    {"grid_spacing_m", s.grid.dx},
                                    {"grid_elements_along", double(s.grid.mx)},
                                    {"grid_elements_lateral", double(s.grid.my)}};
    add_reference(scene, result, determined, summary);
    // a wheel that spins up slides as fast as it likes
    const bool   at_rest = frictionless(result.problem.friction);
    const double t_gamma = determined || at_rest ? s.creepage_work : Summary::none;
    set_figure(summary, "t_gamma_N", t_gamma);
    set_figure(summary, "frictional_power_W", t_gamma * scene.velocity);
    summary.finished    = s.converged() && !s.touches_grid_edge;
    summary.stop_reason = s.not_reached;
    if (!s.within_friction)
      summary.note = sliding_note(-s.fx);
    if (scene.drive == Drive::torque && scene.friction_coefficient > 0)
      set_figure(summary, "traction_over_friction", scene.traction_coefficient / scene.friction_coefficient);
    if (s.touches_grid_edge)
      summary.stop_reason += "The contact reaches the edge of the profiles or of the grid.";
    return summary;
  }
} // namespace wheelrail
