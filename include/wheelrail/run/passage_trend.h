#pragma once

#include <string>
#include <vector>

namespace wheelrail
{
  /// What a round of passages has added in the rail, where every wheel has rolled steadily.
  struct RoundGrowth
  {
    double strain = 0; ///< of the largest accumulated plastic strain [1]
    double shear  = 0; ///< of the forward flow of the surface over the depth of the plastic band, NaN where
                       ///< the path is too short [1]
  };

  /// Where passages lead to, in the terms of Johnson, Contact Mechanics, 1985, section 9.2.
  enum class PassageTrend
  {
    open,       ///< not known yet
    shakedown,  ///< nothing yields any more
    to_and_fro, ///< each yields as much as the one before, without flowing on as far as is known
    ratcheting  ///< each flows on by as much as the one before
  };

  /// The trend after the rounds so far: shakedown when the last strain is below `least`; steady when strain
  /// and shear have changed by at most the share `change` twice in succession, a shear below `least` counting
  /// as none.
  PassageTrend
  trend_of(const std::vector<RoundGrowth> &rounds, double least, double change);

  /// "the rail shakes down: ...", with the growth of the last round.
  std::string
  in_words(PassageTrend trend, const RoundGrowth &last);
} // namespace wheelrail
