#include <wheelrail/base/format_text.h>
#include <wheelrail/damage/machining.h>
#include <wheelrail/geometry/conicity.h>
#include <wheelrail/model/expected_patch.h>
#include <wheelrail/wear/wear_evolution.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace wheelrail
{
  namespace
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();

    double
    largest(const std::vector<double> &values)
    {
      return *std::max_element(values.begin(), values.end());
    }

    double
    circumference(const TrackSettings &scene)
    {
      return 2 * M_PI * scene.track.nominal_radius;
    }

    /// Turns of each wheel for one passage over the rail that they share.
    double
    turns_of_a_passage(const Scene &scene)
    {
      const WearPlan &plan = scene.wear_plan;
      return plan.line_length / (plan.wheels * circumference(scene));
    }

    /// Passages of the whole plan, or turns of the wheel.
    double
    planned(const Scene &scene, const MixWear &wear)
    {
      const WearPlan &plan = scene.wear_plan;
      return plan.worn == WornBody::wheel ? plan.distance / circumference(scene)
                                          : plan.gross_load * scene.gravity / wear.axle_load;
    }

    double
    conicity_of(const SceneProfiles &profiles, const TrackSettings &scene)
    {
      constexpr double amplitude = 3e-3;
      return equivalent_conicity(
        radius_difference(
          profiles.rail, profiles.wheel, scene.track, RollMode::none, amplitude + 0.5e-3, 0.5e-3),
        amplitude,
        2 * running_circle_distance(scene.track),
        scene.track.nominal_radius);
    }

    /// What is worn off since the last state is as well known as the mean T-gamma there, to which it goes;
    /// what machines took off, exactly.
    Interval
    section_within(const Interval &before, const double lost, const double machined, const WearStep &last)
    {
      const double share = std::max(0., lost - machined) / last.mean_t_gamma;
      return {before.low + machined + share * last.t_gamma_within.low,
              before.high + machined + share * last.t_gamma_within.high};
    }

    WearStep
    measured(const WearState &state, const SceneProfiles &profiles, const Scene &scene, const MixWear &wear)
    {
      const bool alone = scene.wear_plan.worn == WornBody::wheel,
                 both  = scene.wear_plan.worn == WornBody::both;
      WearStep step;
      step.passages        = state.passages;
      step.gross_load      = alone ? none : state.passages * wear.axle_load / scene.gravity;
      const double turn    = circumference(scene);
      step.distance        = alone  ? state.passages * turn
                             : both ? state.passages * turns_of_a_passage(scene) * turn
                                    : none;
      step.rail_depth      = largest(state.rail.depth);
      step.wheel_depth     = largest(state.wheel.depth);
      step.rail_section    = section_between(state.new_rail.points, state.rail.points);
      step.wheel_section   = section_between(state.new_wheel.points, state.wheel.points);
      step.dimensions      = worn_dimensions(state.new_rail, state.rail, state.wheel);
      step.conicity        = conicity_of(profiles, scene);
      step.mean_pressure   = wear.mean_pressure;
      step.peak_pressure   = wear.peak_pressure;
      step.mean_t_gamma    = wear.mean_t_gamma;
      step.peak_t_gamma    = wear.peak_t_gamma;
      step.rail_damage     = largest(state.rail.damage);
      step.wheel_damage    = largest(state.wheel.damage);
      step.rail_cracks     = largest(state.rail.cracks);
      step.wheel_cracks    = largest(state.wheel.cracks);
      step.rail_ground     = state.rail_ground;
      step.wheel_turned    = state.wheel_turned;
      step.pressure_within = wear.pressure_within;
      step.t_gamma_within  = wear.t_gamma_within;
      if (!state.steps.empty())
        {
          const WearStep &last = state.steps.back();
          step.rail_within     = section_within(last.rail_within,
                                            step.rail_section - last.rail_section,
                                            state.rail_ground - last.rail_ground,
                                            last);
          step.wheel_within    = section_within(last.wheel_within,
                                             step.wheel_section - last.wheel_section,
                                             state.wheel_turned - last.wheel_turned,
                                             last);
        }
      step.bodies_low  = wear.bodies_low;
      step.bodies_high = wear.bodies_high;
      step.with_care   = wear.with_care;
      step.not_trusted = wear.not_trusted;
      return step;
    }

    /// Sections of one passage that are taken off, smoothed; nothing from a body that keeps its profile.
    std::vector<double>
    taken(const std::vector<double> &sections,
          const WornShape           &shape,
          const double               times,
          const double               cut_off)
    {
      std::vector<double> smooth = smoothed_sections(arc_of(shape.points), sections, cut_off);
      for (double &section : smooth)
        section *= times;
      return smooth;
    }

    double
    deepest(const std::vector<double> &sections, const WornShape &shape)
    {
      const std::vector<double> cells = cell_lengths(arc_of(shape.points));
      double                    most  = 0;
      for (std::size_t k = 0; k < cells.size(); ++k)
        most = std::max(most, sections[k] / cells[k]);
      return most;
    }

    void
    note(const std::string &sentence, WearState &state)
    {
      if (state.note.find(sentence) == std::string::npos)
        state.note += (state.note.empty() ? "" : " ") + sentence;
    }

    /// The most that a step may take off; says where the scene asks for more.
    double
    step_bound(const Scene &scene, const MixWear &wear, WearState &state)
    {
      const WearPlan &plan  = scene.wear_plan;
      const double    bound = 0.1 * wear.mean_pressure * plan.smoothing / (M_PI * contact_modulus(scene));
      if (plan.step_depth != WearPlan::automatic && plan.step_depth > bound)
        note("Steps are smaller than Wear/Step depth, so that one changes the pressure by a tenth at most.",
             state);
      return std::min(plan.step_depth, bound);
    }

    void
    add_damage(const std::vector<double> &damage,
               const std::vector<double> &cracks,
               const double               passages,
               WornShape                 &shape)
    {
      for (std::size_t k = 0; k < damage.size(); ++k)
        {
          shape.damage[k] += passages * damage[k];
          shape.cracks[k] += passages * cracks[k];
        }
    }

    /// Cracks that a depth takes with it.
    void
    remove_cracks(const std::vector<double> &sections,
                  const double               crack_depth,
                  std::vector<double>       &cracks,
                  const WornShape           &shape)
    {
      const std::vector<double> cells = cell_lengths(arc_of(shape.points));
      for (std::size_t k = 0; k < cells.size(); ++k)
        cracks[k] = std::max(0., cracks[k] - sections[k] / cells[k] / crack_depth);
    }

    constexpr double steepest_rail = 60 * M_PI / 180, steepest_wheel = 80 * M_PI / 180;

    MachiningEvent
    machine(const Scene &scene, const bool of_rail, WearState &state)
    {
      const WearPlan &plan                                   = scene.wear_plan;
      Scene           target                                 = scene;
      (of_rail ? target.rail_profile : target.wheel_profile) = of_rail ? plan.grind_to : plan.turn_to;
      const SceneProfiles       profiles                     = read_profiles(target);
      const std::vector<Point2> points =
        (of_rail ? rail_shape(profiles.rail) : wheel_shape(profiles.wheel)).points;
      WornShape      &shape = of_rail ? state.rail : state.wheel;
      const Machining work  = machining(shape, points, of_rail ? steepest_rail : steepest_wheel);
      for (std::vector<double> *cracks : {&shape.damage, &shape.cracks})
        remove_cracks(work.sections, scene.wear.crack_depth, *cracks, shape);
      take_off(work.sections, shape);
      (of_rail ? state.rail_ground : state.wheel_turned) += work.section;
      ++(of_rail ? state.grindings : state.turnings);
      return {of_rail, work.depth, work.section, work.shift, of_rail ? plan.grind_to : plan.turn_to};
    }

    /// Passages at the next grinding, at the next turning; infinite where there is none.
    struct Stops
    {
      double grinding = std::numeric_limits<double>::infinity(),
             turning  = std::numeric_limits<double>::infinity();
    };

    Stops
    next_stops(const Scene &scene, const MixWear &wear, const WearState &state)
    {
      const WearPlan &plan = scene.wear_plan;
      Stops           stops;
      if (plan.grind_to != "none" && plan.worn != WornBody::wheel)
        stops.grinding = (state.grindings + 1) * plan.grind_every * scene.gravity / wear.axle_load;
      if (plan.turn_to != "none" && plan.worn != WornBody::rail)
        stops.turning = (state.turnings + 1) * plan.turn_every / circumference(scene) /
                        (plan.worn == WornBody::both ? turns_of_a_passage(scene) : 1);
      return stops;
    }
  } // namespace


  WearState
  begin_wear(const SceneProfiles &profiles)
  {
    WearState state;
    state.new_rail = state.rail = rail_shape(profiles.rail);
    state.new_wheel = state.wheel = wheel_shape(profiles.wheel);
    state.files                   = profiles.files;
    return state;
  }


  Verdict
  wear_verdict(const WearState &state)
  {
    Verdict verdict;
    double  care = 0, no = 0;
    for (const WearStep &step : state.steps)
      {
        care = std::max(care, step.with_care);
        no   = std::max(no, step.not_trusted);
      }
    const double share = no > 0 ? no : care;
    const Grade  grade = no > 0 ? Grade::not_trusted : Grade::with_care;
    if (share > 0)
      verdict.findings.push_back(
        {grade,
         text("Up to %.0f %% of the passages are %s, such as ", 100 * share, grade_word(grade).c_str()) +
           state.doubts});
    return verdict;
  }


  std::string
  beside_bodies(const WearState &state)
  {
    const WearStep &first = state.steps.front(), &last = state.steps.back();
    if (!state.finished || !std::isfinite(last.bodies_low))
      return "";
    return text(
      "Peak pressures of these half-spaces are %+.1f to %+.1f %% beside those of the true bodies, on "
      "new and on worn profiles.",
      100 * std::fmin(first.bodies_low, last.bodies_low),
      100 * std::fmax(first.bodies_high, last.bodies_high));
  }


  void
  take_back_last(WearState &state)
  {
    state.finished = false;
    state.steps.pop_back();
    if (wear_verdict(state).findings.empty())
      state.doubts.clear();
  }


  void
  wear_on(const Scene                                       &scene,
          const std::vector<MixRow>                         &rows,
          const std::function<void(const WearState &)>      &keep,
          WearState                                         &state,
          const std::function<void(const MachiningEvent &)> &tell,
          const RowTeam                                     &team)
  {
    const WearPlan &plan = scene.wear_plan;
    while (!state.finished)
      {
        SceneProfiles profiles = profiles_of(state.rail, state.wheel, scene);
        if (state.passages == 0)
          profiles.files = state.files; // their noise is that of all states
        MixWear wear = wear_of_mix(rows, profiles, state.rail, state.wheel, team, state.steps.empty());
        // passages of a place on the rail and on the wheel; a body that does not wear meets ever new ones
        const double over = plan.worn != WornBody::wheel;
        const double turns =
          plan.worn == WornBody::both ? turns_of_a_passage(scene) : plan.worn == WornBody::wheel;
        const auto rail    = taken(wear.rail_section, state.rail, over, plan.smoothing),
                   tread   = taken(wear.wheel_section, state.wheel, turns, plan.smoothing);
        const double depth = std::max(deepest(rail, state.rail), deepest(tread, state.wheel));
        const double left  = planned(scene, wear) - state.passages;
        const Stops  stops = next_stops(scene, wear, state);
        const double stop  = std::min(stops.grinding, stops.turning) - state.passages;
        const bool   event = stop <= 1e-9 * state.passages && left > 1e-9 * state.passages;
        double       steps = depth > 0 ? std::min(left, step_bound(scene, wear, state) / depth) : left;
        if (!event && steps > stop * (1 - 1e-9))
          steps = stop;
        if (left - steps < 1e-9 * left) // no step of a few passages at the end
          steps = left;
        if (steps <= 0 && !state.steps.empty())
          wear = wear_of_mix(rows, profiles, state.rail, state.wheel, team, true);
        if (wear.at_end)
          note("A patch lies on the end of a profile: what lies beyond was not measured, or is not modelled.",
               state);
        if (depth == 0)
          note("Nothing wears: no contact slides under friction.", state);
        const bool distrusted = wear_verdict(state).grade() == Grade::not_trusted;
        if (!wear.doubts.empty() && (state.doubts.empty() || (wear.not_trusted > 0 && !distrusted)))
          state.doubts = wear.doubts;
        state.finished = steps <= 0;
        state.steps.push_back(measured(state, profiles, scene, wear));
        state.steps.back().step_depth = state.finished || event ? 0 : steps * depth;
        keep(state);
        if (state.finished)
          return;
        if (event)
          {
            for (const bool of_rail : {true, false})
              if ((of_rail ? stops.grinding : stops.turning) - state.passages <= 1e-9 * state.passages)
                if (const MachiningEvent done = machine(scene, of_rail, state); tell)
                  tell(done);
            continue;
          }
        const auto scaled = [&](std::vector<double> sections) {
          for (double &section : sections)
            section *= steps;
          return sections;
        };
        add_damage(wear.rail_damage, wear.rail_cracks, steps * over, state.rail);
        add_damage(wear.wheel_damage, wear.wheel_cracks, steps * turns, state.wheel);
        remove_cracks(scaled(rail), scene.wear.crack_depth, state.rail.cracks, state.rail);
        remove_cracks(scaled(tread), scene.wear.crack_depth, state.wheel.cracks, state.wheel);
        take_off(scaled(rail), state.rail);
        take_off(scaled(tread), state.wheel);
        state.passages += steps;
      }
  }
} // namespace wheelrail
