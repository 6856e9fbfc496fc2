#pragma once

namespace wheelrail
{
  /// Elliptic contact of two elastic half-spaces (Hertz, 1882): undeformed distance A x^2 + B y^2, pressure
  /// p0 sqrt(1 - x^2 / a^2 - y^2 / b^2).
  struct HertzContact
  {
    double a = 0, b = 0;            ///< semi-axes along x and y [m]
    double A = 0, B = 0;            ///< half the relative curvatures [1/m]
    double force = 0, approach = 0; ///< [N], [m]
    double peak_pressure = 0;       ///< p0 [Pa]
  };

  /// What presses the bodies: a force [N] or an approach [m].
  struct HertzLoad
  {
    bool   force_given = true;
    double value       = 0;
  };

  /// Plane-strain modulus 1 / ((1 - nu1) / (2 G1) + (1 - nu2) / (2 G2)) of two bodies [Pa].
  double
  contact_modulus(double shear1, double poisson1, double shear2, double poisson2);

  /// The contact of given semi-axes, all positive.
  HertzContact
  hertz_of_axes(double a, double b, double modulus, const HertzLoad &load);

  /// The contact of given half curvatures, all positive.
  HertzContact
  hertz_of_curvatures(double A, double B, double modulus, const HertzLoad &load);

  /// Contact of cylinders along y, |y| <= b, under a force (Johnson 1985, section 4.2(c)): the undeformed
  /// distance A x^2, B = 0, the pressure p0 sqrt(1 - x^2 / a^2); its approach, of no end, is 0. By the half
  /// curvature A or the half length a.
  HertzContact
  hertz_of_cylinders(double A, double b, double modulus, double force);
  HertzContact
  hertz_of_strip(double a, double b, double modulus, double force);

  /// The contact of a given half curvature along x and ratio a / b.
  HertzContact
  hertz_of_ratio(double A, double ratio, double modulus, const HertzLoad &load);
} // namespace wheelrail
