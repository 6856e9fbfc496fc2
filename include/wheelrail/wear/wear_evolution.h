#pragma once

#include <wheelrail/wear/wear_mix.h>
#include <wheelrail/wear/worn_profiles.h>

#include <functional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// What is known at one state of the profiles [SI].
  struct WearStep
  {
    double passages   = 0; ///< of wheels over the rail, or turns of the wheel where it wears alone
    double gross_load = 0, distance = 0; ///< that passed the rail [kg], that a wheel rolled [m]; or NaN
    double step_depth = 0; ///< largest depth that the step from here takes off [m]; 0 at the end
    double rail_depth = 0, wheel_depth = 0;     ///< largest so far, along the normals [m]
    double rail_section = 0, wheel_section = 0; ///< worn off so far [m2]
    WornDimensions dimensions;
    double         conicity      = 0;                    ///< equivalent, at 3 mm amplitude, or NaN
    double         mean_pressure = 0, peak_pressure = 0; ///< as those of MixWear
    double         mean_t_gamma = 0, peak_t_gamma = 0;
    Interval       pressure_within{0, 0}, t_gamma_within{0, 0}; ///< of both means, as those of MixWear
    Interval       rail_within{0, 0}, wheel_within{0, 0}; ///< of the sections, each step's as its T-gamma's
    double         rail_damage = 0, wheel_damage = 0;     ///< largest so far, shares of a life
    double         rail_cracks = 0, wheel_cracks = 0;     ///< the same of crack growth less wear
    double         rail_ground = 0, wheel_turned = 0;     ///< taken off by machines so far [m2]
    double         bodies_low = 0, bodies_high = 0; ///< as those of MixWear, of the first and the last state
    double         with_care = 0, not_trusted = 0;  ///< shares of passages, as those of MixWear
  };

  /// Profiles after a part of the plan, from which it resumes.
  struct WearState
  {
    WornShape             new_rail, new_wheel; ///< as they began
    WornShape             rail, wheel;
    double                passages    = 0;
    double                rail_ground = 0, wheel_turned = 0; ///< taken off by machines so far [m2]
    unsigned int          grindings = 0, turnings = 0;
    std::vector<WearStep> steps;            ///< of all states so far
    bool                  finished = false; ///< the plan is done
    std::string           doubts;           ///< of the worst state so far, see MixWear; empty: all is trusted
    std::string           note;             ///< sentences on what was found, or nothing
    FileProfiles          files = {};       ///< from which it began
  };

  /// How much of the traffic is not trusted, in the worst state, and why; nothing where all of it is.
  Verdict
  wear_verdict(const WearState &state);

  /// How far peak pressures of half-spaces are from those of the true bodies, of the first and the last state
  /// of a plan that is done, as a sentence; nothing where that is not known.
  std::string
  beside_bodies(const WearState &state);

  /// Forgets what was found in the last state, so that wear_on() computes it again and continues, be it to
  /// the end of a longer plan.
  void
  take_back_last(WearState &state);

  /// Profiles as they are new.
  WearState
  begin_wear(const SceneProfiles &profiles);

  /// A grinding or turning that has just been done.
  struct MachiningEvent
  {
    bool        of_rail = true;
    double      depth = 0, section = 0, shift = 0; ///< as those of Machining
    std::string to;                                ///< the target's name
  };

  /// Wears the profiles as the scene's subsection Wear plans, step by step: half-spaces for all rows on the
  /// profiles as they are, the worn sections of a passage smoothed (smoothed_sections()), and as many
  /// passages as take off at most 0.1 p lambda / (pi E*), with the mean peak pressure p, the cut-off
  /// wavelength lambda and 1 / E* = (1 - nu1^2) / E1 + (1 - nu2^2) / E2: a wave of that amplitude changes the
  /// pressure of flat surfaces by p / 10. Steps end where Wear/Grind every or Wear/Turn every asks for a
  /// machine: the state there is kept, machining() takes off what is beyond the target, `tell` gets how much,
  /// and the state behind it is kept as well; none at the very end. Net cracks grow by crack_growth() and
  /// lose the depth that is taken off over the crack depth, down to nothing. `keep` gets each state, before
  /// the step that follows. Collective among the processes of `team`, which all get the same states. Throws
  /// InputError where profiles do not touch (any more).
  void
  wear_on(const Scene                                       &scene,
          const std::vector<MixRow>                         &rows,
          const std::function<void(const WearState &)>      &keep,
          WearState                                         &state,
          const std::function<void(const MachiningEvent &)> &tell = {},
          const RowTeam                                     &team = {});
} // namespace wheelrail
