#pragma once

#include <array>

namespace wheelrail
{
  /// Displacements (t, n, w) under tractions (t, n, and i times z), row after row: 3 x 3.
  using LineResponse = std::array<double, 9>;

  /// The surface displacement of an elastic half-space at the distance s [m] from a line load of 1 N/m that
  /// proportional to exp(i k z): along the surface across the line (t), along the normal (n), and i w along
  /// the line, as those of WaveStiffness [1/Pa]. Boussinesq (1885) and Cerruti (1882), transformed over z
  /// with modified Bessel functions:
  ///   tt ((1 - nu) K0 + nu k |s| K1)/(pi G), nn (1 - nu) K0/(pi G), ww (K0 - nu k |s| K1)/(pi G),
  ///   tw = -wt = nu k s K0/(pi G), tn = -nt = c sgn(s) e^(-k |s|), wn = nw = -c e^(-k |s|),
  ///   c = (1 - 2 nu)/(4 G) where n points out of the body, and -c where it points into it.
  /// k > 0, s not 0.
  LineResponse
  halfspace_line(double shear_modulus, double poissons_ratio, bool outwards, double k, double s);

  /// The same with t and n turned to fixed axes x, y: t lies at the angle `receiver` to x where the
  /// displacement is seen and at `source` where the force acts, n to the left of it [rad].
  LineResponse
  in_fixed_axes(const LineResponse &local, double receiver, double source);
} // namespace wheelrail
