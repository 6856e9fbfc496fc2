#pragma once

#include <wheelrail/halfspace/problem.h>

namespace wheelrail
{
  /// What elements of twice the length and width change in a solution, relative to it. Creepage and creep
  /// forces err with the first power of the elements, so that this is about their error; smooth pressures
  /// with the second, a third of it.
  struct ElementEffect
  {
    double pressure = 0; ///< of the peak; of the normal force where the approach is given, if that is more
    double creep    = 0; ///< of the creepage that was found, or of the tangential force
  };

  /// Solves the problem on means over four elements. Of true bodies half-spaces with the same distance and
  /// rigid slip are compared. A patch that slides as a whole has no error of creep. Without `rolls` the
  /// pressure alone, in some milliseconds.
  ElementEffect
  element_effect(const HalfspaceProblem &problem, const HalfspaceSolution &solution, bool rolls);
} // namespace wheelrail
