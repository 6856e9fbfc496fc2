#pragma once

#include <functional>

namespace wheelrail
{
  /// Planes whose angles differ by less are one [rad].
  constexpr double same_plane = 0.1;

  /// The one creepage of a wheel with contacts in several planes.
  struct CreepageFound
  {
    bool   carried  = true; ///< false: even a locked wheel (-1), or one twice as fast (1), misses
    double creepage = 0;    ///< or that bound
  };

  /// Where `missed`, which grows with the creepage, vanishes: a bracket in growing steps from `first` on,
  /// then the method of Alefeld, Potra and Shi (1995).
  CreepageFound
  find_creepage(const std::function<double(double)> &missed, double first);
} // namespace wheelrail
