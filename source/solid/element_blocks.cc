#include <wheelrail/base/errors.h>
#include <wheelrail/base/vector3.h>
#include <wheelrail/solid/full_element.h>
#include <wheelrail/solid/reduced_element.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

// What an element needs of its geometry, once: B_a, V, h_m X, axes A, half lengths (doc/theory/element.md,
// Uniform gradients, Stabilisation, SIMD).

namespace wheelrail
{
  namespace
  {
    using Vector = std::array<double, 3>;
    using Matrix = std::array<Vector, 3>;

    // lexicographic: bit k of the node's number gives the side along xi_k
    constexpr int sign[8][3] =
      {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}};

    /// Values of the four hourglass patterns at node a.
    std::array<double, 4>
    hourglass(const int a)
    {
      // the patterns have no gradient at the centre: sum over a of h_m(a) = 0 and sum of h_m(a) xi_a = 0
      const double xi = sign[a][0], eta = sign[a][1], zeta = sign[a][2];
      // h_1 ... h_4 of doc/theory/element.md, Uniform gradients: what one point does not see
      return {eta * zeta, zeta * xi, xi * eta, xi * eta * zeta};
    }

    /// Columns of the Jacobian dX/dxi at a point of the unit cell [-1, 1]^3.
    Matrix
    jacobian(const std::array<Vector, 8> &X, const Vector &xi)
    {
      // J[k] is the column dX/dxi_k: edges of the cell, halved
      Matrix J{};
      for (int a = 0; a < 8; ++a)
        for (int k = 0; k < 3; ++k)
          {
            // dN_a/dxi_k with N_a = prod (1 + sign_al xi_l)/8
            double d = sign[a][k] / 8.;
            for (int l = 0; l < 3; ++l)
              if (l != k)
                d *= 1 + sign[a][l] * xi[l];
            for (int i = 0; i < 3; ++i)
              J[k][i] += d * X[a][i];
          }
      return J;
    }

    /// Orthonormal axes closest to the columns of J: polar decomposition by Newton's iteration
    /// Q <- (Q + Q^-T) / 2 (Higham 1986), scaled by det^(-1/3), which makes the first steps large and tends
    /// to one. It converges quadratically: cells of 1 : 1e6 take eight steps to round-off.
    Matrix
    closest_rotation(const Matrix &J)
    {
      Matrix Q = J;
      for (int iteration = 0; iteration < 20; ++iteration)
        {
          // Q^-T = cofactor/det Q
          const Matrix cofactor = {cross(Q[1], Q[2]), cross(Q[2], Q[0]), cross(Q[0], Q[1])};
          const double det      = dot(Q[0], cofactor[0]);
          // a cell of millimetres has J of the order 1e-3: unscaled, the first step would leap to J^-T/2 =
          // 500, and nine more would halve that
          const double scale  = std::pow(std::abs(det), -1. / 3);
          double       change = 0;
          for (int k = 0; k < 3; ++k)
            for (int i = 0; i < 3; ++i)
              {
                const double value = 0.5 * (scale * Q[k][i] + cofactor[k][i] / (det * scale));
                change             = std::max(change, std::abs(value - Q[k][i]));
                Q[k][i]            = value;
              }
          if (change < 1e-14) // some units of round-off of numbers of size one
            break;
        }
      return Q;
    }

    /// Adds the parts of B, volume and node volumes that one Gauss point contributes.
    void
    add_gauss_point(const std::array<Vector, 8> &X, const Vector &xi, ElementGeometry &g)
    {
      // det J at the point is its share of the volume [m3], since all weights are 1
      const Matrix J        = jacobian(X, xi);
      const Matrix cofactor = {cross(J[1], J[2]), cross(J[2], J[0]), cross(J[0], J[1])};
      // J^-T det J: dN/dX = sum over k of dN/dxi_k cofactor_k/det J, so that det J cancels in the integral
      const double det = dot(J[0], cofactor[0]);
      if (!(det > 0))
        throw RunError("a cell of the mesh is folded near (" + std::to_string(X[0][0]) + ", " +
                       std::to_string(X[0][1]) + ", " + std::to_string(X[0][2]) +
                       ") m: its Jacobian is not positive; choose another coarse cell size");
      // V = sum of det J over eight points of weight 1
      g.volume += det;
      for (int a = 0; a < 8; ++a)
        {
          double value = 1. / 8;
          Vector d     = {sign[a][0] / 8., sign[a][1] / 8., sign[a][2] / 8.};
          for (int k = 0; k < 3; ++k)
            {
              value *= 1 + sign[a][k] * xi[k];
              for (int l = 0; l < 3; ++l)
                if (l != k)
                  d[k] *= 1 + sign[a][l] * xi[l];
            }
          // integral of N_a dV: the lumped mass over rho
          g.node_volume[a] += value * det;
          for (int i = 0; i < 3; ++i)
            g.B[a][i] += d[0] * cofactor[0][i] + d[1] * cofactor[1][i] + d[2] * cofactor[2][i];
        }
    }
  } // namespace


  ElementGeometry
  element_geometry(const std::array<Vector, 8> &vertices)
  {
    // 1. Volume, mean gradients and nodal volumes
    ElementGeometry g{};
    g.vertices = vertices;
    // 2 x 2 x 2 Gauss points, weights 1: exact for integrals of dN/dX and N over a trilinear cell
    const double point = 1 / std::sqrt(3.);
    for (const auto &s : sign)
      add_gauss_point(vertices, {s[0] * point, s[1] * point, s[2] * point}, g);
    for (auto &gradient : g.B)
      for (double &component : gradient)
        // B_a = (1/V) integral dN_a/dX dV (Flanagan and Belytschko 1981)
        component /= g.volume;

    // 2. What stabilisation needs: h_m X, axes A, half lengths l_k
    for (int a = 0; a < 8; ++a)
      for (int m = 0; m < 4; ++m)
        for (int i = 0; i < 3; ++i)
          // h_m X = sum over a of h_m(a) X_a: 0 of a brick
          g.hX[m][i] += hourglass(a)[m] * vertices[a][i];

    // axes A: orthonormal, closest to the columns of the Jacobian at the centre
    const Matrix J = jacobian(vertices, {0, 0, 0});
    g.frame        = closest_rotation(J);
    for (int k = 0; k < 3; ++k)
      // l_k: half the length of the cell along xi_k, at its centre
      g.half[k] = std::sqrt(dot(J[k], J[k]));
    return g;
  }


  double
  element_frequency_bound(const ElementGeometry &g, const Elasticity &material)
  {
    // A plane wave strains in one direction: (lambda + 2 mu) times the largest eigenvalue of sum B B^T.
    // A free element alone could breathe in three, which no wave in a mesh does.
    Matrix S{};
    for (const auto &b : g.B)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          S[i][j] += b[i] * b[j];
    // largest eigenvalue of a symmetric 3x3 matrix by the trigonometric formula (Smith 1961)
    // lambda_max = mean + 2 p cos(acos(det((S - mean 1)/p)/2)/3), p^2 = tr((S - mean 1)^2)/6
    // 1. s, the largest eigenvalue [1/m2]: 4/h^2 for a cube of edge h
    const double p1   = S[0][1] * S[0][1] + S[0][2] * S[0][2] + S[1][2] * S[1][2];
    const double mean = (S[0][0] + S[1][1] + S[2][2]) / 3;
    const double p2 =
      std::pow(S[0][0] - mean, 2) + std::pow(S[1][1] - mean, 2) + std::pow(S[2][2] - mean, 2) + 2 * p1;
    double largest = mean;
    if (p2 > 0)
      {
        const double p = std::sqrt(p2 / 6);
        Matrix       D = S;
        for (int i = 0; i < 3; ++i)
          {
            D[i][i] -= mean;
            for (int j = 0; j < 3; ++j)
              D[i][j] /= p;
          }
        const double r = std::clamp(dot(D[0], cross(D[1], D[2])) / 2, -1., 1.);
        largest += 2 * p * std::cos(std::acos(r) / 3);
      }
    // omega^2 = (lambda + 2 mu) s V/(rho V_min) of doc/theory/element.md, Stable step; (2 c_p/h)^2 for a cube
    // 2. The lightest node of the cell, V_min, sets the pace
    const double smallest_share = *std::min_element(g.node_volume.begin(), g.node_volume.end());
    return (material.lame_lambda() + 2 * material.shear_modulus()) * largest * g.volume /
           (material.density * smallest_share);
  }


  ElementBlocks
  pack_elements(const std::vector<ElementGeometry>             &geometry,
                const std::vector<std::array<unsigned int, 8>> &cells,
                const MaterialLaw                              &law,
                const int                                       width,
                const ElementForm                               form)
  {
    if (form == ElementForm::full)
      return pack_full_elements(geometry, cells, law, width);
    const Elasticity &material = elasticity(law);
    ElementBlocks     blocks;
    blocks.width                = width;
    blocks.n_elements           = cells.size();
    const std::size_t n_batches = (cells.size() + width - 1) / width;
    blocks.data.assign(n_batches * ElementBlocks::fields * width, 0.);
    blocks.nodes.resize(n_batches * 8 * width);
    blocks.viscous.assign(n_batches * 2 * width, 0.);
    for (const auto &g : geometry)
      blocks.volume.push_back(g.volume);

    for (std::size_t slot = 0; slot < n_batches * width; ++slot)
      {
        const std::size_t batch = slot / width, lane = slot % width;
        // 1. Nodes of the lane; fillers read those of the first element, so that no address is out of range
        const bool        filler = slot >= cells.size();
        const std::size_t e      = filler ? batch * width : slot;
        double           *data   = blocks.data.data() + batch * ElementBlocks::fields * width + lane;
        for (int a = 0; a < 8; ++a)
          blocks.nodes[(batch * 8 + a) * width + lane] = cells[e][a];
        if (filler)
          continue; // zero gradients, volume and half lengths give zero force
        // 2. 50 rows: B_a 24, V 1, h_m X 12, axes 9, c_k sqrt(V/3) 3, L 1 (doc/theory/element.md, SIMD)
        const ElementGeometry &g     = geometry[e];
        int                    field = 0;
        const auto             put   = [&](const double value) { data[width * field++] = value; };
        for (const auto &b : g.B)
          for (const double component : b)
            put(component);
        put(g.volume);
        for (const auto &x : g.hX)
          for (const double component : x)
            put(component);
        for (const auto &axis : g.frame)
          for (const double component : axis)
            put(component);
        for (const double half : g.half)
          put(reduced::scaled_inverse_half(g.volume, half));
        // L = 2 c_p/omega, the length of the bulk viscosity: about the shortest edge
        put(2 * material.wave_speed() / std::sqrt(element_frequency_bound(g, material)));
      }
    set_law(blocks, law);
    return blocks;
  }


  void
  set_law(ElementBlocks &blocks, const MaterialLaw &law)
  {
    blocks.law                  = law;
    const std::size_t n_batches = blocks.plastic() ? blocks.n_batches() : 0;
    // zeros are the virgin state of all laws: E_p, back stresses, a and plastic amplitudes
    blocks.history.assign(n_batches * blocks.history_rows() * blocks.width, 0.);
    blocks.plastic_work.assign(n_batches * blocks.width, 0.);
    blocks.flowed.assign(n_batches, 0);
  }


  void
  mark_flowed(ElementBlocks &blocks)
  {
    // a batch without flow is not loaded nor stored by the kernel; the mark says which have flowed
    const std::size_t size = std::size_t(blocks.history_rows()) * blocks.width;
    for (std::size_t batch = 0; batch < blocks.flowed.size(); ++batch)
      {
        const auto begin = blocks.history.begin() + batch * size;
        blocks.flowed[batch] =
          std::any_of(begin, begin + size, [](const double value) { return value != 0; }) ? 1 : 0;
      }
  }
} // namespace wheelrail
