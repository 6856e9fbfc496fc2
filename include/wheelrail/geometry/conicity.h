#pragma once

#include <wheelrail/geometry/contact_geometry.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Rolling radius difference of a wheelset over its lateral displacement y >= 0 towards one rail:
  /// radius of the wheel on that rail less that of the other one [m]. Odd in y, since both sides are
  /// mirror images.
  struct RadiusDifference
  {
    std::vector<double> displacement; ///< ascending from 0 [m]
    std::vector<double> value;        ///< [m]

    /// Linear between the values; y beyond the last one is clamped.
    double
    at(double y) const;
  };

  /// Computes it by find_contact() in steps of `step` up to `most` [m], or as far as both wheels have
  /// contact.
  RadiusDifference
  radius_difference(const RailProfile     &rail,
                    const WheelProfile    &wheel,
                    const TrackDimensions &track,
                    RollMode               roll,
                    double                 most,
                    double                 step);

  /// Equivalent conicity at an amplitude [m]: the tangent of the half cone angle of a conical wheelset
  /// whose kinematic movement (Klingel, 1883) has the same wavelength, as EN 15302 and UIC 519 define
  /// it. The wavelength follows from y'' = -difference(y) / (e r0) by integrating twice:
  /// y'^2 / 2 = integral of difference / (e r0) from y to the amplitude; then
  /// conicity = (pi / wavelength)^2 2 e r0.
  ///
  /// `distance` is e, of the running circles [m], `radius` r0 [m]. Not a number when the amplitude
  /// lies beyond the table or the wheelset does not swing with it (the difference pushes it outwards).
  double
  equivalent_conicity(const RadiusDifference &difference, double amplitude, double distance, double radius);
} // namespace wheelrail
