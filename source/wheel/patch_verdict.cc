#include <wheelrail/model/expected_patch.h>
#include <wheelrail/wheel/contact_intervals.h>
#include <wheelrail/wheel/patch_verdict.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Whether a patch under a force that is asked for slides as a whole, or as good as.
    bool
    slides(const WheelsetSettings &scene, const HalfspaceSolution &s)
    {
      return !s.within_friction || (scene.drive == Drive::torque && scene.traction_coefficient != 0 &&
                                    s.adhesion_area == 0 && s.slip_area > 0);
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
  } // namespace


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


  Verdict
  judge_with(const Scene             &scene,
             const WheelRailSolution &result,
             const double             turn,
             const Contributions     &contributions)
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
    measures.peak            = known_within("max_pressure", result.solution.peak_pressure, 1, contributions);
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
    if (slides(scene, result.solution))
      measures.slides = sliding_note(-result.solution.fx);
    measures.yields = steel_doubt(scene,
                                  result.solution.peak_pressure,
                                  std::hypot(result.solution.fx, result.solution.fy) / result.solution.fn,
                                  false);
    return judge_halfspaces(measures);
  }
} // namespace wheelrail
