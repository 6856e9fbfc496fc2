#pragma once

#include <wheelrail/solid/element_blocks.h>

#include <algorithm>

namespace wheelrail
{
  /// Keeps the plastic strains of elements as they are as long as it lives: what has flowed bears its
  /// residual stresses and does not flow on. Bodies that have not flowed are elastic.
  class FrozenMeanwhile
  {
  public:
    explicit FrozenMeanwhile(ElementBlocks &blocks)
      : blocks_(blocks)
      , law_(blocks.law)
    {
      const bool flowed = std::any_of(
        blocks.flowed.begin(), blocks.flowed.end(), [](const unsigned char mark) { return mark != 0; });
      blocks_.law = flowed ? frozen(law_) : MaterialLaw(ElasticLaw(blocks.elasticity()));
    }
    ~FrozenMeanwhile()
    {
      blocks_.law = law_;
    }
    FrozenMeanwhile(const FrozenMeanwhile &) = delete;
    FrozenMeanwhile &
    operator=(const FrozenMeanwhile &) = delete;

  private:
    ElementBlocks    &blocks_;
    const MaterialLaw law_;
  };
} // namespace wheelrail
