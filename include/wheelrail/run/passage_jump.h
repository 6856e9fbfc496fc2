#pragma once

#include <string>
#include <vector>

namespace wheelrail
{
  /// A jump over passages that are not computed (Lesne and Savari 1989; Cojocaru and Karlsson 2006). It goes
  /// over whole rounds of the wheels that pass, each of one passage where these are all alike.
  struct PassageJump
  {
    unsigned int from = 0, to = 0; ///< passage whose rail is extrapolated, and passage whose rail it becomes
    double       growth = 0;       ///< of the largest plastic strain in the round that ends with `from` [1]
    double       rate   = 1;       ///< growth over that of the round before, as extrapolated

    // known once two rounds after it are computed
    double computed_rate = 0; ///< each round, that leads to the growth there
    double error         = 0; ///< of the growth over the jump, over the plastic strain after it
    bool   judged = false, kept = false;
  };

  /// q + q^2 + ... + q^n: the growth over n rounds in that of the last computed one, when each grows by q
  /// times the one before.
  double
  jump_factor(double rate, unsigned int n);

  /// What is known before a jump, of the largest plastic strain in the rail.
  struct JumpBasis
  {
    double strain = 0;           ///< at present [1]
    double growth = 0;           ///< in the last round [1]
    double rate = 1, before = 1; ///< of the growth from the round before to the last one, and one earlier
  };

  /// The longest jump up to `most` rounds, `most` halved again and again, for which the change of the rate
  /// makes no more difference than `error` of the strain; 0 when not even two rounds may be jumped.
  unsigned int
  jump_length(const JumpBasis &basis, unsigned int most, double error);

  /// Judges a jump over n rounds by the growth that was computed in the second one thereafter, with the
  /// strain then.
  void
  judge_jump(PassageJump &jump, unsigned int n, double growth, double strain, double error);

  /// jumps.csv: all jumps so far, those taken back too.
  void
  write_jumps(const std::vector<PassageJump> &jumps, const std::string &folder);

  /// Those of the file in `folder`; none without it.
  std::vector<PassageJump>
  read_jumps(const std::string &folder);
} // namespace wheelrail
