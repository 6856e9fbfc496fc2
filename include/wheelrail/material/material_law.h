#pragma once

#include <wheelrail/material/bilinear.h>
#include <wheelrail/material/chaboche.h>

#include <limits>
#include <type_traits>
#include <variant>

namespace wheelrail
{
  /// All laws that a body may be made of: the one list of them. std::visit picks.
  using MaterialLaw = std::variant<ElasticLaw, BilinearLaw, ChabocheLaw>;

  /// A bilinear steel; elastic where the yield stress is infinite.
  inline MaterialLaw
  material_law(const Elasticity &elasticity, const Plasticity &plasticity)
  {
    if (plasticity.elastic())
      return ElasticLaw(elasticity);
    return BilinearLaw(elasticity, plasticity);
  }

  /// The law with its plastic strains as they are: no stress makes it flow.
  inline MaterialLaw
  frozen(MaterialLaw law)
  {
    const auto freeze = [](auto &of) {
      if constexpr (has_history<std::decay_t<decltype(of)>>)
        of.yield_stress = std::numeric_limits<double>::infinity();
    };
    std::visit(freeze, law);
    return law;
  }

  /// Constants of the elastic part, which every law has.
  inline const Elasticity &
  elasticity(const MaterialLaw &law)
  {
    return std::visit([](const auto &of) -> const Elasticity & { return of.elasticity; }, law);
  }

  /// Numbers that an integration point remembers.
  inline int
  history_rows(const MaterialLaw &law)
  {
    return std::visit([](const auto &of) { return of.history_rows(); }, law);
  }
} // namespace wheelrail
