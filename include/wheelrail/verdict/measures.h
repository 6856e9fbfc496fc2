#pragma once

#include <wheelrail/output/summary.h>
#include <wheelrail/scene/scene.h>
#include <wheelrail/verdict/interval.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace wheelrail
{
  /// What is known of a result and decides how far it can be trusted. NaN: not known, and not judged.
  struct Measures
  {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    // what resolves the patch
    double cells             = none; ///< solution cells over the shorter extent of the patch
    double expected_loss     = none; ///< what was expected of lost() before the run
    double cells_across_peak = none; ///< and across its highest pressure, see PatchMeasures::cells_across
    double between_nodes     = none; ///< rise of the pressure there, see PatchMeasures::between_nodes
    double penetration       = none; ///< of the penalty law at the peak, over the approach
    double wanted            = 0.05; ///< Scene::wanted_accuracy
    double element           = none; ///< size of elements of half-spaces [m]
    Known  peak, creep;              ///< intervals of the peak pressure, and of creepage or creep forces
    double edge = 0, notch = 0;      ///< sharpest ones of the surfaces in the patch [rad], see SurfaceKinks
    double edge_on_path    = 0;      ///< that one where the largest pressure of the path acts [rad]
    double contact_modulus = none;   ///< E* of the bodies [Pa]
    std::string slides; ///< of a patch that slides as a whole, see sliding_note(); empty: it does not

    // steadiness over the stretch of the means
    double      unsteadiness   = none; ///< largest std of vertical and longitudinal force over vertical force
    double      pressure_noise = none; ///< std of the fitted peak pressure over its mean
    double      swing          = none; ///< of the means over 2 mm about their trend, see Settling
    double      drift          = none; ///< change over the stretch that is more than noise, see Settling
    double      settled_after  = none; ///< [m]; infinity where a figure never settles
    double      means_from     = none; ///< where the means begin [m]
    std::string swing_of, drift_of;    ///< the figures with the largest ones

    // over irregular surfaces, where nothing is steady
    double load_share = none; ///< vertical force of the stretch of the means over the wheel load
    double force_at   = none; ///< where the largest vertical force of the path acts [m]
    double path_end   = none; ///< [m]
    /// Where the largest force on the second of two rails acts [m].
    double second_rail_force_at = none;

    // balances
    double energy_error = none; ///< over strain plus dissipated energy
    double load_miss    = none; ///< mean vertical force over static load, less 1
    double torque_miss  = none; ///< mean longitudinal force less what the torque asks, over the latter

    // what the patch bears, and on what
    double      peak_pressure = none; ///< [Pa]
    std::string yields;  ///< of an elastic body beyond shakedown, see steel_doubt(); empty: none is
    std::string place;   ///< of the patch, in words: "31.2 mm to the gauge side of ..."; may be empty
    std::string made_up; ///< part of a profile that was not measured and is touched; empty: none

    // against half-spaces
    double peak_difference = none; ///< (run - half-space) / half-space
    /// The same against the true bodies under the same forces; they know neither flow nor irregularities.
    double bodies_difference = none;
    double beside            = none; ///< share of the load that they carry beside the patch of the run
    double margin            = none; ///< Mesh/Fine margin that has solution cells there [m]
    /// Longitudinal force less that of the true bodies with the same creepage, over the vertical force.
    double      force_difference = none;
    double      turn             = none; ///< of the surfaces across the patch [rad]
    double      shift_effect     = none; ///< of half-spaces, see shift_effect()
    double      bodies_effect    = none; ///< peak of half-spaces over that of the true bodies, less 1
    std::string unheld; ///< why half-spaces are not held against true bodies, or not all; empty: they are
    double      pose_effect    = none; ///< peak with the pose over peak without it, less 1
    double      plastic_strain = 0;    ///< largest one of the run, 0 where nothing has flowed
    double      patches        = 1;    ///< separate ones of the run, where the half-spaces have not as many
    std::vector<std::string> beyond;   ///< other figures that differ by more than their limit, in words
    std::string              no_reference; ///< why there are no half-spaces to compare with; empty: there are

    /// What an edge adds to the peak, over it, with each halving of the elements: E* edge ln 2/(2 pi).
    double
    growth(const double angle) const
    {
      return angle > 0 ? contact_modulus * angle * M_LN2 / (2 * M_PI) / peak_pressure : 0;
    }

    /// Whether steel has flowed, so that elastic bodies are no reference.
    bool
    has_yielded() const
    {
      return plastic_strain > 1e-4;
    }

    /// Whether the wheel hardly touches the rail where the means are taken, so that its patch is no measure.
    bool
    off_rail() const
    {
      return load_share < 0.1;
    }

    /// What the penalty contact takes from the peak, about: a layer of springs between the bodies. 0.85 p/(1
    /// + p) of the penetration p fits the runs of doc/theory/accuracy.md (f = 10: 0.7 %, f = 0.1: a third).
    double
    penalty_part() const
    {
      return -0.85 * penetration / (1 + penetration);
    }

    /// What the cells take from it, about: 1.3 over the square of their number over the patch (13 cells: 0.8
    /// %, 7: 2.7 %), or 0.3 over the square of that across the highest pressure where this is more, as in a
    /// narrow ridge, and what lies between the nodes (doc/theory/accuracy.md). Of fewer than three no such
    /// rule is known (a ridge that is lost between nodes may miss a third), and it is NaN.
    double
    mesh_part() const;

    /// Share by which the true peak may lie above that of the run, as far as nothing but its cells and its
    /// penalty layer is known: what both take, with none where the penetration is not known. Where no true
    /// bodies will say what the cells make of it (`held`), twice that: a jump of curvature that they miss
    /// takes more than the laws know. It is told before a run as well.
    double
    lost(bool held = true) const;
  };

  /// A place across the track in words: "8.3 mm from the running circle to the gauge side", of `x` in the
  /// track plane [m], positive to the track centre.
  std::string
  place_in_words(double x);

  /// What is to be told of a patch that slides as a whole under a wheel that is driven (a positive force on
  /// the wheel [N]) or braked; `carried`: by friction.
  std::string
  sliding_note(double longitudinal_force, bool carried);

  /// What is to be told of elastic bodies beyond the limit of shakedown of their steel (shakedown_limit()),
  /// the weaker of both, under a peak pressure [Pa] with a traction T/N; empty: none is. `computed`: bodies
  /// that yield in the result are left out, as in a run.
  std::string
  steel_doubt(const SteelSettings &scene, double peak_pressure, double traction, bool computed);

  /// The size of cells [m] that leaves the peak pressure uncertain by `wanted` at most where `size` leaves it
  /// by `within`, with the second power of the size: halved from `size` on, as meshes are.
  double
  advised_cell(double size, double within, double wanted);

  /// How far the wear of a run can be trusted, in words; empty: as far as the run. Fewer than eight cells
  /// across what slides do not show its slip: less than one (free rolling) wears half of half-spaces.
  std::string
  wear_doubt(const Scene &scene, const Summary &run);

  /// How well a run's peak pressure is known, by its interval in the summary; where it has none, by the noise
  /// of measured profiles.
  Known
  known_peak(const Summary &run);

  /// The measures that a run's own summary holds: all but those that need half-spaces or profiles.
  Measures
  measures_of_run(const Scene &scene, const Summary &run);
} // namespace wheelrail
