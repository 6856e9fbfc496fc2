#pragma once

#include <wheelrail/run/passage_jump.h>
#include <wheelrail/scene/scene.h>

#include <vector>

#include <mpi.h>

namespace wheelrail
{
  /// The jumps of one family of passages (Run/Passage jump, Run/Jump error): when and how far the rail is
  /// extrapolated over whole rounds of wheels, and which jumps are taken back. A round is one wheel, or all
  /// those of Run/Passage list. Rates and growths are those from round to round, at the end of each, where
  /// the same wheel has passed. All functions are collective; `computed` are the numbers of the passages so
  /// far that were computed, from 1, in order.
  class PassageJumps
  {
  public:
    /// For the passages of `scene`, `of_round` wheels a round, `most` passages in all.
    PassageJumps(const Scene &scene, unsigned int of_round, unsigned int most, MPI_Comm communicator);

    /// Goes on with the jumps that the folder of the passages has on record.
    void
    read_old();

    /// The passage that the rail has come to: the last computed one, or the one jumped to.
    unsigned int
    stand(const std::vector<unsigned int> &computed) const;

    /// Holds the last jump against the second round that was computed after it, and says how far it misses.
    /// Where that is too far, takes the jump back: the folders after it are removed, their passages taken
    /// from `computed`.
    void
    judge(std::vector<unsigned int> &computed);

    /// Extrapolates the rail over as many rounds as the growths of the last ones allow, if they do.
    void
    try_jump(const std::vector<unsigned int> &computed);

  private:
    void
    learn_from(const PassageJump &jump);
    bool
    jump_over(const std::vector<unsigned int> &computed, const JumpBasis &basis, unsigned int rounds);
    JumpBasis
    basis_of(unsigned int passage, const PassageJump *last) const;

    const Scene             &scene_;
    unsigned int             of_round_, most_;
    std::vector<PassageJump> jumps_;
    unsigned int             longest_; ///< that may still be tried, in rounds
    MPI_Comm                 communicator_;
  };
} // namespace wheelrail
