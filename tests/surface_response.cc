// label: fast

// Surface of an endless mesh under waves of nodal forces, against the exact half-space: the error is of
// second order in the cell size, and of fourth order behind the surface filter.

#include <wheelrail/contact/surface_response.h>

#include "near.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  std::array<double, 24 * 24>
  cube_stiffness(const Elasticity &material, const ElementForm form)
  {
    std::array<std::array<double, 3>, 8> vertices;
    for (int a = 0; a < 8; ++a)
      vertices[a] = {double(a & 1), double(a >> 1 & 1), double(a >> 2)};
    return element_stiffness(element_geometry(vertices), material, form);
  }

  /// What a wave of wave numbers kx, ky keeps of its amplitude in the filter of this weight.
  double
  kept(const double weight, const double kx, const double ky)
  {
    return (1 - weight * (1 - std::cos(kx))) * (1 - weight * (1 - std::cos(ky)));
  }

  void
  second_order(const Elasticity &material, const ElementForm form)
  {
    const auto stiffness = cube_stiffness(material, form);
    const auto coarse    = surface_response(stiffness, material, 0.4, 0),
               fine      = surface_response(stiffness, material, 0.2, 0);
    BOOST_TEST(near(std::log2(coarse.normal / fine.normal), 2, 0.05, "order of the normal response"));
    BOOST_TEST(near(std::log2(coarse.perpendicular / fine.perpendicular),
                    2,
                    0.05,
                    "order of the response across the wave"));
    BOOST_TEST(near(
      fine.perpendicular / 0.04, 1. / 12, 1e-3, "across the wave only the hat functions err: (k h)^2/12"));
  }

  void
  filtered(const Elasticity &material, const ElementForm form)
  {
    const auto   stiffness = cube_stiffness(material, form);
    const auto   filter    = surface_filter(stiffness, material);
    const double nu        = material.poissons_ratio;
    std::cout << "        nu " << nu << ": weights " << filter.normal << ", " << filter.shear << "\n";
    for (const double k : {0.1, 0.3, 0.5, 0.8})
      {
        double mean = 0, plain = 0;
        for (const double angle : {0., M_PI / 8, M_PI / 4, 3 * M_PI / 8})
          {
            const double kx = k * std::cos(angle), ky = k * std::sin(angle);
            const auto   r = surface_response(stiffness, material, kx, ky);
            plain += r.normal / 4;
            mean += ((1 + r.normal) * std::pow(kept(filter.normal, kx, ky), 2) - 1) / 4;
          }
        // what the next order leaves here, and in the weights, which are taken at k h = 0.3
        const double left = 0.05 * std::pow(k, 4) + 0.015 * plain;
        BOOST_TEST(
          near(mean,
               0,
               left,
               "k h = " + std::to_string(k) + ": mean normal error, plain " + std::to_string(plain)));
        const auto   r     = surface_response(stiffness, material, k, 0);
        const double shear = (1 + r.perpendicular) * std::pow(kept(filter.shear, k, 0), 2) - 1;
        BOOST_TEST(near(shear, 0, left, "shear across the wave"));
      }
  }

  /// By how much of a cell nodes that are held at a straight edge act farther out than they lie, see
  /// doc/theory/contact.md: of a half-line of nodes that are displaced by equal amounts, with the responses
  /// over the exact ones at the midpoints of equal parts of (0, pi), filtered with `weight` (Wiener and
  /// Hopf).
  double
  edge_beyond_nodes(const std::vector<double> &responses, const double weight)
  {
    const double n   = static_cast<double>(responses.size());
    double       sum = 0;
    for (unsigned int i = 0; i < responses.size(); ++i)
      {
        const double k = (i + 0.5) * M_PI / n;
        const double g = responses[i] * 2 * std::sin(0.5 * k) / k * std::pow(kept(weight, k, 0), 2);
        sum += std::log(g) / (1 - std::cos(k));
      }
    return 0.25 - sum / (2 * n);
  }

  /// Pressure and shear begin at the same place: what the lattice makes of the edge of the patch, of first
  /// order in the cell size, is the same for nodes that come into contact and for nodes that then stick. Else
  /// a rolling contact would be too stiff or too soft by as much of its length.
  void
  edges_meet()
  {
    const Elasticity    material;
    const auto          stiffness = cube_stiffness(material, ElementForm::reduced);
    const auto          filter    = surface_filter(stiffness, material);
    std::vector<double> normal, parallel, perpendicular, exact;
    for (int i = 0; i < 64; ++i)
      {
        const auto r = surface_response(stiffness, material, (i + 0.5) * M_PI / 64, 0);
        normal.push_back(1 + r.normal);
        parallel.push_back(1 + r.parallel);
        perpendicular.push_back(1 + r.perpendicular);
        exact.push_back(1);
      }
    BOOST_TEST(near(edge_beyond_nodes(exact, 0), 0.31, 1e-3, "edge beyond the nodes of an exact half-space"));
    const double pressure = edge_beyond_nodes(normal, filter.normal);
    std::cout << "        edge beyond the nodes, in cells: pressure " << pressure << " (without filter "
              << edge_beyond_nodes(normal, 0) << "), shear along the track " << edge_beyond_nodes(parallel, 0)
              << ", across it " << edge_beyond_nodes(perpendicular, filter.shear) << " (without filter "
              << edge_beyond_nodes(perpendicular, 0) << ")\n";
    BOOST_TEST(
      near(pressure - edge_beyond_nodes(parallel, 0), 0, 0.02, "shear along the track begins there"));
    BOOST_TEST(near(
      pressure - edge_beyond_nodes(perpendicular, filter.shear), 0, 0.02, "shear across the track, too"));
  }

  /// Forces filtered by S do the work of displacements filtered by S; linear fields stay.
  void
  filter_is_symmetric()
  {
    Lattice lattice;
    lattice.n_along   = 9;
    lattice.n_lateral = 7;
    std::vector<Vector3> u, f, line;
    for (unsigned int i = 0; i < lattice.n_along; ++i)
      for (unsigned int j = 0; j < lattice.n_lateral; ++j)
        {
          u.push_back({std::sin(1. + i * j), std::cos(2. * i + j), std::sin(3. * j - i)});
          f.push_back({std::cos(1. * i * j), std::sin(2. * i - j), std::cos(5. * j + i)});
          line.push_back({1. + i, 2. * j, 3. * i - j});
        }
    const FilterWeights weights{{0.1, 0.05, 0}, {0.09, 0, 0.2}};
    auto                Su = u, Sf = f, kept_line = line;
    filter_surface(lattice, 1, 8, weights, Su);
    filter_surface(lattice, 1, 8, weights, Sf);
    filter_surface(lattice, 1, 8, weights, kept_line);
    Vector3 sum{}, filtered_sum{};
    double  left = 0, right = 0, bend = 0;
    for (unsigned int k = 0; k < u.size(); ++k)
      {
        left += dot(f[k], Su[k]);
        right += dot(Sf[k], u[k]);
        sum                  = sum + f[k];
        filtered_sum         = filtered_sum + Sf[k];
        const unsigned int i = k / lattice.n_lateral, j = k % lattice.n_lateral;
        if (i > 1 && i < 7 && j > 0 && j < 6)
          bend = std::max(bend, norm(kept_line[k] - line[k]));
      }
    BOOST_TEST(near(left, right, 1e-13, "f . S u = S f . u"));
    BOOST_TEST(near(norm(sum - filtered_sum), 0, 1e-13, "the sum of the forces stays"));
    BOOST_TEST(near(bend, 0, 1e-14, "linear fields stay inside the border"));
    const auto stencil = filter_stencil(lattice, 1, 8, 0.1, 4, 3);
    BOOST_TEST(near(stencil[1][1], 0.81, 1e-15, "weight of the node itself"));
    BOOST_TEST(near(stencil[0][1] + stencil[2][1] + stencil[1][0] + stencil[1][2] + stencil[0][0] +
                      stencil[2][2] + stencil[0][2] + stencil[2][0],
                    0.19,
                    1e-15,
                    "weights of its neighbours"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(responses)
{
  for (const double nu : {0.0, 0.3, 0.45})
    {
      Elasticity material;
      material.poissons_ratio = nu;
      for (const ElementForm form : {ElementForm::reduced, ElementForm::full})
        {
          second_order(material, form);
          filtered(material, form);
        }
    }
  edges_meet();
  filter_is_symmetric();
}
