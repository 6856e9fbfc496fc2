#include <wheelrail/base/errors.h>
#include <wheelrail/halfspace/subsurface.h>

#include <array>
#include <cmath>
#include <string>

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

    /// Stresses at (x, y, z) from the centre of a loaded element dx x dy.
    void
    add_element(const HalfspaceGrid &grid,
                const double         nu,
                const double         x,
                const double         y,
                const double         z,
                const double         qx,
                const double         qy,
                const double         p,
                HalfspaceStress     &s)
    {
      Derivatives d;
      add_corner(1, x + grid.dx / 2, y + grid.dy / 2, z, d);
      add_corner(-1, x + grid.dx / 2, y - grid.dy / 2, z, d);
      add_corner(-1, x - grid.dx / 2, y + grid.dy / 2, z, d);
      add_corner(1, x - grid.dx / 2, y - grid.dy / 2, z, d);
      add_stress(d, nu, z, qx, qy, p, s);
    }

    void
    check_depth(const double depth)
    {
      if (!(depth >= 0))
        throw InputError("Subsurface stresses: the depth " + std::to_string(depth) +
                         " m is negative; depths count into the body.");
    }

    constexpr std::array<double HalfspaceStress::*, 6> components = {&HalfspaceStress::xx,
                                                                     &HalfspaceStress::yy,
                                                                     &HalfspaceStress::nn,
                                                                     &HalfspaceStress::xy,
                                                                     &HalfspaceStress::xn,
                                                                     &HalfspaceStress::yn};
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
        check_depth(point.depth);
        for (int j = 0; j < g.my; ++j)
          for (int i = 0; i < g.mx; ++i)
            {
              const int e = i + g.mx * j;
              if (solution.pressure[e] <= 0)
                continue;
              add_element(g,
                          body.poisson_ratio,
                          point.x - g.x(i),
                          point.y - g.y(j),
                          point.depth,
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


  SubsurfaceLayers::SubsurfaceLayers(const HalfspaceSolution &solution,
                                     const HalfspaceBody     &body,
                                     const HalfspaceSide      side)
    : grid_(solution.grid)
    , poisson_ratio_(body.poisson_ratio)
    , sign_(side == HalfspaceSide::body1 ? 1 : -1)
    , products_(solution.grid)
  {
    products_.forward(solution.traction_x, loads_[0]);
    products_.forward(solution.traction_y, loads_[1]);
    products_.forward(solution.pressure, loads_[2]);
    for (const int traction : {0, 1})
      for (auto &value : loads_[traction])
        value *= sign_;
  }


  std::vector<HalfspaceStress>
  SubsurfaceLayers::at(const double depth)
  {
    check_depth(depth);
    // stresses under a unit of each load, by the distance in elements
    const int                                   nx = 2 * grid_.mx - 1, ny = 2 * grid_.my - 1;
    std::array<std::vector<HalfspaceStress>, 3> unit;
    for (int load = 0; load < 3; ++load)
      {
        unit[load].resize(std::size_t(nx) * ny);
        for (int j = 0; j < ny; ++j)
          for (int i = 0; i < nx; ++i)
            add_element(grid_,
                        poisson_ratio_,
                        (i - grid_.mx + 1) * grid_.dx,
                        (j - grid_.my + 1) * grid_.dy,
                        depth,
                        load == 0,
                        load == 1,
                        load == 2,
                        unit[load][i + std::size_t(nx) * j]);
      }

    std::vector<HalfspaceStress> stresses(grid_.size());
    std::vector<double>          field;
    InfluenceProducts::Spectrum  sum;
    for (std::size_t c = 0; c < components.size(); ++c)
      {
        sum.assign(products_.spectrum_size(), 0.);
        for (int load = 0; load < 3; ++load)
          {
            const auto kernel = products_.kernel([&](const double x, const double y) {
              const long i = std::lround(x / grid_.dx) + grid_.mx - 1;
              const long j = std::lround(y / grid_.dy) + grid_.my - 1;
              // distances beyond the grid, which the doubled one has, meet no load
              return i < 0 || j < 0 || i >= nx || j >= ny ? 0. : unit[load][i + nx * j].*components[c];
            });
            for (std::size_t m = 0; m < sum.size(); ++m)
              sum[m] += kernel[m] * loads_[load][m];
          }
        products_.backward(sum, field);
        for (std::size_t e = 0; e < stresses.size(); ++e)
          stresses[e].*components[c] = field[e];
      }
    for (HalfspaceStress &s : stresses) // depth runs against n in body 2
      {
        s.xn *= sign_;
        s.yn *= sign_;
      }
    return stresses;
  }
} // namespace wheelrail
