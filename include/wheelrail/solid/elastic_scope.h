#pragma once

#include <wheelrail/solid/element_blocks.h>

namespace wheelrail
{
  /// Makes elements elastic as long as it lives, whatever their law; their history is neither
  /// read nor written. For solvers that ask for forces in states that are no steps in time, whose
  /// flow would stay in the history.
  class ElasticScope
  {
  public:
    explicit ElasticScope(ElementBlocks &blocks)
      : blocks_(blocks)
      , law_(blocks.law)
    {
      blocks_.law = ElasticLaw(blocks.elasticity());
    }
    ~ElasticScope()
    {
      blocks_.law = law_;
    }
    ElasticScope(const ElasticScope &) = delete;
    ElasticScope &
    operator=(const ElasticScope &) = delete;

  private:
    ElementBlocks    &blocks_;
    const MaterialLaw law_;
  };
} // namespace wheelrail
