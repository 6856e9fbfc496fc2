#include <wheelrail/halfspace/element_stress.h>

#include <array>
#include <cmath>

// Stresses of a rectangle under constant tractions in closed form (Love 1929 for the pressure; Johnson 1985,
// section 3.2, for tractions). z is the depth, rho = sqrt(x^2 + y^2 + z^2), W the integral of Omega = z
// ln(rho + z) - rho over the rectangle. Closed integrals and not point loads, which near the surface err by
// more than the stress.
// Checked: von Mises 0.6200 p0 below a sphere, shear p0/4 below a line, within 0.04 %
// (doc/theory/halfspace.md, Verification).

namespace wheelrail
{
  namespace
  {
    /// a + rho without cancellation; rest is rho^2 - a^2.
    double
    sum_with(const double a, const double rho, const double rest)
    {
      // (rho + a)(rho - a) = rest: for a < 0 the sum of two numbers of nearly the same size is not formed
      return a >= 0 ? a + rho : rest / (rho - a);
    }

    /// atan(a / b), 0 at a = 0.
    double
    angle(const double a, const double b)
    {
      return a == 0 ? 0 : std::atan(a / b);
    }

    using Derivatives                                   = PotentialDerivatives;
    constexpr std::array<double Derivatives::*, 20> all = {
      &Derivatives::xxx,  &Derivatives::xxy,  &Derivatives::xyy,  &Derivatives::yyy,  &Derivatives::xxz,
      &Derivatives::xyz,  &Derivatives::yyz,  &Derivatives::xzz,  &Derivatives::yzz,  &Derivatives::zzz,
      &Derivatives::xxxz, &Derivatives::xxyz, &Derivatives::xyyz, &Derivatives::yyyz, &Derivatives::xxzz,
      &Derivatives::xyzz, &Derivatives::yyzz, &Derivatives::xzzz, &Derivatives::yzzz, &Derivatives::zzzz};
  } // namespace


  // Each line is the integral over x and y of the derivative of z ln(rho + z) - rho; those with three x or y
  // follow from Laplace's equation.
  PotentialDerivatives
  corner_derivatives(const double x, const double y, const double z)
  {
    PotentialDerivatives d;
    // (x, y): from the corner to the point, z > 0 into the body [m]
    const double rho = std::sqrt(x * x + y * y + z * z);
    const double xr = sum_with(x, rho, y * y + z * z), yr = sum_with(y, rho, x * x + z * z), zr = rho + z;
    // third derivatives: homogeneous of degree 0, logarithms at the edges of a load, where tractions jump
    const double lx = std::log(xr), ly = std::log(yr);
    d.xxy = -x / zr;
    d.xyy = -y / zr;
    d.xxx = y / zr - ly;
    d.yyy = x / zr - lx;
    d.xyz = std::log(zr);
    d.xzz = ly;
    d.yzz = lx;
    d.zzz = -std::atan2(x * y, z * rho);
    // limits at x = 0 and y = 0 come from angle(): both terms vanish
    d.xxz = angle(y, x) - angle(z * y, x * rho);
    d.yyz = angle(x, y) - angle(z * x, y * rho);
    // fourth derivatives, one more d/dz: homogeneous of degree -1, so that stresses times z stay finite
    const double xxyz = x / (rho * zr), xyyz = y / (rho * zr), xzzz = z / (rho * yr), yzzz = z / (rho * xr);
    const double xxzz = x / (rho * yr), yyzz = y / (rho * xr);
    d.xxyz = xxyz;
    d.xyyz = xyyz;
    d.xyzz = 1 / rho;
    d.xxzz = xxzz;
    d.yyzz = yyzz;
    d.xzzz = xzzz;
    d.yzzz = yzzz;
    // harmonic: xxzz + yyzz + zzzz = 0 and so on
    d.zzzz = -(xxzz + yyzz);
    d.xxxz = -(xyyz + xzzz);
    d.yyyz = -(xxyz + yzzz);
    return d;
  }


  PotentialDerivatives
  rectangle_derivatives(const PotentialDerivatives &far_far,
                        const PotentialDerivatives &far_near,
                        const PotentialDerivatives &near_far,
                        const PotentialDerivatives &near_near)
  {
    PotentialDerivatives d;
    for (const auto part : all)
      // definite integral over x and y from that at the corners
      d.*part = far_far.*part - far_near.*part - near_far.*part + near_near.*part;
    return d;
  }


  // psi1 = F1_x + G1_y + H1_z, psi = psi1_z and the displacements are those of Johnson (1985), (3.2) to
  // (3.7).
  void
  add_stress(const PotentialDerivatives &d,
             const double                nu,
             const double                z,
             const double                qx,
             const double                qy,
             const double                p,
             HalfspaceStress            &s)
  {
    const double factor = 1 / (2 * M_PI); // 2 G / (4 pi G)
    // Derivatives of psi1 (a) and psi (b).
    // F1 = q_x W, G1 = q_y W, H1 = p W, W the integral of z ln(rho + z) - rho (Boussinesq 1885, Cerruti 1882;
    // Love 1929). psi1 = F1_x + G1_y + H1_z, psi = psi1_z:
    const double a_xx = qx * d.xxx + qy * d.xxy + p * d.xxz, a_xy = qx * d.xxy + qy * d.xyy + p * d.xyz,
                 a_yy = qx * d.xyy + qy * d.yyy + p * d.yyz;
    const double b_z  = qx * d.xzz + qy * d.yzz + p * d.zzz;
    const double b_xx = qx * d.xxxz + qy * d.xxyz + p * d.xxzz, b_xy = qx * d.xxyz + qy * d.xyyz + p * d.xyzz,
                 b_yy = qx * d.xyyz + qy * d.yyyz + p * d.yyzz, b_xz = qx * d.xxzz + qy * d.xyzz + p * d.xzzz,
                 b_yz = qx * d.xyzz + qy * d.yyzz + p * d.yzzz, b_zz = qx * d.xzzz + qy * d.yzzz + p * d.zzzz;
    // nu / (1 - 2 nu) times the dilatation, from which (1 - 2 nu) cancels.
    const double volume = 2 * nu * b_z;
    // u_x = (2 F_z - H_x + 2 nu psi1_x - z psi_x)/(4 pi G), u_y likewise, u_z = (H_z + (1 - 2 nu) psi - z
    // psi_z)/(4 pi G) with F = F1_z, G = G1_z, H = H1_z. Stress = 2 G strain + 2 G nu/(1 - 2 nu) div u, div u
    // = 2 (1 - 2 nu) psi_z/(4 pi G).
    s.xx += factor * (2 * qx * d.xzz - p * d.xxz + 2 * nu * a_xx - z * b_xx + volume);
    s.yy += factor * (2 * qy * d.yzz - p * d.yyz + 2 * nu * a_yy - z * b_yy + volume);
    s.nn += factor * (p * d.zzz - 2 * nu * b_z - z * b_zz + volume);
    s.xy += factor * (qx * d.yzz + qy * d.xzz - p * d.xyz + 2 * nu * a_xy - z * b_xy);
    // (u_x,z + u_z,x) / 2: H_x in one cancels that in the other, and so do nu psi_x and -nu psi_x.
    s.xn += factor * (qx * d.zzz - z * b_xz);
    s.yn += factor * (qy * d.zzz - z * b_yz);
  }
} // namespace wheelrail
