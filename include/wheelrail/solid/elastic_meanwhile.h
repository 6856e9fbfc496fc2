#pragma once

#include <wheelrail/solid/element_blocks.h>

namespace wheelrail
{
  /// Makes elements elastic as long as it lives, whatever their law; their history is neither
  /// read nor written. For solvers that ask for forces in states that are no steps in time, whose
  /// flow would stay in the history.
  class ElasticMeanwhile
  {
  public:
    explicit ElasticMeanwhile(ElementBlocks &blocks)
      : blocks_(blocks)
      , law_(blocks.law)
    {
      blocks_.law = ElasticLaw(blocks.elasticity());
    }
    ~ElasticMeanwhile()
    {
      blocks_.law = law_;
    }
    ElasticMeanwhile(const ElasticMeanwhile &) = delete;
    ElasticMeanwhile &
    operator=(const ElasticMeanwhile &) = delete;

  private:
    ElementBlocks    &blocks_;
    const MaterialLaw law_;
  };
} // namespace wheelrail
