#pragma once

#include <wheelrail/solid/saved_plastic_state.h>
#include <wheelrail/solid/solid.h>

namespace wheelrail
{
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
