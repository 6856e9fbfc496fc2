#pragma once

#include <wheelrail/geometry/irregularity.h>

namespace wheelrail
{
  /// Where an irregularity lies and how large it is; places and signs as those of Irregularity.
  struct IrregularSize
  {
    double place   = 0; ///< along, of its middle; of a corrugation that of its first crest [m]
    double lateral = 0; ///< across, of its middle [m]
    double length  = 0; ///< along [m]
    double width   = 0; ///< across, 0: all across [m]
    double depth   = 0; ///< below the smooth surface, negative: height above it [m]
  };

  /// A smooth hollow: depth cos^2(pi u/length), across likewise where it has a width.
  Irregularity
  dent(const IrregularSize &size);

  /// Two lobes, one behind the other, with a ridge of three quarters of the depth between them, as squats
  /// have it; across as a dent.
  Irregularity
  squat(const IrregularSize &size);

  /// Waves depth/2 (1 - cos(2 pi u/wavelength)) below the surface from a crest on, as many whole ones as fit
  /// into the length. With a width they fade within a quarter of it on each side.
  Irregularity
  corrugation(const IrregularSize &size, double wavelength);

  /// Two rail ends that hang down: depth (1 - 2|u|/length)^2, with a kink in the middle, where the surface
  /// turns by 8 depth/length.
  Irregularity
  dipped_joint(const IrregularSize &size);

  /// A wheel flat with edges: the chord `length` of the circle of `radius` in place of the arc, so
  /// R cos(length/2R)/cos(angle) - R; its depth is length^2/(8 R).
  Irregularity
  fresh_flat(const IrregularSize &size, double radius);

  /// A wheel flat whose edges are rolled round: depth cos^2(pi u/length).
  Irregularity
  rounded_flat(const IrregularSize &size);

  /// A wheel that is out of round all around: waves as of a corrugation, `order` of them, with a crest at the
  /// place; `radius` of the circle on which arcs count [m].
  Irregularity
  polygon(const IrregularSize &size, unsigned int order, double radius);

  /// The measures of an irregularity between two places across, sampled each 0.5 mm along.
  IrregularMeasures
  measures_of(const Irregularity &irregularity, double low, double high);
} // namespace wheelrail
