#include <wheelrail/halfspace/hertz.h>

#include <algorithm>
#include <cmath>
#include <utility>

// Hertz (1882) in the notation of Johnson (1985), chapter 4: h = A x^2 + B y^2, p = p0 sqrt(1 - x^2/a^2 -
// y^2/b^2).

namespace wheelrail
{
  namespace
  {
    /// Factors of an ellipse of the ratio g of its short over its long axis (Johnson 1985, eq. 4.25
    /// and 4.26): half curvatures along the long and the short axis and approach, for p0 = E* and a long axis
    /// of 1.
    struct EllipseFactors
    {
      double flat = 0, steep = 0, approach = 0;
    };

    EllipseFactors
    ellipse_factors(const double g)
    {
      // e: eccentricity; K, E: complete elliptic integrals. With a = 1 and p0 = E*: A = g (K - E)/e^2, B = g
      // (E/g^2 - K)/e^2, approach = g K. A circle: pi/4, pi/4, pi/2.
      const double e2 = (1 - g) * (1 + g);
      if (e2 < 1e-7) // a circle; differences of the integrals would be lost in rounding
        return {0.25 * M_PI, 0.25 * M_PI, 0.5 * M_PI};
      const double e = std::sqrt(e2), K = std::comp_ellint_1(e), E = std::comp_ellint_2(e);
      return {g * (K - E) / e2, g * (E / (g * g) - K) / e2, g * K};
    }

    /// The contact of the ratio g of short over long axis and of p0 / E*.
    HertzContact
    contact_of(const double g,
               const double long_axis,
               const double pressure_ratio,
               const bool   long_x,
               const double modulus)
    {
      // lengths go with a, curvatures with 1/a, all with p0/E*
      const EllipseFactors f = ellipse_factors(g);
      HertzContact         contact;
      contact.a             = long_axis;
      contact.b             = g * long_axis;
      contact.A             = pressure_ratio * f.flat / long_axis;
      contact.B             = pressure_ratio * f.steep / long_axis;
      contact.approach      = pressure_ratio * f.approach * long_axis;
      contact.peak_pressure = pressure_ratio * modulus;
      // N = 2/3 pi a b p0: the volume below the half ellipsoid of the pressure
      contact.force = 2. / 3 * M_PI * contact.a * contact.b * contact.peak_pressure;
      if (!long_x)
        {
          std::swap(contact.a, contact.b);
          std::swap(contact.A, contact.B);
        }
      return contact;
    }

    /// The long axis under a load, where p0 / E* = c times it.
    double
    loaded_axis(const double g, const double c, const double modulus, const HertzLoad &load)
    {
      // c a^3 = N/(2/3 pi g E*), or c a^2 = approach/(g K(e)), a the long axis
      return load.force_given ? std::cbrt(load.value / (2. / 3 * M_PI * g * c * modulus))
                              : std::sqrt(load.value / (ellipse_factors(g).approach * c));
    }
  } // namespace


  double
  contact_modulus(const double shear1, const double poisson1, const double shear2, const double poisson2)
  {
    // 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 with E = 2 G (1 + nu)
    return 1 / ((1 - poisson1) / (2 * shear1) + (1 - poisson2) / (2 * shear2));
  }

  HertzContact
  hertz_of_axes(const double a, const double b, const double modulus, const HertzLoad &load)
  {
    // given axes: p0 from the force, or from the approach
    const double long_axis = std::max(a, b), g = std::min(a, b) / long_axis;
    const double ratio = load.force_given ? load.value / (2. / 3 * M_PI * a * b * modulus)
                                          : load.value / (ellipse_factors(g).approach * long_axis);
    return contact_of(g, long_axis, ratio, a >= b, modulus);
  }

  HertzContact
  hertz_of_ratio(const double A, const double ratio, const double modulus, const HertzLoad &load)
  {
    // the smaller curvature lies along the long axis
    const bool           long_x = ratio >= 1;
    const double         g      = long_x ? 1 / ratio : ratio;
    const EllipseFactors f      = ellipse_factors(g);
    const double         c      = A / (long_x ? f.flat : f.steep); // p0 / E* over the long axis
    const double         axis   = loaded_axis(g, c, modulus, load);
    return contact_of(g, axis, c * axis, long_x, modulus);
  }

  HertzContact
  hertz_of_cylinders(const double A, const double b, const double modulus, const double force)
  {
    // a^2 = 4 F' R/(pi E*), F' = F/2b, R = 1/2A
    return hertz_of_strip(std::sqrt(force / (M_PI * b * A * modulus)), b, modulus, force);
  }

  HertzContact
  hertz_of_strip(const double a, const double b, const double modulus, const double force)
  {
    // A = 2 F'/(pi a^2 E*) and p0 = 2 F'/(pi a) with F' = F/2b (Johnson 1985, 4.43 and 4.45)
    return {a, b, force / (M_PI * a * a * b * modulus), 0, force, 0, force / (M_PI * a * b)};
  }

  HertzContact
  hertz_of_curvatures(const double A, const double B, const double modulus, const HertzLoad &load)
  {
    // the ratio of the axes has that of the curvatures; bisection of its logarithm. A/B = g^2 (K - E)/(E -
    // g^2 K) rises with the ratio g of the axes from 0 to 1
    const double wanted = std::min(A, B) / std::max(A, B);
    double       low = std::log(1e-6), high = 0;
    for (int k = 0; k < 60; ++k)
      {
        const double         middle              = 0.5 * (low + high);
        const EllipseFactors f                   = ellipse_factors(std::exp(middle));
        (f.flat / f.steep < wanted ? low : high) = middle;
      }
    // 60 halvings: to round-off
    const double g = std::exp(0.5 * (low + high));
    return hertz_of_ratio(A, A <= B ? 1 / g : g, modulus, load);
  }
} // namespace wheelrail
