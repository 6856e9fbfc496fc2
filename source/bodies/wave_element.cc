#include <wheelrail/base/errors.h>
#include <wheelrail/bodies/wave_element.h>

#include <string>

// (1) of doc/theory/bodies.md: u = (u_x, u_y, i w)(x, y) exp(i k z), strains B0 + k B1 with xx u_x,x; yy
// u_y,y; zz -k w (+ u_r/r); xy u_x,y + u_y,x; yz i (w,y + k u_y) (- i w/r); xz i (w,x + k u_x). In brackets
// what a wheel adds, z = r theta. Factors i of both shears cancel in the energy, so that K(k) is real and
// symmetric (Gavric 1995; Nilsson, Jones, Thompson and Ryue 2009).
// Nine nodes and not four: linear ones lock in bending, and 16 mm blocks are divided but three times.

namespace wheelrail
{
  namespace
  {
    constexpr unsigned int n_nodes = n_wave_nodes, n_local = n_wave_local;

    /// Values and derivatives of the nine shape functions at a point of the reference cell [0, 1]^2.
    struct Shapes
    {
      std::array<double, n_nodes> value, xi, eta;
    };
    Shapes
    shapes(const double xi, const double eta)
    {
      // Lagrange's quadratics on the nodes 0, 1/2, 1: (1 - t)(1 - 2 t), 4 t (1 - t), t (2 t - 1), and their
      // slopes; the nine shapes are products of them
      const auto line = [](const double t) {
        return std::array<std::array<double, 3>, 2>{
          {{{(1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)}}, {{4 * t - 3, 4 - 8 * t, 4 * t - 1}}}};
      };
      const auto a = line(xi), b = line(eta);
      Shapes     s;
      for (unsigned int n = 0; n < n_nodes; ++n)
        {
          s.value[n] = a[0][n % 3] * b[0][n / 3];
          s.xi[n]    = a[1][n % 3] * b[0][n / 3];
          s.eta[n]   = a[0][n % 3] * b[1][n / 3];
        }
      return s;
    }

    /// Strains (xx, yy, zz, xy, yz, xz) of one local displacement, the last two over i: B0 + k B1.
    using Strain = std::array<double, 6>;

    void
    strains(const WavePoint &point, const bool wheel, const unsigned int local, Strain &b0, Strain &b1)
    {
      // unknown 3 n + c: component c of node n
      const unsigned int n = local / 3;
      const double       N = point.value[n], r = wheel ? point.place.y : 1;
      b0.fill(0);
      b1.fill(0);
      // B0 and B1 of doc/theory/bodies.md, below (1): the order of strains is xx, yy, zz, xy, yz, xz, shears
      // are engineering ones (2 e_xy). zz = -k w since d(i w)/dz = i k i w; with the factor i in u_z all that
      // is left is real.
      switch (local % 3)
        {
          // with exp(i k z) a derivative along z is a factor i k; of a wheel z = r theta, so that 1/r goes
          // with it, and cylindrical strains have u_r / r in the hoop strain, -u_theta / r in the shear (1)
          case 0: // u_x
            b0[0] = point.dx[n];
            b0[3] = point.dy[n];
            b1[5] = N / r;
            break;
          case 1: // u_y, of a wheel outwards
            b0[1] = point.dy[n];
            b0[2] = wheel ? N / r : 0;
            b0[3] = point.dx[n];
            b1[4] = N / r;
            break;
          default: // w
            b0[4] = point.dy[n] - (wheel ? N / r : 0);
            b0[5] = point.dx[n];
            b1[2] = -N / r;
        }
    }

    Strain
    stress(const Strain &e, const double lambda, const double mu)
    {
      const double trace = lambda * (e[0] + e[1] + e[2]);
      // Hooke: lambda tr(e) I + 2 mu e, shears mu gamma
      return {{trace + 2 * mu * e[0],
               trace + 2 * mu * e[1],
               trace + 2 * mu * e[2],
               mu * e[3],
               mu * e[4],
               mu * e[5]}};
    }

    double
    dot6(const Strain &a, const Strain &b)
    {
      double sum = 0;
      for (int i = 0; i < 6; ++i)
        sum += a[i] * b[i];
      return sum;
    }
  } // namespace


  WavePoint
  wave_point(const SectionMesh &mesh, const std::array<unsigned int, n_wave_nodes> &cell, const int number)
  {
    // nine Gauss points of [0, 1]^2; isoparametric: places by the same shapes
    WavePoint    point;
    const Shapes shape = shapes(wave_gauss_place[number % 3], wave_gauss_place[number / 3]);
    point.value        = shape.value;
    Point2 xi, eta;
    for (unsigned int n = 0; n < n_nodes; ++n)
      {
        const Point2 &p = mesh.nodes[cell[n]];
        point.place     = point.place + shape.value[n] * p;
        xi              = xi + shape.xi[n] * p;
        eta             = eta + shape.eta[n] * p;
      }
    // Jacobian dx/dxi dy/deta - dx/deta dy/dxi, positive where the cell is not folded
    const double area = cross(xi, eta);
    if (!(area > 0))
      throw RunError("A cell of the section at " + std::to_string(1e3 * point.place.x) + " mm, " +
                     std::to_string(1e3 * point.place.y) +
                     " mm is folded, so that its elasticity cannot be "
                     "computed.");
    for (unsigned int n = 0; n < n_nodes; ++n)
      {
        // the inverse of the Jacobian: dN/dx = (N_xi y_eta - N_eta y_xi)/area, dN/dy = (N_eta x_xi - N_xi
        // x_eta)/area
        point.dx[n] = (shape.xi[n] * eta.y - shape.eta[n] * xi.y) / area;
        point.dy[n] = (shape.eta[n] * xi.x - shape.xi[n] * eta.x) / area;
      }
    point.weight = area * wave_gauss_weight[number % 3] * wave_gauss_weight[number / 3];
    return point;
  }


  std::array<WaveMatrix, 4>
  wave_matrices(const SectionMesh                            &mesh,
                const std::array<unsigned int, n_wave_nodes> &cell,
                const Elasticity                             &elasticity,
                const bool                                    wheel)
  {
    std::array<WaveMatrix, 4>   K{};
    std::array<Strain, n_local> b0, b1, s0, s1;
    const double                lambda = elasticity.lame_lambda(), mu = elasticity.shear_modulus();
    for (int g = 0; g < 9; ++g)
      {
        const WavePoint point = wave_point(mesh, cell, g);
        // 3 x 3 Gauss points, exact for straight cells of a rail. A wheel's section counts for one radian, r
        // dr dx; its strain has 1/r, so that forces and energies are those of a radian.
        const double weight = point.weight * (wheel ? point.place.y : 1);
        for (unsigned int i = 0; i < n_local; ++i)
          {
            strains(point, wheel, i, b0[i], b1[i]);
            s0[i] = stress(b0[i], lambda, mu);
            s1[i] = stress(b1[i], lambda, mu);
          }
        for (unsigned int i = 0; i < n_local; ++i)
          // 27 unknowns: (u_x, u_y, w) of nine nodes
          for (unsigned int j = 0; j <= i; ++j)
            {
              // energy of B0 + k B1: K0 = B0' D B0, K1 = B0' D B1 + B1' D B0, K2 = B1' D B1, and the
              // consistent mass rho N N (Gavric 1995; (1) of doc/theory/bodies.md)
              K[0][i][j] += weight * dot6(b0[i], s0[j]);
              K[1][i][j] += weight * (dot6(b0[i], s1[j]) + dot6(b1[i], s0[j]));
              K[2][i][j] += weight * dot6(b1[i], s1[j]);
              // mass couples like components: u_x, u_y and w, whose factors i cancel
              if (i % 3 == j % 3)
                K[3][i][j] += weight * elasticity.density * point.value[i / 3] * point.value[j / 3];
            }
      }
    for (auto &matrix : K)
      for (unsigned int i = 0; i < n_local; ++i)
        for (unsigned int j = i + 1; j < n_local; ++j)
          matrix[i][j] = matrix[j][i];
    return K;
  }
} // namespace wheelrail
