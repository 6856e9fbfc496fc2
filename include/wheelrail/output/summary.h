#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace wheelrail
{
  /// The figures of one run, in SI units. A value that the run did not give is NaN (null in the
  /// file). Forces are those on the wheel: longitudinal positive forward, lateral along +X (to the
  /// track centre), normal positive in compression. creepage = (omega r - V) / V.
  struct Summary
  {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::string title, program_version;

    double normal_force               = none; ///< normal to the contact plane [N]
    double vertical_force             = none; ///< [N]
    double longitudinal_force         = none; ///< [N]
    double lateral_force              = none; ///< [N]
    double max_pressure               = none; ///< largest nodal value [Pa]
    double max_pressure_fitted        = none; ///< top of the quadratic through 3 x 3 nodes [Pa]
    double contact_area               = none; ///< [m2]
    double patch_lateral              = none; ///< extent across the rail [m]
    double patch_longitudinal         = none; ///< extent along the rail [m]
    double patch_centre_lateral       = none; ///< in the contact frame [m]
    double patch_centre_longitudinal  = none; ///< ahead of the axle [m]
    double max_shear_traction         = none; ///< [Pa]
    double stick_fraction             = none; ///< of the loaded area [1]
    double creepage                   = none; ///< [1]
    double friction_coefficient       = none; ///< [1]
    double max_von_mises              = none; ///< [Pa]
    double max_plastic_strain         = none; ///< [1]
    double max_residual_von_mises     = none; ///< [Pa]
    double rolled_distance            = none; ///< [m]
    double velocity                   = none; ///< [m/s]
    double elements                   = none;
    double time_steps                 = none;
    double time_step                  = none; ///< [s]
    double element_updates_per_second = none; ///< [1/s]
    double energy_error               = none; ///< relative to strain plus dissipated energy [1]
    double wall_time                  = none; ///< [s]
    double peak_memory                = none; ///< all ranks together [bytes]
    double ranks                      = none;

    /// Further figures under their full key, unit included: "normal_force_std_N",
    /// "halfspace_max_pressure_Pa", "relative_difference_max_pressure", ...
    std::vector<std::pair<std::string, double>> further;

    bool        finished = false; ///< the run reached its end
    std::string stop_reason;      ///< why it did not, a sentence; empty when finished
    std::string ended;            ///< how it ended: "steady", "not steady", "distance"; empty when it did not
    std::string ended_because;    ///< the same in words
    std::string note;             ///< what is to be known beside the figures, a sentence; mostly empty
    std::string largest_swing_of; ///< label of the figure with the largest swing
    std::string largest_drift_of; ///< and of that with the largest drift
    /// "trusted", "with care" or "not trusted", see verdict/verdict.h; empty: not judged. What did not finish
    /// is not trusted whatever is here.
    std::string verdict;
    std::string
      doubts; ///< why the figures are to be taken with care or not trusted, sentences; empty: neither
  };

  /// Sets a figure by its key in the file ("max_pressure_Pa"); a key that is none of the members
  /// goes to `further`, replacing an earlier value of that key.
  void
  set_figure(Summary &summary, const std::string &key, double value);

  /// The figure with that key, member or further; NaN when there is none.
  double
  get_figure(const Summary &summary, const std::string &key);

  /// The verdict in the file, on screens and in tables: of what did not finish "not trusted"; of
  /// a summary that names none "trusted" where it has no doubts, as those before there were three words.
  std::string
  verdict_of(const Summary &summary);

  /// "verdict: with care: ..." with the doubts, as screens show it.
  std::string
  verdict_line(const Summary &summary);

  /// A summary as the text of its file, and back, to the same bits; throws RunError for other texts.
  std::string
  summary_as_text(const Summary &summary);
  Summary
  summary_from_text(const std::string &text);

  /// Writes the flat summary.json: keys with their SI unit, in the order above; counts as whole
  /// numbers; NaN and infinite values as null; and beside it figures.json, which says how they are shown
  /// (figures_as_json()). The files are replaced as a whole. To be called on one rank; throws RunError
  /// when they cannot be written.
  void
  write_summary(const Summary &summary, const std::string &path);

  /// Reads such a file back; unknown numbers go to `further`. Throws RunError naming the file when
  /// it is missing or no JSON object.
  Summary
  read_summary(const std::string &path);
} // namespace wheelrail
