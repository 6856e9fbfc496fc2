// ranks: 1 2

// A free disc spinning at the speed of the rolling wheel: the stress of the exact rotating disc, and no
// drift of angular momentum, energy or place.

#include <wheelrail/dynamics/time_loop.h>
#include <wheelrail/mesh/shared_nodes.h>

#include "parallel.h"
#include "scenes/make_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <map>
#include <numeric>
#include <vector>

using namespace wheelrail;
using namespace test;

namespace
{
  constexpr double       inner = 0.0925, outer = 0.46, thickness = 0.028, velocity = 38.974;
  constexpr double       rate      = velocity / outer; // rho V^2 is 12 MPa
  constexpr unsigned int n_sectors = 72, n_radial = 16, n_axial = 1;

  std::uint32_t
  node_number(const unsigned int sector, const unsigned int r, const unsigned int x)
  {
    return (sector % n_sectors * (n_radial + 1) + r) * (n_axial + 1) + x;
  }

  Vector3
  node_place(const std::uint32_t number)
  {
    const unsigned int x = number % (n_axial + 1), r = number / (n_axial + 1) % (n_radial + 1);
    const unsigned int sector = number / ((n_axial + 1) * (n_radial + 1));
    const double       angle  = 2 * M_PI / n_sectors * sector;
    const double       radius = inner + (outer - inner) * r / n_radial;
    return {thickness * (double(x) / n_axial - 0.5), -radius * std::cos(angle), radius * std::sin(angle)};
  }

  /// The ring of hexahedra, its sectors shared evenly among the ranks.
  LocalMesh
  ring(const int rank, const int size)
  {
    LocalMesh                             mesh;
    std::map<std::uint32_t, unsigned int> local;
    for (unsigned int s = rank * n_sectors / size; s < (rank + 1) * n_sectors / size; ++s)
      for (unsigned int r = 0; r < n_radial; ++r)
        for (unsigned int x = 0; x < n_axial; ++x)
          {
            std::array<unsigned int, 8> cell;
            for (unsigned int a = 0; a < 8; ++a)
              {
                // axial, radial (outwards is down), around: a right-handed cell
                const auto number         = node_number(s + (a >> 2), r + (1 - (a >> 1 & 1)), x + (a & 1));
                const auto [entry, fresh] = local.try_emplace(number, mesh.node_key.size());
                if (fresh)
                  mesh.node_key.push_back(number);
                cell[a] = entry->second;
              }
            mesh.cells.push_back(cell);
          }
    mesh.cell_body.assign(mesh.cells.size(), Body::wheel);
    mesh.cell_level.assign(mesh.cells.size(), 0);
    mesh.global_node.resize(mesh.node_key.size());
    mesh.node_body.assign(mesh.n_nodes(), Body::wheel);
    mesh.hanging_begin = {0};
    for (const auto n : mesh.node_key)
      {
        const Vector3 X = node_place(static_cast<std::uint32_t>(n));
        mesh.reference.insert(mesh.reference.end(), {X[0], X[1], X[2], 0.});
      }
    number_nodes(mesh, MPI_COMM_WORLD);
    return mesh;
  }

  /// Stresses and radial displacement of the rotating annular disc in plane stress (Timoshenko and
  /// Goodier, Theory of Elasticity, 3rd edition 1970, section 32).
  struct Exact
  {
    double radial, hoop, displacement;
  };

  Exact
  exact_disc(const double r, const Elasticity &material)
  {
    const double nu = material.poissons_ratio, a2 = inner * inner, b2 = outer * outer, r2 = r * r;
    const double f      = (3 + nu) / 8 * material.density * rate * rate;
    const double radial = f * (a2 + b2 - a2 * b2 / r2 - r2);
    const double hoop   = f * (a2 + b2 + a2 * b2 / r2 - (1 + 3 * nu) / (3 + nu) * r2);
    return {radial, hoop, r / material.youngs_modulus * (hoop - nu * radial)};
  }

  /// Sums over all ranks.
  struct State
  {
    Vector3 angular{}, momentum{}, centre{};
    double  kinetic = 0;
  };

  State
  sums(const Solid &solid)
  {
    State state;
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.owns(n))
        {
          const double *v = &solid.velocity[4 * n];
          const Vector3 V = {v[0], v[1], v[2]}, x = solid.position(n);
          add(state.angular, solid.mass[n], cross(x, V));
          add(state.momentum, solid.mass[n], V);
          add(state.centre, solid.mass[n], x);
          state.kinetic += 0.5 * solid.mass[n] * dot(V, V);
        }
    MPI_Allreduce(MPI_IN_PLACE, &state, 10, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return state;
  }

  /// Exact displacement and the velocity of its rigid rotation.
  void
  start(Solid &solid)
  {
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      {
        const double *R   = &solid.mesh.reference[4 * n];
        const double  r   = std::hypot(R[1], R[2]),
                     grow = exact_disc(r, solid.blocks.wheel.elasticity()).displacement / r;
        const Exact  here = exact_disc(r, solid.blocks.wheel.elasticity());
        const double nu   = solid.blocks.wheel.elasticity().poissons_ratio,
                     E    = solid.blocks.wheel.elasticity().youngs_modulus;
        const Vector3 u   = {-nu / E * (here.radial + here.hoop) * R[0], grow * R[1], grow * R[2]};
        const Vector3 x   = {0, R[1] + u[1], R[2] + u[2]};
        const Vector3 v   = rate * cross({1, 0, 0}, x);
        for (int i = 0; i < 3; ++i)
          {
            solid.displacement[4 * n + i] = u[i];
            solid.velocity[4 * n + i]     = v[i];
          }
      }
  }

  /// Means over time of radial and hoop stress in each ring of cells [Pa], and their scatter around it.
  class StressMeans
  {
  public:
    void
    sample(const Solid &solid)
    {
      const auto stress = element_stress(solid.blocks.wheel, solid.displacement.data());
      for (std::size_t e = 0; e < stress.size(); ++e)
        {
          Vector3 x{};
          double  R = 0;
          for (const unsigned int n : solid.mesh.cells[solid.block_cells.wheel[e]])
            {
              add(x, 1. / 8, solid.position(n));
              R += std::hypot(solid.mesh.reference[4 * n + 1], solid.mesh.reference[4 * n + 2]) / 8;
            }
          const double r = std::hypot(x[1], x[2]), c = x[1] / r, s = x[2] / r;
          const auto  &t       = stress[e];
          const int    ring    = std::min<int>(n_radial - 1, (R - inner) / (outer - inner) * n_radial);
          const double radial  = c * c * t[1] + s * s * t[2] + 2 * c * s * t[3];
          const double hoop    = s * s * t[1] + c * c * t[2] - 2 * c * s * t[3];
          const double part[5] = {1, radial, hoop, radial * radial, hoop * hoop};
          for (int k = 0; k < 5; ++k)
            sums_[5 * ring + k] += part[k];
        }
    }

    void
    check_against_exact(const Elasticity &material)
    {
      MPI_Allreduce(MPI_IN_PLACE, sums_, 5 * n_radial, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
      const double scale    = exact_disc(inner, material).hoop;
      double       error[2] = {0, 0}, scatter = 0;
      for (unsigned int ring = 0; ring < n_radial; ++ring)
        {
          const double *s = &sums_[5 * ring];
          const Exact   e = exact_disc(inner + (outer - inner) * (ring + 0.5) / n_radial, material);
          error[0]        = std::max(error[0], std::abs(s[1] / s[0] - e.radial) / scale);
          error[1]        = std::max(error[1], std::abs(s[2] / s[0] - e.hoop) / scale);
          for (int k = 1; k < 3; ++k)
            scatter =
              std::max(scatter, std::sqrt(std::max(0., s[2 + k] / s[0] - s[k] * s[k] / s[0] / s[0])) / scale);
        }
      std::cout << "        hoop stress at the bore " << 1e-6 * scale << " MPa\n";
      BOOST_TEST(near(error[0], 0, 0.01, "radial stress, largest error over the hoop stress at the bore"));
      BOOST_TEST(near(error[1], 0, 0.01, "hoop stress, largest error over that at the bore"));
      BOOST_TEST(near(scatter,
                      0,
                      0.01,
                      "scatter of the stress in time and around the disc over the hoop stress at the bore"));
    }

  private:
    double sums_[5 * n_radial] = {};
  };

  /// What must not change.
  struct Balance
  {
    double              angular = 0, momentum = 0, strain = 0;
    std::vector<double> total;

    void
    add(const State &now, const EnergyBalance &energy, const State &first)
    {
      angular  = std::max(angular, norm(now.angular - first.angular));
      momentum = std::max(momentum, norm(now.momentum - first.momentum));
      strain   = energy["strain_energy"] + energy["stabilisation_energy"];
      total.push_back(energy.stored());
    }
  };

  BOOST_FIXTURE_TEST_CASE(free_turn, test::Parallel)
  {
    Solid        solid = scenes::make_solid(ring(rank, size), Elasticity(), Elasticity(), 0, MPI_COMM_WORLD);
    const double step  = 0.9 * solid.stable.step;
    // one rank makes the whole turn
    const int   n_steps = static_cast<int>(2 * M_PI / rate / step / (size > 1 ? 10 : 1));
    StressMeans means;
    start(solid);
    TimeLoop loop(solid, {step, 0, 0}, MPI_COMM_WORLD);
    loop.prepare();
    const State first = sums(solid);
    BOOST_TEST(near(first.angular[0] /
                      (M_PI / 2 * 7900 * thickness * (std::pow(outer, 4) - std::pow(inner, 4)) * rate),
                    1,
                    5e-3,
                    "angular momentum of the ring of hexahedra over that of the disc"));
    Balance balance;
    for (int n = 0; n < n_steps; ++n)
      {
        // not the start, whose kinetic energy is that of one velocity: turning by an angle a step, the
        // product of two is a^2/4 smaller
        const bool sample = n % 10 == 9;
        loop.step(sample);
        if (sample)
          balance.add(sums(solid), loop.energy(), first);
        if (n % 97 == 0)
          means.sample(solid);
      }
    const State       last  = sums(solid);
    const double      mass  = mass_properties(solid, Body::wheel, {}, MPI_COMM_WORLD).mass;
    const auto       &total = balance.total;
    const std::size_t tenth = total.size() / 10;
    const auto        mean  = [&](const std::size_t begin) {
      return std::accumulate(&total[begin], &total[begin] + tenth, 0.) / double(tenth);
    };
    const double drift = mean(total.size() - tenth) - mean(0);
    const auto   range = std::minmax_element(total.begin(), total.end());
    std::cout << "        " << n_steps << " steps, kinetic energy " << last.kinetic << " J, strain energy "
              << balance.strain << " J\n";
    BOOST_TEST(near(balance.angular / norm(first.angular), 0, 1e-10, "angular momentum, largest change"));
    BOOST_TEST(near(balance.momentum / (mass * velocity), 0, 1e-12, "momentum, largest change over m V"));
    BOOST_TEST(near(norm(last.centre - first.centre) / mass, 0, 1e-10, "way of the centre [m]"));
    BOOST_TEST(near(drift / balance.strain, 0, 1e-6, "energy drift over the strain energy"));
    BOOST_TEST(
      near((*range.second - *range.first) / last.kinetic, 0, 1e-6, "energy, range over the kinetic energy"));
    means.check_against_exact(solid.blocks.wheel.elasticity());
  }
} // namespace
