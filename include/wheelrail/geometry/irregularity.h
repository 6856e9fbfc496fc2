#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Height of an irregularity over the smooth surface, along the outward normal of its section [m], and how
  /// it grows across and along.
  struct IrregularHeight
  {
    double height = 0, across = 0, along = 0;
  };

  /// How large and steep an irregularity is.
  struct IrregularMeasures
  {
    double largest  = 0;        ///< height or depth [m]
    double steepest = 0;        ///< slope along or across
    double touched  = HUGE_VAL; ///< slope along where a wheel can touch, at most, where that is known
  };

  /// What carries an irregularity in a run: each is carried as a whole by one of them.
  enum class CarriedBy
  {
    offset, ///< the contact, as an offset of the gap between nodes and true surface
    mesh    ///< the nodes of the mesh, which are moved
  };

  /// A place along where the slope jumps [m].
  struct Kink
  {
    double along = 0;
    double aside = 0.3e-3; ///< from where on before and behind it the surface is known
  };

  /// A shape above a running surface or missing from it.
  ///
  /// Places: `across` is x in the section of the body at the smooth surface, positive to the field side [m];
  /// `along` is the place along the track, Z of the start [m]. On a wheel it is the arc on the rolling circle
  /// ahead of the contact of the start, so that both meet in rolling.
  struct Irregularity
  {
    std::string                                    name;               ///< of its section in the input
    double                                         begin = 0, end = 0; ///< along [m]
    std::function<IrregularHeight(double, double)> at;                 ///< of places across and along within
    /// Another one that noise in measured heights leaves possible, by its number; none where they are exact.
    std::function<std::function<IrregularHeight(double, double)>(unsigned int)> drawn;
    /// Where its slope jumps along.
    std::vector<Kink> kinks;
    bool              endless = false; ///< before and behind the heights of its ends hold, else there is none
    bool              gap     = false; ///< between two rails one behind the other, too deep to carry
    std::function<bool(double, double)>
                      second; ///< whether a place across and along is on the second of two rails
    CarriedBy         carried = CarriedBy::offset;
    IrregularMeasures measures;
    double shortest = 0; ///< length over which it rises and falls [m]: what cells and patch have to follow
  };

  /// All irregularities of a body.
  using Irregularities = std::vector<Irregularity>;

  /// Their sum at a place, of all or of those alone that are carried by `carried`. A wheel is closed:
  /// `circumference` [m] on the rolling circle; 0 for a rail.
  IrregularHeight
  height_at(const Irregularities    &irregularities,
            double                   circumference,
            double                   across,
            double                   along,
            std::optional<CarriedBy> carried = {});
} // namespace wheelrail
