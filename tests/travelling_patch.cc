// label: long

// How deep does a rail flow under one wheel? A prescribed patch travels once over a block of the program's
// elements: no contact, no wheel, no dynamics of a wheelset. Two kinds of patch: the ellipse of Hertz with
// shear traction in proportion, and pressure and tractions of the end of a run
// (tests/reference/patch_280MPa.csv), whose band this checks on cells of two sizes. doc/theory/paper.md has
// what comes out beside the runs. Where nothing flows, the stresses below a circle are Hertz's.

#include <wheelrail/solid/kernel.h>
#include <wheelrail/solid/point_state.h>

#include "scenes/contact.h"
#include "scenes/dynamics.h"

#include "parallel.h"
#include "reference_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace scenes;
using namespace wheelrail;
using test::near;

namespace
{
  constexpr double load  = 103e3; ///< [N]
  constexpr double speed = 100;   ///< 3 % of that of Rayleigh's waves [m/s]
  constexpr double rest  = 3e-4;  ///< in which waves die away [s]
  constexpr double least = 1e-4;  ///< plastic strain of what counts as having flowed [1]

  /// What presses on the rail.
  struct Patch
  {
    std::string name;
    double      along, across; ///< half extents [m]
    double      peak;          ///< largest pressure [Pa]
    /// Pressure and shear tractions on the rail across and along [Pa] at a place across and along from the
    /// middle [m].
    std::function<std::array<double, 3>(double, double)> at;
  };

  /// The ellipse of the load and the peak pressure; shear traction over pressure points backwards, as under a
  /// wheel that drives.
  Patch
  ellipse(const double peak, const double across, const double traction)
  {
    const double along = 1.5 * load / (M_PI * peak * across);
    return {"ellipse, traction " + std::to_string(traction).substr(0, 4),
            along,
            across,
            peak,
            [=](const double x, const double z) {
              const double inside = 1 - std::pow(x / across, 2) - std::pow(z / along, 2);
              const double p      = inside > 0 ? peak * std::sqrt(inside) : 0;
              return std::array<double, 3>{p, 0, -traction * p};
            }};
  }

  /// Bilinear between the nodes of a table of along [mm], across [mm], pressure and shear tractions [MPa],
  /// which are zero at its borders.
  Patch
  patch_of_run(const std::string &file)
  {
    std::vector<double>                along, across;
    std::vector<std::array<double, 3>> values;
    for (const auto &row : test::read_table(file))
      {
        const double z = 1e-3 * std::stod(row[0]), x = 1e-3 * std::stod(row[1]);
        if (along.empty() || z > along.back() + 1e-6)
          along.push_back(z);
        if (along.size() == 1)
          across.push_back(x);
        values.push_back({1e6 * std::stod(row[2]), 1e6 * std::stod(row[3]), 1e6 * std::stod(row[4])});
      }
    Patch        patch{"of the run", 0, 0, 0, {}};
    const double middle_z = 0.5 * (along.front() + along.back()),
                 middle_x = 0.5 * (across.front() + across.back());
    patch.along           = along.back() - middle_z;
    patch.across          = across.back() - middle_x;
    for (const auto &value : values)
      patch.peak = std::max(patch.peak, value[0]);
    patch.at = [=](const double x, const double z) {
      const double u = (x + middle_x - across.front()) / (across[1] - across[0]),
                   v = (z + middle_z - along.front()) / (along[1] - along[0]);
      std::array<double, 3> value{};
      if (u <= 0 || v <= 0 || u >= across.size() - 1 || v >= along.size() - 1)
        return value;
      const std::size_t j = static_cast<std::size_t>(u), i = static_cast<std::size_t>(v);
      for (const std::size_t di : {0, 1})
        for (const std::size_t dj : {0, 1})
          for (int k = 0; k < 3; ++k)
            value[k] += (di ? v - i : 1 - v + i) * (dj ? u - j : 1 - u + j) *
                        values[(i + di) * across.size() + j + dj][k];
      return value;
    };
    return patch;
  }

  /// What one passage leaves in the stretch that the whole load rolled over.
  struct Left
  {
    double strain   = 0; ///< largest accumulated plastic strain of an element [1]
    double depth    = 0; ///< to which it is above 1e-4 [m]
    double width    = 0; ///< over which it is [m]
    double residual = 0; ///< largest von Mises stress of elements that flowed [Pa]
  };

  /// A block over which a patch goes along z, once it has come down at z = 0.
  class Passage
  {
  public:
    Passage(const Patch &patch, const double yield_stress, const double cell)
      : patch_(patch)
      , cell_(cell)
      , way_(6.5 * patch.along)
      , scene_(mesh(), setup(yield_stress))
      , top_(select(scene_.solid.mesh, plane(1, 0)))
    {
      const auto &mesh = scene_.solid.mesh;
      Vector3     low{}, high{};
      for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
        for (int d = 0; d < 3; ++d)
          {
            low[d]  = std::min(low[d], place_of(mesh, n)[d]);
            high[d] = std::max(high[d], place_of(mesh, n)[d]);
          }
      for (int component = 0; component < 3; ++component)
        scene_.fix(select(mesh, plane(1, low[1])), component);
      for (const double end : {low[2], high[2]})
        scene_.fix(select(mesh, plane(2, end)), 2);
      scene_.add_force([this](const double time, const Solid &, double *force) { press(time, force); });
    }
    Passage(const Passage &) = delete; // the load refers to it

    Left
    roll()
    {
      while (scene_.time() < (way_ + 0.5 * patch_.along) / speed)
        scene_.step(scene_.steps() % 50 == 0);
      BOOST_TEST(near(scene_.energy().error(), 0, 2e-3, "energy error"));
      scene_.run_to(scene_.time() + rest);
      return left();
    }

    /// Largest von Mises stress over the peak pressure, and its depth over the half extent along, under the
    /// load on its way.
    std::pair<double, double>
    hardest()
    {
      scene_.run_to(0.6 * way_ / speed);
      const auto stress = element_stress(scene_.solid.blocks.rail, scene_.solid.displacement.data());
      std::pair<double, double> largest;
      for (std::size_t e = 0; e < stress.size(); ++e)
        if (const double s = von_mises(stress[e].data()) / patch_.peak; s > largest.first)
          largest = {s, -centre(e)[1] / patch_.along};
      return largest;
    }

  private:
    LocalMesh
    mesh() const
    {
      const double a    = patch_.along;
      const auto graded = [&](const double fine) { return fine_then_coarse(cell_, fine, fine + 4 * a, 1.3); };
      std::vector<double> along = graded(way_ + a), behind = both_sides(graded(a));
      behind.resize(behind.size() / 2);
      along.insert(along.begin(), behind.begin(), behind.end());
      return rail_block(both_sides(graded(patch_.across + 0.2 * a)), graded(1.7 * a), along);
    }

    static Setup
    setup(const double yield_stress)
    {
      Setup setup;
      setup.bulk_viscosity = 0.06;
      setup.mass_damping   = 2e4;
      if (yield_stress > 0)
        setup.plasticity = {yield_stress, 21e9, 0};
      return setup;
    }

    /// From 0 to 1 and back over ramps of one and a half half extents at both ends of the path.
    double
    share_of_load(const double at) const
    {
      const double on = std::clamp(std::min(at, way_ - at) / (1.5 * patch_.along), 0., 1.);
      return on * on * (3 - 2 * on);
    }

    /// The tractions, shared out among the nodes of the top by their shape functions (64 points around a
    /// node).
    void
    press(const double time, double *force) const
    {
      constexpr int points = 4;
      const double  at     = speed * time;
      const double  area   = share_of_load(at) * cell_ * cell_ / (points * points);
      if (area <= 0)
        return;
      for (const unsigned int n : top_)
        {
          const Vector3 X = place_of(scene_.solid.mesh, n);
          if (std::abs(X[0]) > patch_.across + cell_ || std::abs(X[2] - at) > patch_.along + cell_)
            continue;
          for (int i = -points; i < points; ++i)
            for (int j = -points; j < points; ++j)
              {
                const double u = (i + 0.5) / points, v = (j + 0.5) / points;
                const double share    = area * (1 - std::abs(u)) * (1 - std::abs(v));
                const auto   traction = patch_.at(X[0] + u * cell_, X[2] + v * cell_ - at);
                force[4 * n] += share * traction[1];
                force[4 * n + 1] -= share * traction[0];
                force[4 * n + 2] += share * traction[2];
              }
        }
    }

    Vector3
    centre(const std::size_t element) const
    {
      const auto &mesh = scene_.solid.mesh;
      Vector3     place{};
      for (const unsigned int node : mesh.cells[scene_.solid.block_cells.rail[element]])
        add(place, 0.125, place_of(mesh, node));
      return place;
    }

    /// In the middle of the path.
    Left
    left() const
    {
      const auto strain = element_plastic_strain(scene_.solid.blocks.rail);
      const auto stress = element_stress(scene_.solid.blocks.rail, scene_.solid.displacement.data());
      Left       found;
      double     low = 0, high = 0;
      std::map<double, double> largest; // strain over the depth of the cells' centres
      for (std::size_t e = 0; e < strain.size(); ++e)
        {
          const Vector3 place = centre(e);
          if (std::abs(place[2] - 0.5 * way_) > patch_.along / 3)
            continue;
          double &here = largest[1e-9 * std::round(-1e9 * place[1])];
          here         = std::max(here, strain[e]);
          if (strain[e] <= 0)
            continue;
          found.strain   = std::max(found.strain, strain[e]);
          found.residual = std::max(found.residual, von_mises(stress[e].data()));
          if (strain[e] < least)
            continue;
          low  = std::min(low, place[0]);
          high = std::max(high, place[0]);
        }
      // linear between the centres
      for (auto below = std::next(largest.begin()), above = largest.begin(); below != largest.end();
           above = below++)
        if (above->second >= least && below->second < least)
          found.depth = above->first + (below->first - above->first) * (above->second - least) /
                                         (above->second - below->second);
      found.width = high - low;
      return found;
    }

    Patch    patch_;
    double   cell_, way_; ///< [m]
    Dynamics scene_;
    Nodes    top_;
  };

  Left
  report(const Patch &patch, const double yield_stress, const double cell = 1e-3)
  {
    Passage    passage(patch, yield_stress, cell);
    const Left left = passage.roll();
    std::cout << std::fixed << std::setprecision(1) << "        " << patch.name << ", " << 2e3 * patch.along
              << " x " << 2e3 * patch.across << " mm, peak " << 1e-6 * patch.peak << " MPa; yield stress "
              << 1e-6 * yield_stress << " MPa, cells of " << 1e3 * cell << " mm: strain " << 1e3 * left.strain
              << "e-3, above 1e-4 to " << 1e3 * left.depth << " mm of depth and over " << 1e3 * left.width
              << " mm, residual " << 1e-6 * left.residual << " MPa\n"
              << std::defaultfloat;
    return left;
  }

  BOOST_FIXTURE_TEST_CASE(elastic, test::Parallel)
  {
    constexpr double peak       = 1200e6;
    const Patch      circle     = ellipse(peak, std::sqrt(1.5 * load / (M_PI * peak)), 0);
    const auto [largest, depth] = Passage(circle, 0, 1e-3).hardest();
    BOOST_TEST(near(
      largest, 0.620, 0.01, "largest von Mises stress over the peak pressure (Johnson, 1985, section 3.4)"));
    BOOST_TEST(near(depth, 0.48, 0.09, "its depth over the radius, cells of a seventh of it"));
  }

  BOOST_FIXTURE_TEST_CASE(yielding, test::Parallel)
  {
    const Left frictionless = report(ellipse(1198e6, 7e-3, 0), 680e6);
    BOOST_TEST((frictionless.strain > 1e-4 && frictionless.depth > 2e-3),
               "680 MPa flows below the surface, without friction, too");
    BOOST_TEST(report(ellipse(1198e6, 7e-3, 0.25), 680e6).residual > 30e6,
               "680 MPa: residual stress under traction");
    BOOST_TEST(report(ellipse(760e6, 11e-3, 0.25), 280e6).depth > 4e-3,
               "280 MPa: an ellipse flows deeper than 4 mm");

    const Patch patch = patch_of_run("patch_280MPa.csv");
    const Left  run = report(patch, 280e6), fine = report(patch, 280e6, 0.7e-3);
    BOOST_TEST(
      near(run.depth, fine.depth, 0.7e-3, "patch of a run: depth on cells of 1 mm and of 0.7 mm [m]"));
    BOOST_TEST(near(run.residual / fine.residual, 1, 0.1, "residual stress on these cells, ratio"));
  }
} // namespace
