#include <wheelrail/base/format_text.h>
#include <wheelrail/damage/wear_profile.h>
#include <wheelrail/geometry/track.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/model/section_file.h>
#include <wheelrail/output/figures.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/scene/steels.h>
#include <wheelrail/verdict/rules.h>
#include <wheelrail/verdict/verdict.h>
#include <wheelrail/wheel/contact_intervals.h>
#include <wheelrail/wheel/contact_reference.h>
#include <wheelrail/wheel/halfspace_case.h>
#include <wheelrail/wheel/halfspace_parts.h>
#include <wheelrail/wheel/several_patches.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// Whether a patch slides as a whole.
    bool
    slides(const HalfspaceSolution &s)
    {
      return s.adhesion_area == 0 && s.slip_area > 0;
    }

    /// How far the elements reach in a result: its interval by them, or what twice their size changes.
    double
    reach(const char *result, const bool as_interval, const Contributions &contributions)
    {
      double shift = 0, squares = 0;
      for (const Contribution &one : contributions)
        if (one.result == result &&
            (one.cause == "elements" || (as_interval && one.cause == "place of elements")))
          {
            shift += one.shift;
            squares += one.spread * one.spread;
          }
      const double spread = std::sqrt(squares);
      return std::abs(shift) + (as_interval ? 1 : 0.5) * spread;
    }

    /// How well the creepage that was found is known, or the forces of a creepage that was given, the vector
    /// over it.
    Known
    known_creep(const WheelRailSolution &result, const Contributions &contributions)
    {
      // Below these neither creepage nor force matters: for intervals a quarter of what friction carries and
      // of the creepage at its half, for what elements of twice the size change far less.
      constexpr double         least = 0.25, least_creepage = 2e-5, least_force = 0.01;
      const HalfspaceSolution &s = result.solution;
      if (result.problem.friction.frictionless() || result.problem.motion == HalfspaceMotion::none)
        return {};
      const double bound = result.problem.friction.at(0) * s.fn, force = std::hypot(s.fx, s.fy);
      const double half   = half_saturation(result.problem, s, result.measures);
      const auto   vector = [&](const bool as_interval, const double share) {
        return std::hypot(reach("longitudinal_force", as_interval, contributions),
                          reach("lateral_force", as_interval, contributions)) /
               std::max(force, share * bound);
      };
      Known known = known_within("creepage", s.xi, least * half, contributions);
      for (const double within :
           {reach("creepage", false, contributions) / std::max(std::abs(s.xi), least_creepage),
            vector(true, least),
            vector(false, least_force)})
        if (!(within <= known.within))
          known = {within, "elements"};
      return known;
    }

    /// From the least to the largest inclination that the patches reach [rad].
    double
    turn_across_all(const WheelRailSolution &result)
    {
      double least = result.angle - 0.5 * result.turn, largest = result.angle + 0.5 * result.turn;
      for (const WheelRailSolution &other : result.others)
        {
          least   = std::min(least, other.angle - 0.5 * other.turn);
          largest = std::max(largest, other.angle + 0.5 * other.turn);
        }
      return largest - least;
    }

    /// The verdict of one patch by its pressure, edges, elements and steel; `turn`: of the surfaces across
    /// the contact [rad], `contributions`: what is known of its results, `all_slide`: of all patches.
    Verdict
    judge_with(const Scene             &scene,
               const WheelRailSolution &result,
               const double             turn,
               const Contributions     &contributions,
               const bool               all_slide)
    {
      Measures measures;
      measures.wanted        = scene.wanted_accuracy;
      measures.element       = result.solution.grid.dx;
      measures.peak_pressure = result.solution.peak_pressure;
      measures.made_up       = result.made_up;
      measures.shift_effect  = result.shift_effect;
      measures.bodies_effect = result.bodies_effect;
      measures.unheld        = result.unheld;
      if (scene.halfspace_bodies != ContactBodies::real)
        measures.turn = turn;
      if (result.reference)
        measures.place = place_in_words(result.reference->place.x);
      measures.contact_modulus = contact_modulus(scene);
      measures.edge            = result.kinks.edge;
      measures.notch           = result.kinks.notch;
      measures.peak = known_within("max_pressure", result.solution.peak_pressure, 1, contributions);
      if (!result.problem.force_given) // the force is a result, too
        if (const Known force = known_within("normal_force", result.solution.fn, 1, contributions);
            force.within > measures.peak.within)
          measures.peak = force;
      measures.creep = known_creep(result, contributions);
      // what sticks is as stiff as the whole elements are larger than the contact
      const double whole =
        result.problem.motion == HalfspaceMotion::none
          ? 0
          : (result.solution.area / result.measures.area - 1) * result.measures.stick_fraction;
      if (whole > measures.creep.within || (std::isnan(measures.creep.within) && whole > 0))
        measures.creep = {whole, "elements"};
      if (!result.solution.within_friction ||
          (all_slide && scene.drive == Drive::torque && scene.traction_coefficient != 0))
        measures.slides = sliding_note(-result.solution.fx, result.solution.within_friction);
      measures.yields = steel_doubt(scene,
                                    result.solution.peak_pressure,
                                    std::hypot(result.solution.fx, result.solution.fy) / result.solution.fn,
                                    false);
      return judge_halfspaces(measures);
    }

    void
    add_reference(const WheelsetSettings  &scene,
                  const WheelRailSolution &result,
                  const bool               determined,
                  Summary                 &summary)
    {
      if (!result.reference)
        return;
      const ContactReference &at = *result.reference;
      const auto set = [&](const char *key, const double value) { set_figure(summary, key, value); };
      set("yaw_rad", wheelset_pose(scene).yaw);
      set("wheelset_roll_rad", result.roll);
      set("reference_lateral_m", at.place.x);
      set("reference_vertical_m", at.place.y);
      set("reference_along_m", at.along);
      set("reference_radius_m", at.radius);
      set_reference_figures(at, determined, summary);
      set("reference_spin_moment_Nm", at.spin_moment);
      set("tangential_lateral_force_N", at.traction);
      set("wheelset_longitudinal_force_N", at.driving);
      set("wheelset_lateral_force_N", at.across);
      set("drive_torque_Nm", at.torque);
      set("yaw_moment_Nm", at.yaw_moment);
    }

    Summary
    summary_of_patch(const Scene &scene, const WheelRailSolution &result)
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
      summary.creepage                  = steady_creepage(result);
      const bool determined             = std::isfinite(summary.creepage);
      summary.friction_coefficient      = scene.friction.at(0);
      summary.velocity                  = scene.velocity;
      summary.elements                  = s.contact_elements;
      summary.wall_time                 = result.time;
      summary.further                   = {{"approach_m", s.approach},
                                           {"spin_per_m", result.spin},
                                           {"contact_angle_rad", -result.angle},
                                           {"area_of_whole_elements_m2", s.area},
                                           {"grid_spacing_m", s.grid.dx},
                                           {"grid_elements_along", double(s.grid.mx)},
                                           {"grid_elements_lateral", double(s.grid.my)}};
      if (result.centre)
        set_patch_place(head_place(result.rail, scene.track, *result.centre), summary);
      add_reference(scene, result, determined, summary);
      // a wheel that spins up slides as fast as it likes
      const bool   at_rest = result.problem.friction.frictionless();
      const double t_gamma = determined || at_rest ? wear_number(result.problem, s) : Summary::none;
      set_figure(summary, "t_gamma_N", t_gamma);
      set_figure(summary, "creepage_work_N", determined || at_rest ? s.creepage_work : Summary::none);
      set_figure(summary, "friction_work_N", determined || at_rest ? s.friction_work : Summary::none);
      set_figure(summary, "frictional_power_W", t_gamma * scene.velocity);
      set_wear_figures(determined || at_rest
                         ? halfspace_wear(result.problem, result.solution, scene.velocity, scene.wear)
                         : WearProfile(),
                       std::hypot(s.fx, s.fy),
                       yield_strength(scene.rail_material),
                       scene.wear,
                       summary);
      summary.finished    = s.converged() && !s.touches_grid_edge;
      summary.stop_reason = s.not_reached;
      if (scene.drive == Drive::torque && scene.friction.at(0) > 0)
        set_figure(summary, "traction_over_friction", scene.traction_coefficient / scene.friction.at(0));
      if (s.touches_grid_edge)
        summary.stop_reason += "The contact reaches the edge of the profiles or of the grid.";
      return summary;
    }

    /// The patch as the program CONTACT tells it, under "patch_2_..." [SI].
    void
    add_patch(const Summary &patch, const std::size_t number, Summary &summary)
    {
      const std::string before = patch_prefix(number);
      for (const std::string &key :
           split_list("normal_force_N, longitudinal_force_N, tangential_lateral_force_N, "
                      "reference_angle_rad, reference_lateral_m, reference_ahead_of_axle_m, "
                      "reference_creepage, reference_lateral_creepage, reference_spin_per_m, "
                      "max_pressure_Pa, contact_area_m2, stick_fraction, t_gamma_N, "
                      "patch_centre_from_axis_m, patch_centre_from_gauge_face_m, patch_centre_below_top_m"))
        set_figure(summary, before + key, get_figure(patch, key));
    }

    /// Forces, areas and work of all patches.
    void
    add_up(const std::vector<Summary> &patches, Summary &total)
    {
      for (const std::string &key :
           split_list("normal_force_N, vertical_force_N, longitudinal_force_N, lateral_force_N, "
                      "contact_area_m2, elements, area_of_whole_elements_m2, wheelset_longitudinal_force_N, "
                      "wheelset_lateral_force_N, drive_torque_Nm, yaw_moment_Nm, t_gamma_N, creepage_work_N, "
                      "friction_work_N, frictional_power_W, archard_section_m2"))
        {
          double sum = 0;
          for (const Summary &patch : patches)
            sum += get_figure(patch, key);
          set_figure(total, key, sum);
        }
      std::vector<std::string> largest = {
        "max_pressure_Pa", "max_pressure_fitted_Pa", "max_shear_traction_Pa"};
      largest.insert(largest.end(), worst_wear_keys().begin(), worst_wear_keys().end());
      for (const std::string &key : largest)
        for (const Summary &patch : patches)
          if (const double value = get_figure(patch, key); std::isfinite(value))
            set_figure(total, key, std::max(get_figure(total, key), value));
      total.stick_fraction = 0;
      total.finished       = true;
      total.stop_reason.clear();
      for (const Summary &patch : patches)
        {
          total.stick_fraction += patch.stick_fraction * patch.contact_area / total.contact_area;
          total.finished = total.finished && patch.finished;
          total.stop_reason += patch.stop_reason;
        }
    }
    struct KnownPatch
    {
      const WheelRailSolution *solution;
      Summary                  summary;
      Contributions            contributions;
    };

    Contributions
    contributions_of(const Scene &scene, const WheelRailSolution &patch, const Summary &summary)
    {
      Contributions       contributions = element_contributions(patch);
      const Contributions noise         = noise_contributions(
        patch.noise_effect, summary, half_saturation(patch.problem, patch.solution, patch.measures));
      contributions.insert(contributions.end(), noise.begin(), noise.end());
      Measures measures;
      measures.contact_modulus = contact_modulus(scene);
      measures.peak_pressure   = summary.max_pressure;
      if (!without_bound(measures, patch.kinks.edge))
        return contributions;
      return without_results(std::move(contributions),
                             {"max_pressure", "max_pressure_fitted", "max_shear_traction"});
    }

    std::vector<KnownPatch>
    all_patches(const Scene &scene, const WheelRailSolution &result)
    {
      std::vector<KnownPatch> patches;
      const auto              add = [&](const WheelRailSolution &patch) {
        const Summary summary = summary_of_patch(scene, patch);
        patches.push_back({&patch, summary, contributions_of(scene, patch, summary)});
      };
      add(result);
      for (const WheelRailSolution &other : result.others)
        add(other);
      return patches;
    }

    /// How patches share the load is a matter of position and angles, as where one reaches round the corner:
    /// all of them are judged by the turn from one to the other.
    Verdict
    judge_patches(const Scene &scene, const std::vector<KnownPatch> &patches)
    {
      const double turn      = turn_across_all(*patches.front().solution);
      const bool   all_slide = std::all_of(patches.begin(), patches.end(), [](const KnownPatch &patch) {
        return slides(patch.solution->solution);
      });
      Verdict      verdict;
      for (const KnownPatch &patch : patches)
        for (const Finding &finding :
             judge_with(scene, *patch.solution, turn, patch.contributions, all_slide).findings)
          add_finding(finding, verdict);
      return verdict;
    }
  } // namespace


  Verdict
  judge_patch(const Scene &scene, const WheelRailSolution &result)
  {
    return judge_with(scene,
                      result,
                      result.turn,
                      contributions_of(scene, result, summary_of_patch(scene, result)),
                      slides(result.solution));
  }


  namespace
  {
    /// Frictional power and the worn section go with the friction work, and so with what is known of
    /// T-gamma; the section with slip and pressure of single elements, too, which hide a trend over their
    /// size.
    Contributions
    with_friction_work(const Contributions &contributions, const Summary &results)
    {
      constexpr double of_elements = 4; // over those across the patch
      Contributions    all         = contributions;
      const auto value = [&](const char *name) { return get_figure(results, figure_named(name).key()); };
      const auto add   = [&](const char *name, const bool shifts) {
        if (const double share = value(name) / value("t_gamma"); std::isfinite(share))
          for (const Contribution &one : contributions)
            if (one.result == "t_gamma")
              all.push_back({name, one.cause, shifts ? share * one.shift : 0, share * one.spread});
      };
      add("frictional_power", true);
      add("archard_section", false);
      const double across =
        std::min(results.patch_lateral, results.patch_longitudinal) / get_figure(results, "grid_spacing_m");
      if (const double spread = of_elements / across * value("archard_section"); std::isfinite(spread))
        all.push_back({"archard_section", "place of elements", 0, spread});
      return all;
    }
  } // namespace


  Summary
  halfspace_summary(const Scene &scene, const WheelRailSolution &result, Contributions *contributions)
  {
    const std::vector<KnownPatch> patches = all_patches(scene, result);
    std::vector<Summary>          summaries;
    std::vector<Contributions>    of_patches;
    for (const KnownPatch &patch : patches)
      {
        summaries.push_back(patch.summary);
        of_patches.push_back(patch.contributions);
      }
    Summary total =
      *std::max_element(summaries.begin(), summaries.end(), [](const Summary &a, const Summary &b) {
        return a.normal_force < b.normal_force;
      });
    if (summaries.size() > 1)
      {
        add_up(summaries, total);
        total.wall_time = result.time;
        set_figure(total, "patches", summaries.size());
        for (std::size_t k = 0; k < summaries.size(); ++k)
          add_patch(summaries[k], k + 1, total);
      }
    if (std::isfinite(result.noise_effect.peak))
      set_figure(total, "noise_effect_max_pressure", result.noise_effect.peak);
    if (total.vertical_force > 0)
      set_figure(total, "lateral_over_vertical", total.lateral_force / total.vertical_force);
    for (const auto &[key, value] : result.bodies)
      set_figure(total, "bodies_" + key, value);
    const Contributions joined =
      with_friction_work(joined_contributions(of_patches, summaries, total), total);
    set_intervals(joined, total);
    if (contributions)
      *contributions = joined;
    set_verdict(total, judge_patches(scene, patches));
    return total;
  }
} // namespace wheelrail
