#include <wheelrail/bodies/line_loads.h>

#include <gsl/gsl_sf_bessel.h>

#include <cmath>

// H(k) of (2) in doc/theory/bodies.md: a half-space under a line load exp(i k z), directions t along the
// surface, n along its normal, w along the line. 2 K0 and 2 k s K1 are the transforms of 1/r and s^2/r^3 over
// z.

namespace wheelrail
{
  LineResponse
  halfspace_line(const double shear_modulus,
                 const double poissons_ratio,
                 const bool   outwards,
                 const double k,
                 const double s)
  {
    // Boussinesq (1885) and Cerruti (1882) over z, int cos(k z)/r dz = 2 K0(k s): H of (2) in
    // doc/theory/bodies.md
    const double x = k * std::abs(s), nu = poissons_ratio, f = 1 / (M_PI * shear_modulus);
    // beyond, both are below 1e-20
    constexpr double far = 45;
    const double     K0 = x < far ? gsl_sf_bessel_K0(x) : 0, K1 = x < far ? gsl_sf_bessel_K1(x) : 0;
    const double     c = (outwards ? 1 : -1) * (1 - 2 * nu) / (4 * shear_modulus) * std::exp(-x);
    // tw: x z/r^3 of Cerruti's solution, odd in s; c: x/r^2 and z/r^2 of the coupling of normal and
    // tangential loads, whose transform over z is pi e^(-k s)
    const double side = s > 0 ? 1 : -1, tw = f * nu * k * s * K0;
    // rows t, n, w. For k s to 0 K0 goes as -ln(k s): Flamant's line load (1892), whose own displacement is
    // infinite; x K1 tends to 1.
    return {{f * ((1 - nu) * K0 + nu * x * K1),
             side * c,
             tw, //
             -side * c,
             f * (1 - nu) * K0,
             -c, //
             -tw,
             -c,
             f * (K0 - nu * x * K1)}};
  }


  LineResponse
  in_fixed_axes(const LineResponse &local, const double receiver, const double source)
  {
    const double cr = std::cos(receiver), sr = std::sin(receiver), cs = std::cos(source),
                 ss = std::sin(source);
    LineResponse half, fixed;
    for (int b = 0; b < 3; ++b)
      {
        // T(receiver) H T(source)', T the rotation of (t, n) to (x, y); w stays
        half[b]     = cr * local[b] - sr * local[3 + b];
        half[3 + b] = sr * local[b] + cr * local[3 + b];
        half[6 + b] = local[6 + b];
      }
    for (int a = 0; a < 3; ++a)
      {
        fixed[3 * a]     = cs * half[3 * a] - ss * half[3 * a + 1];
        fixed[3 * a + 1] = ss * half[3 * a] + cs * half[3 * a + 1];
        fixed[3 * a + 2] = half[3 * a + 2];
      }
    return fixed;
  }
} // namespace wheelrail
