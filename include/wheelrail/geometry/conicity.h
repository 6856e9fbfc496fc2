#pragma once

#include <wheelrail/geometry/contact_geometry.h>

#include <vector>

namespace wheelrail
{
  /// Rolling radius difference of a wheelset over its lateral displacement y towards one rail: radius of the
  /// wheel on that rail less that of the other one [m]. Where both sides are mirror images it is odd in y,
  /// and known over y >= 0.
  struct RadiusDifference
  {
    std::vector<double> displacement; ///< ascending, from 0 where it is odd [m]
    std::vector<double> value;        ///< [m]
    bool                odd = true;

    /// Linear between the values; y beyond the last one is clamped.
    double
    at(double y) const;

    /// The y nearest to 0 at which both wheels roll alike and a push is answered by a pull back; NaN: none.
    double
    rolling_line() const;
  };

  /// Computes it by find_contact() in steps of at most `step` up to `most` [m] to each side, or as far as
  /// both wheels have contact; shorter steps where the contact point jumps. `other`: what rolls on the other
  /// side; null: the same.
  RadiusDifference
  radius_difference(const RailProfile     &rail,
                    const WheelProfile    &wheel,
                    const TrackDimensions &track,
                    RollMode               roll,
                    double                 most,
                    double                 step,
                    const WheelOnRail     *other = nullptr);

  /// Equivalent conicity at an amplitude [m]: the tangent of the half cone angle of a conical wheelset
  /// whose kinematic movement (Klingel, 1883) has the same wavelength, as EN 15302 and UIC 519 define
  /// it. The wavelength follows from y'' = -difference(y) / (e r0) by integrating twice:
  /// y'^2 / 2 = integral of difference / (e r0) from y to the turning point; then
  /// conicity = (pi / wavelength)^2 2 e r0. Around a rolling line with unlike sides both turning points have
  /// the same integral and lie two amplitudes apart.
  ///
  /// `distance` is e, of the running circles [m], `radius` r0 [m]. Not a number when a turning point
  /// lies beyond the table or the wheelset does not swing with it (the difference pushes it outwards).
  double
  equivalent_conicity(const RadiusDifference &difference, double amplitude, double distance, double radius);
} // namespace wheelrail
