#include <wheelrail/solid/full_element.h>
#include <wheelrail/solid/full_points.h>
#include <wheelrail/solid/point_state.h>

#include <cmath>

// Eight points with the mean dilatation of the cell in their strains (Nagtegaal, Parks and Rice 1974; Hughes
// 1980), here on Green's strain: a rotation changes no E_g and leaves no stress (doc/theory/element.md, The
// full element). Without it nu = 0.4999 has a fifth of the exact deflection.

namespace wheelrail
{
  namespace
  {
    using Vector = std::array<double, 3>;

    /// Rows of the packed geometry (full_points.h) of one element, without the length.
    std::array<double, full::fields>
    geometry_rows(const std::array<Vector, 8> &X)
    {
      std::array<double, full::fields> row{};
      for (int a = 0; a < 8; ++a)
        {
          // signs of the natural coordinates of node a
          const double s[3] = {a & 1 ? 1. : -1., a & 2 ? 1. : -1., a & 4 ? 1. : -1.};
          for (int i = 0; i < 3; ++i)
            {
              for (int k = 0; k < 3; ++k)
                {
                  // X(xi) = sum of coefficients: xi_k, xi_k+1 xi_k+2 and xi eta zeta; signs of the nodes pick
                  // them out. Those of products have the place of a Gauss point, 1/sqrt(3), once, that of the
                  // triple product twice (1/3).
                  row[full::linear_row + 3 * k + i] += s[k] * X[a][i] / 8;
                  row[full::product_row + 3 * k + i] +=
                    s[(k + 1) % 3] * s[(k + 2) % 3] * full::gauss * X[a][i] / 8;
                }
              row[full::triple_row + i] += s[0] * s[1] * s[2] * X[a][i] / 24;
            }
        }
      return row;
    }

    /// The eight points of one packed element, with the mean dilatation in their strains.
    struct ElementPoints
    {
      full::Point<1> point[8];
      double         volume = 0;
    };

    ElementPoints
    element_points(const ElementBlocks &blocks, const std::size_t element, const double *displacement)
    {
      // W = 1: the kernel's own functions on one element
      const std::size_t W = blocks.width, batch = element / W, lane = element % W;
      double            row[full::fields];
      for (int r = 0; r < full::fields; ++r)
        row[r] = blocks.data[(batch * full::fields + r) * W + lane];
      Simd<1> u[8][3];
      for (int a = 0; a < 8; ++a)
        for (int i = 0; i < 3; ++i)
          u[a][i] = displacement[4 * blocks.nodes[(batch * 8 + a) * W + lane] + i];
      // the map and the displacements have the same shape functions (isoparametric)
      full::Derivatives<1> dX, du;
      full::reference_derivatives<1>(row, dX);
      full::nodal_derivatives<1>(u, du);
      ElementPoints points;
      // 1. Points with their own strains; 2. one dilatation for all
      double dilatation = 0;
      for (int g = 0; g < 8; ++g)
        {
          auto &p = points.point[g];
          full::evaluate_point<1>(dX, du, g, p);
          // V = sum of w_g = det dX/dxi
          points.volume += p.weight[0];
          // theta = (1/V) sum w_g tr E_g; Ebar_g = E_g + (theta - tr E_g)/3 I (Nagtegaal, Parks and Rice
          // 1974; doc/theory/element.md, The full element)
          dilatation += p.weight[0] * full::trace<1>(p.E)[0];
        }
      for (auto &p : points.point)
        full::set_trace<1>(dilatation / points.volume, p.E);
      return points;
    }

    /// Displacement gradient of a point, row-major.
    std::array<double, 9>
    gradient(const full::Point<1> &point)
    {
      // H = F - 1
      std::array<double, 9> H;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          H[3 * i + j] = point.F[i][j][0] - (i == j);
      return H;
    }
  } // namespace


  ElementBlocks
  pack_full_elements(const std::vector<ElementGeometry>             &geometry,
                     const std::vector<std::array<unsigned int, 8>> &cells,
                     const MaterialLaw                              &law,
                     const int                                       width)
  {
    const Elasticity &material = elasticity(law);
    ElementBlocks     blocks;
    blocks.form                 = ElementForm::full;
    blocks.rows                 = full::fields;
    blocks.width                = width;
    blocks.n_elements           = cells.size();
    const std::size_t n_batches = (cells.size() + width - 1) / width;
    blocks.data.resize(n_batches * full::fields * width);
    blocks.nodes.resize(n_batches * 8 * width);
    blocks.viscous.assign(n_batches * 2 * width, 0.);
    for (const auto &g : geometry)
      blocks.volume.push_back(g.volume);
    for (std::size_t slot = 0; slot < n_batches * width; ++slot)
      {
        const std::size_t batch = slot / width, lane = slot % width;
        const bool        filler = slot >= cells.size();
        const std::size_t e      = filler ? batch * width : slot;
        // 21 coefficients of the trilinear map: Jacobians computed from them in the kernel cost less than
        // loading eight (doc/theory/element.md, The full element)
        auto row = geometry_rows(geometry[e].vertices);
        // L = 2 c_p/omega, as of the reduced element
        row[full::length_row] =
          2 * material.wave_speed() / std::sqrt(element_frequency_bound(geometry[e], material));
        for (int r = 0; r < full::fields; ++r)
          blocks.data[(batch * full::fields + r) * width + lane] = row[r];
        for (int a = 0; a < 8; ++a)
          // a filler has all nodes at one place: no strain, no force
          blocks.nodes[(batch * 8 + a) * width + lane] = cells[e][filler ? 0 : a];
      }
    set_law(blocks, law);
    return blocks;
  }


  std::array<std::array<double, 6>, 8>
  full_point_stress(const ElementBlocks &blocks, const std::size_t element, const double *displacement)
  {
    // sigma = F_g S_g F_g'/det F_g of each point, with Ebar_g in the law and the true F_g [Pa]
    const ElementPoints                  points = element_points(blocks, element, displacement);
    std::array<std::array<double, 6>, 8> stress;
    for (int g = 0; g < 8; ++g)
      {
        Simd<1> S[6];
        point_stress(blocks, element, g, points.point[g].E, S);
        stress[g] = cauchy_stress(gradient(points.point[g]), S);
      }
    return stress;
  }


  std::array<double, 6>
  full_mean_stress(const ElementBlocks &blocks, const std::size_t element, const double *displacement)
  {
    const ElementPoints   points = element_points(blocks, element, displacement);
    const auto            stress = full_point_stress(blocks, element, displacement);
    std::array<double, 6> mean{};
    for (int g = 0; g < 8; ++g)
      for (int k = 0; k < 6; ++k)
        // volume mean of the eight Cauchy stresses
        mean[k] += points.point[g].weight[0] / points.volume * stress[g][k];
    return mean;
  }


  std::array<double, 9>
  full_mean_gradient(const ElementBlocks &blocks, const std::size_t element, const double *displacement)
  {
    const ElementPoints points = element_points(blocks, element, displacement);
    // mean of the true gradients, not of those with the cell's dilatation: the integral of du/dX over the
    // cell
    std::array<double, 9> H{};
    for (const auto &p : points.point)
      for (int k = 0; k < 9; ++k)
        H[k] += p.weight[0] / points.volume * gradient(p)[k];
    return H;
  }


  std::array<double, 24 * 24>
  full_element_stiffness(const std::array<Vector, 8> &vertices, const Elasticity &material)
  {
    // K = sum over g of w_g (2 mu dev B_g : dev B_g) + (bulk/V) (integral tr B)^2: shear at eight points,
    // dilatation once in the cell (B-bar of Hughes 1980, at rest)
    const double         mu = material.shear_modulus(), bulk = material.bulk_modulus();
    const auto           rows = geometry_rows(vertices);
    full::Derivatives<1> dX, still{};
    full::reference_derivatives<1>(rows.data(), dX);
    std::array<double, 24 * 24> K{};
    std::array<Vector, 8>       mean{}; // integral of the shape functions' gradients
    double                      volume = 0;
    for (int g = 0; g < 8; ++g)
      {
        full::Point<1> point;
        full::evaluate_point<1>(dX, still, g, point);
        const double weight = point.weight[0];
        Vector       d[8]; // gradients of the shape functions
        for (int a = 0; a < 8; ++a)
          for (int j = 0; j < 3; ++j)
            {
              d[a][j] = 0;
              for (int k = 0; k < 3; ++k)
                {
                  // dN_a/dxi_k at the Gauss point g: +-1/2 along k times (1 +- 1/sqrt(3))/2 along the two
                  // others, plus where node and point lie on the same side (equal bits of a and g)
                  double slope = a >> k & 1 ? 0.5 : -0.5;
                  for (int l = 0; l < 3; ++l)
                    if (l != k)
                      slope *= (1 + ((a ^ g) >> l & 1 ? -full::gauss : full::gauss)) / 2;
                  // dN_a/dX = sum over k of dN_a/dxi_k cofactor_k/det J, at the Gauss point g
                  d[a][j] += slope * point.cofactor[k][j][0] / weight;
                }
              // integral of dN_a/dX: the gradient of the cell's dilatation
              mean[a][j] += weight * d[a][j];
            }
        volume += weight;
        // 2 mu dev E : dev E with E of the gradients e_i (x) d_a and e_j (x) d_b
        for (int a = 0; a < 8; ++a)
          for (int b = 0; b < 8; ++b)
            {
              const double product = d[a][0] * d[b][0] + d[a][1] * d[b][1] + d[a][2] * d[b][2];
              for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                  // (i, j) entry of mu (d_a . d_b 1 + d_b (x) d_a - 2/3 d_a (x) d_b)
                  K[24 * (3 * a + i) + 3 * b + j] +=
                    weight * mu * ((i == j ? product : 0.) + d[a][j] * d[b][i] - 2. / 3 * d[a][i] * d[b][j]);
            }
      }
    for (int r = 0; r < 24; ++r)
      for (int c = 0; c < 24; ++c)
        // K theta^2/2 V with theta = (1/V) sum over a of (integral of dN_a/dX) . u_a: one dilatation in a
        // cell
        K[24 * r + c] += bulk / volume * mean[r / 3][r % 3] * mean[c / 3][c % 3];
    return K;
  }
} // namespace wheelrail
