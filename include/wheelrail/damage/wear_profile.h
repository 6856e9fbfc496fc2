#pragma once

#include <wheelrail/damage/laws.h>
#include <wheelrail/output/fields.h>

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
  /// slip. Fields on a grid with even spacing or not: `area` over the width of a row is its step dx.
  WearProfile
  wear_profile(const PatchFields &patch, double velocity, const WearData &data);

  /// Integral over the width, of depths the area that a passage takes from the section [m2].
  double
  over_width(const WearProfile &profile, const std::vector<double> &values);
} // namespace wheelrail
