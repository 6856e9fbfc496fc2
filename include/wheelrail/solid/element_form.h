#pragma once

namespace wheelrail
{
  /// The two hexahedra, see doc/theory/element.md.
  enum class ElementForm
  {
    reduced, ///< one point and a stabilisation
    full     ///< eight points and the mean dilatation
  };
} // namespace wheelrail
