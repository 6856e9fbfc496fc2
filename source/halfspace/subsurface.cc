#include <wheelrail/base/errors.h>
#include <wheelrail/halfspace/subsurface.h>

#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Derivatives of W, the integral over a rectangle of z ln(rho + z) - rho, rho the distance to the point.
    struct Derivatives
    {
      double xxx = 0, xxy = 0, xyy = 0, yyy = 0;
      double xxz = 0, xyz = 0, yyz = 0, xzz = 0, yzz = 0, zzz = 0;
      double xxxz = 0, xxyz = 0, xyyz = 0, yyyz = 0;
      double xxzz = 0, xyzz = 0, yyzz = 0, xzzz = 0, yzzz = 0, zzzz = 0;
    };

    /// a + rho without cancellation; rest is rho^2 - a^2.
    double
    sum_with(const double a, const double rho, const double rest)
    {
      return a >= 0 ? a + rho : rest / (rho - a);
    }

    /// atan(a / b), 0 at a = 0.
    double
    angle(const double a, const double b)
    {
      return a == 0 ? 0 : std::atan(a / b);
    }

    /// Adds `sign` times the contribution of a corner at the distance (x, y, z). Each line is the integral
    /// over x and y of the derivative of z ln(rho + z) - rho; those with three x or y follow from Laplace's
    /// equation.
    void
    add_corner(const double sign, const double x, const double y, const double z, Derivatives &d)
    {
      const double rho = std::sqrt(x * x + y * y + z * z);
      const double xr = sum_with(x, rho, y * y + z * z), yr = sum_with(y, rho, x * x + z * z), zr = rho + z;
      const double lx = std::log(xr), ly = std::log(yr);
      d.xxy -= sign * x / zr;
      d.xyy -= sign * y / zr;
      d.xxx += sign * (y / zr - ly);
      d.yyy += sign * (x / zr - lx);
      d.xyz += sign * std::log(zr);
      d.xzz += sign * ly;
      d.yzz += sign * lx;
      d.zzz -= sign * std::atan2(x * y, z * rho);
      d.xxz += sign * (angle(y, x) - angle(z * y, x * rho));
      d.yyz += sign * (angle(x, y) - angle(z * x, y * rho));
      const double xxyz = x / (rho * zr), xyyz = y / (rho * zr), xzzz = z / (rho * yr), yzzz = z / (rho * xr);
      const double xxzz = x / (rho * yr), yyzz = y / (rho * xr);
      d.xxyz += sign * xxyz;
      d.xyyz += sign * xyyz;
      d.xyzz += sign / rho;
      d.xxzz += sign * xxzz;
      d.yyzz += sign * yyzz;
      d.xzzz += sign * xzzz;
      d.yzzz += sign * yzzz;
      d.zzzz -= sign * (xxzz + yyzz);
      d.xxxz -= sign * (xyyz + xzzz);
      d.yyyz -= sign * (xxyz + yzzz);
    }

    /// Adds the stresses under tractions (qx, qy) and pressure p on the rectangle, z into the body.
    /// psi1 = F1_x + G1_y + H1_z, psi = psi1_z and the displacements are those of Johnson (1985), (3.2) to
    /// (3.7).
    void
    add_stress(const Derivatives &d,
               const double       nu,
               const double       z,
               const double       qx,
               const double       qy,
               const double       p,
               HalfspaceStress   &s)
    {
      const double factor = 1 / (2 * M_PI); // 2 G / (4 pi G)
      // Derivatives of psi1 (a) and psi (b).
      const double a_xx = qx * d.xxx + qy * d.xxy + p * d.xxz, a_xy = qx * d.xxy + qy * d.xyy + p * d.xyz,
                   a_yy = qx * d.xyy + qy * d.yyy + p * d.yyz;
      const double b_z  = qx * d.xzz + qy * d.yzz + p * d.zzz;
      const double b_xx = qx * d.xxxz + qy * d.xxyz + p * d.xxzz,
                   b_xy = qx * d.xxyz + qy * d.xyyz + p * d.xyzz,
                   b_yy = qx * d.xyyz + qy * d.yyyz + p * d.yyzz,
                   b_xz = qx * d.xxzz + qy * d.xyzz + p * d.xzzz,
                   b_yz = qx * d.xyzz + qy * d.yyzz + p * d.yzzz,
                   b_zz = qx * d.xzzz + qy * d.yzzz + p * d.zzzz;
      // nu / (1 - 2 nu) times the dilatation, from which (1 - 2 nu) cancels.
      const double volume = 2 * nu * b_z;
      s.xx += factor * (2 * qx * d.xzz - p * d.xxz + 2 * nu * a_xx - z * b_xx + volume);
      s.yy += factor * (2 * qy * d.yzz - p * d.yyz + 2 * nu * a_yy - z * b_yy + volume);
      s.nn += factor * (p * d.zzz - 2 * nu * b_z - z * b_zz + volume);
      s.xy += factor * (qx * d.yzz + qy * d.xzz - p * d.xyz + 2 * nu * a_xy - z * b_xy);
      // (u_x,z + u_z,x) / 2: H_x in one cancels that in the other, and so do nu psi_x and -nu psi_x.
      s.xn += factor * (qx * d.zzz - z * b_xz);
      s.yn += factor * (qy * d.zzz - z * b_yz);
    }
  } // namespace

  double
  HalfspaceStress::von_mises() const
  {
    return std::sqrt(0.5 * (std::pow(xx - yy, 2) + std::pow(yy - nn, 2) + std::pow(nn - xx, 2)) +
                     3 * (xy * xy + xn * xn + yn * yn));
  }

  std::vector<HalfspaceStress>
  subsurface_stresses(const HalfspaceSolution            &solution,
                      const HalfspaceBody                &body,
                      const HalfspaceSide                 side,
                      const std::vector<SubsurfacePoint> &points)
  {
    const HalfspaceGrid         &g    = solution.grid;
    const double                 sign = side == HalfspaceSide::body1 ? 1 : -1;
    std::vector<HalfspaceStress> stresses(points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
      {
        const SubsurfacePoint &point = points[k];
        if (!(point.depth >= 0))
          throw InputError("Subsurface stresses: the depth " + std::to_string(point.depth) +
                           " m is negative; depths count into the body.");
        for (int j = 0; j < g.my; ++j)
          for (int i = 0; i < g.mx; ++i)
            {
              const int e = i + g.mx * j;
              if (solution.pressure[e] <= 0)
                continue;
              const double x = point.x - g.x(i), y = point.y - g.y(j), z = point.depth;
              Derivatives  d;
              add_corner(1, x + g.dx / 2, y + g.dy / 2, z, d);
              add_corner(-1, x + g.dx / 2, y - g.dy / 2, z, d);
              add_corner(-1, x - g.dx / 2, y + g.dy / 2, z, d);
              add_corner(1, x - g.dx / 2, y - g.dy / 2, z, d);
              add_stress(d,
                         body.poisson_ratio,
                         z,
                         sign * solution.traction_x[e],
                         sign * solution.traction_y[e],
                         solution.pressure[e],
                         stresses[k]);
            }
        // Depth runs against n in body 2.
        stresses[k].xn *= sign;
        stresses[k].yn *= sign;
      }
    return stresses;
  }
} // namespace wheelrail
