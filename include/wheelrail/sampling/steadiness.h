#pragma once

#include <wheelrail/geometry/frame_profile.h>
#include <wheelrail/output/fields.h>
#include <wheelrail/sampling/creep_scale.h>
#include <wheelrail/sampling/settling.h>

#include <limits>
#include <string>
#include <vector>

namespace wheelrail
{
  /// What is known of a scene beforehand, that means of its run are judged by [SI].
  struct SteadyBasis
  {
    double cell          = 1e-3;                                     ///< along the track
    double load          = std::numeric_limits<double>::quiet_NaN(); ///< static, on the rail; NaN: changes
    double torque_force  = std::numeric_limits<double>::quiet_NaN(); ///< that the torque demands; NaN: none
    double friction      = 0;                                        ///< coefficient at rest
    double shear_modulus = 81e9;                                     ///< of the steel
    double radius        = 0.46;                                     ///< of the wheel
    double slowest = 0; ///< path in which the slowest mode of the wheel turns by 1 rad, see slow_length()
    double standard_error = 1e-3; ///< that is wanted, over the scales
    double earliest       = 0;    ///< before this the means must not begin
  };

  /// The path [m] that a wheel rolls while its slowest mode, of some 190 Hz, swings by one radian: the mean
  /// over a stretch differs from that over whole swings by at most its slope times this length.
  double
  slow_length(double velocity);

  /// A result of the summary as a mean over a stretch, and how well that is known, in its own unit.
  struct KnownResult
  {
    std::string figure;           ///< its name in the table of figures
    Mean        mean;             ///< and the standard deviation of the rows
    double      scale    = 0;     ///< that it is judged by
    double      noise    = 0;     ///< standard_error() of means over cells
    double      balance  = 0;     ///< what the balances of load and torque leave open
    double      trend    = 0;     ///< slope times the length over which it may go on
    double      drift    = 0;     ///< the same of a slope larger than the noise, else 0
    bool        of_patch = false; ///< its rows are those of the patch
    bool        settles  = false; ///< is asked for in settled_after, too

    /// The standard error that is reported: noise, balance and trend.
    double
    error() const;
  };

  /// Whether the means over a stretch are steady and known.
  struct Steadiness
  {
    Range                    stretch; ///< of the rolled distance [m]
    std::vector<KnownResult> results;
    double                   load_miss = 0, torque_miss = 0; ///< over load and friction bound; 0 not known
    std::string              open; ///< what is not known well enough, in words; empty: the run is steady

    bool
    steady() const
    {
      return open.empty();
    }
  };

  /// The results over a stretch of the rows so far.
  Steadiness
  known_results(const History     &history,
                const History     &patches,
                const SteadyBasis &basis,
                const Range       &stretch);

  /// The last stretch of whole cells, at least eight of them and three quarters of a patch length, that
  /// begins one patch length past the start or later, over which the least known result is known best. Steady
  /// when the noise of every result and the balances of load and torque are below the standard error that is
  /// wanted, and what slopes leave open is below six times as much. Without room for such a stretch: not
  /// steady, without results.
  Steadiness
  judge_steadiness(const History &history, const History &patches, const SteadyBasis &basis);

  /// Means of the values over the cells of `length` from the end of a stretch backwards, first cell first;
  /// what is less than a cell at its beginning is left out. Values are taken as straight between their
  /// distances, which grow [m], so that what repeats from cell to cell drops out of each mean whatever rows
  /// it has.
  std::vector<double>
  cell_means(const std::vector<double> &distance,
             const std::vector<double> &values,
             const Range               &stretch,
             double                     length);

  /// Standard error of the mean of means over cells that follow each other, in their unit. Neighbours are
  /// alike, so the scatter is taken between blocks of one cell, of two, three, ... as long as four blocks are
  /// left, and the largest counts, which grows with the blocks until these are as long as what makes
  /// neighbours alike (Flyvbjerg and Petersen 1989). The scatter of few blocks is uncertain: it is
  /// enlarged by Student's distribution, so that the true mean lies within two errors as often as within two
  /// of a normal distribution. Infinity for fewer than four cells.
  double
  standard_error(const std::vector<double> &means);
} // namespace wheelrail
