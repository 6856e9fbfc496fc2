#pragma once

#include <wheelrail/base/body.h>
#include <wheelrail/solid/element_blocks.h>
#include <wheelrail/solid/solid.h>

#include <vector>

namespace wheelrail
{
  /// What plastic flow has left in the elements of both bodies, to come back to: searches ask for forces in
  /// positions that are no steps in time, each of them one step from here.
  class SavedPlasticState
  {
  public:
    explicit SavedPlasticState(const PerBody<ElementBlocks> &blocks)
    {
      for (const Body body : both_bodies)
        kept_[body] = {blocks[body].history, blocks[body].plastic_work, blocks[body].flowed};
    }

    /// For the blocks that were kept.
    void
    restore(PerBody<ElementBlocks> &blocks) const
    {
      for (const Body body : both_bodies)
        {
          blocks[body].history      = kept_[body].history;
          blocks[body].plastic_work = kept_[body].work;
          blocks[body].flowed       = kept_[body].flowed;
        }
    }

  private:
    struct Flow
    {
      AlignedVector<double>      history, work;
      std::vector<unsigned char> flowed;
    };
    PerBody<Flow> kept_;
  };

  /// Gives a solid its displacement and its flow back at its end, whatever happens; the mesh must be the same
  /// then.
  class KeptState
  {
  public:
    explicit KeptState(Solid &solid)
      : solid_(solid)
      , displacement_(solid.displacement)
      , flow_(solid.blocks)
    {
    }
    ~KeptState()
    {
      solid_.displacement = displacement_;
      flow_.restore(solid_.blocks);
    }
    KeptState(const KeptState &) = delete;
    KeptState &
    operator=(const KeptState &) = delete;

    const SavedPlasticState &
    flow() const
    {
      return flow_;
    }

  private:
    Solid                      &solid_;
    const AlignedVector<double> displacement_;
    const SavedPlasticState     flow_;
  };
} // namespace wheelrail
