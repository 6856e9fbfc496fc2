#pragma once

#include <wheelrail/base/body.h>
#include <wheelrail/solid/element_blocks.h>

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
} // namespace wheelrail
