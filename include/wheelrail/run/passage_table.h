#pragma once

#include <wheelrail/output/figure_table.h>

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

  /// "FOLDER/passage_003".
  std::string
  passage_folder(const std::string &folder, unsigned int passage);

  /// What a finished passage has left in the rail, NaN where nothing has flowed.
  struct LeftInRail
  {
    double strain  = 0; ///< largest plastic strain that has come up so far [1]
    double forward = 0; ///< flow of the surface along the track [m]
    double depth   = 0; ///< of the plastic band [m]
  };
  LeftInRail
  left_in_rail(const std::string &folder, unsigned int passage);

  /// The table passages.csv of the passages 1 to `passed` below `folder`, from their summaries; the column
  /// "verdict" holds the numbers of Grade.
  FigureTable
  passage_table(const std::string &folder, unsigned int passed);

  /// "verdict: 8 passages trusted, 2 with care, 0 not trusted" of such a table, a line.
  std::string
  passage_verdicts(const FigureTable &table);

  /// What each whole round of `of_round` passages has added.
  std::vector<RoundGrowth>
  round_growths(const std::string &folder, unsigned int passed, unsigned int of_round);

  /// Writes passages.h5: the columns of passages.csv, which are those of `table`, and in the group
  /// BB_behind_rail, from the residual.h5 of the passages, that cut of the unloaded rail over passages,
  /// lateral place and depth, with what each passage has added to plastic and forward shear strain. Passages
  /// without that cut are left out of these. To be called on one rank.
  void
  write_passage_fields(const std::string &folder, unsigned int passed, const FigureTable &table);
} // namespace wheelrail
