#pragma once

#include <wheelrail/damage/laws.h>
#include <wheelrail/output/fields.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/output/summary.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Wear across the rail, of one passage of one wheel over each place of the rail. The wheel loses as much
  /// for each turn, where both steels are alike.
  struct WearProfile
  {
    std::vector<double> lateral; ///< as PatchFields::lateral [m]
    std::vector<double> depth;   ///< Archard's [m]
    std::vector<double> work;    ///< of friction for each metre rolled and metre of width [N/m]
  };

  /// Sums the fields of a patch along the track: depth = sum of k p |s| dx / H with the slip s over the
  /// velocity V [m/s], k from archard_coefficient() (Archard 1953), and the work of friction, tractions times
  /// slip. Fields on a grid with even spacing or not: `area` over the width of a row is its step dx. With
  /// `of_nodes`, which stick and slip by turns, k is that of a slip averaged over a node and its neighbours
  /// along (1, 2, 1): beyond 0.2 m/s it is seven times as large, so that bursts would wear too much.
  WearProfile
  wear_profile(const PatchFields &patch, double velocity, const WearData &data, bool of_nodes = false);

  /// A table for wear.csv, without rows: patch, lateral_m, archard_depth_m, friction_work_N_per_m.
  FigureTable
  empty_wear_table();

  /// Adds the rows of a patch.
  void
  add_to_table(const WearProfile &profile, unsigned int patch, FigureTable &table);

  /// Writes the table of one patch; nothing where the profile is empty.
  void
  write_wear(const WearProfile &profile, const std::string &path);

  /// Integral over the width, of depths the area that a passage takes from the section [m2].
  double
  over_width(const WearProfile &profile, const std::vector<double> &values);

  /// The keys of the figures of wear that count for the worst patch, which are all but the section.
  const std::vector<std::string> &
  worst_wear_keys();

  /// Sets the figures of wear and cracks of a patch, from its force, area, peak pressure and T-gamma in the
  /// summary: T-gamma over its area, wear rate (usfd_wear_rate()), share of the life of one passage
  /// (burstow_damage()), largest depth and section that Archard's law takes in one passage (`wear` across the
  /// rail; empty: not known), traction over normal force, and, where the yield stress in shear is known,
  /// fatigue index and peak pressure over it, the load of shakedown maps (Johnson 1989). `tangential`: force
  /// [N], `yield_stress`: of the rail [Pa]; infinite: elastic.
  void
  set_wear_figures(const WearProfile &wear,
                   double             tangential,
                   double             yield_stress,
                   const WearData    &data,
                   Summary           &summary);
} // namespace wheelrail
