#pragma once

#include <wheelrail/solid/element_blocks.h>

#include <algorithm>

namespace wheelrail
{
  /// Elements follow another law as long as it lives.
  class LawScope
  {
  public:
    LawScope(ElementBlocks &blocks, const MaterialLaw &law)
      : blocks_(blocks)
      , law_(blocks.law)
    {
      blocks_.law = law;
    }
    ~LawScope()
    {
      blocks_.law = law_;
    }
    LawScope(const LawScope &) = delete;
    LawScope &
    operator=(const LawScope &) = delete;

  private:
    ElementBlocks    &blocks_;
    const MaterialLaw law_;
  };

  /// They are elastic; their history is neither read nor written. For solvers that ask for forces in states
  /// that are no steps in time, whose flow would stay in the history.
  struct ElasticScope : LawScope
  {
    explicit ElasticScope(ElementBlocks &blocks)
      : LawScope(blocks, ElasticLaw(blocks.elasticity()))
    {
    }
  };

  /// They keep their plastic strains: what has flowed bears its residual stresses and does not flow on.
  struct FrozenScope : LawScope
  {
    explicit FrozenScope(ElementBlocks &blocks)
      : LawScope(blocks,
                 std::count(blocks.flowed.begin(), blocks.flowed.end(), 0) <
                     std::ptrdiff_t(blocks.flowed.size())
                   ? frozen(blocks.law)
                   : MaterialLaw(ElasticLaw(blocks.elasticity())))
    {
    }
  };
} // namespace wheelrail
