#include <wheelrail/solid/kernel.h>
#include <wheelrail/solid/point_state.h>

#include "contact.h"
#include "rolled_strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace scenes
{
  using namespace wheelrail;

  namespace
  {
    // Lengths in half widths a. The load starts at z = 0 and comes down over the ramp.
    constexpr double half_width = 10e-3; ///< a [m]
    constexpr double ramp = 8, fine_depth = 2, bottom = 40;
    constexpr double speed = 100;  ///< 3 % of that of Rayleigh's waves [m/s]
    constexpr double rest  = 5e-4; ///< in which waves die away [s]

    LocalMesh
    strip_mesh(const LineLoad &load)
    {
      const double        a = half_width, cell = a / load.cells;
      std::vector<double> along;
      for (unsigned int n = 0; n <= load.period * load.cells; ++n)
        along.push_back(n * cell);
      return rail_block({0, cell}, fine_then_coarse(cell, fine_depth * a, bottom * a, 1.3), along);
    }

    Setup
    slow(Setup setup)
    {
      setup.bulk_viscosity = 0.06;
      setup.mass_damping   = 2e4; // forces below 1e-3 of the stresses of a load of this speed
      return setup;
    }

    /// Second integral of sqrt(1 - x2) from the left.
    double
    twice_integrated(const double x)
    {
      if (x <= -1)
        return 0;
      if (x >= 1)
        return M_PI / 2 * x;
      const double root = std::sqrt(1 - x * x);
      return 0.5 * (root - root * root * root / 3 + x * std::asin(x)) + M_PI / 4 * x;
    }

    double
    period_time(const LineLoad &load)
    {
      return load.period * half_width / speed;
    }
  } // namespace


  RolledStrip::RolledStrip(const LineLoad &load, const Setup &setup, const std::optional<MaterialLaw> &law)
    : scene(strip_mesh(load), slow(setup))
    , load_(load)
    , top_(select(scene.solid.mesh, plane(1, 0)))
  {
    if (law)
      set_law(scene.solid.blocks.rail, *law);
    const auto &mesh = scene.solid.mesh;
    double      low  = 0;
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      low = std::min(low, place_of(mesh, n)[1]);
    scene.fix(select(mesh, [](const Vector3 &) { return true; }), 0);
    for (const int component : {1, 2})
      scene.fix(select(mesh, plane(1, low)), component);
    // both faces are numbered in the same order
    scene.join(select(mesh, plane(2, 0)), select(mesh, plane(2, load.period * half_width)));
    scene.add_force([this](const double time, const Solid &, double *force) { press(time, force); });

    std::map<double, std::vector<std::size_t>, std::greater<>> rows;
    for (std::size_t e = 0; e < scene.solid.block_cells.rail.size(); ++e)
      {
        double y = 0;
        for (const unsigned int node : mesh.cells[scene.solid.block_cells.rail[e]])
          y += place_of(mesh, node)[1] / 8;
        if (y > -fine_depth * half_width)
          rows[1e-9 * std::round(1e9 * y)].push_back(e);
      }
    for (auto &[y, row] : rows)
      {
        depth.push_back(-y / half_width);
        rows_.push_back(std::move(row));
      }
  }


  /// The nodal forces of the load, exact for linear shape functions.
  void
  RolledStrip::press(const double time, double *force) const
  {
    const double at    = time * speed / half_width;
    const double on    = std::min(1., at / ramp);
    const double off   = std::clamp((at - lifted_) / ramp, 0., 1.);
    const double peak  = load_.peak * (on * on * (3 - 2 * on) - off * off * (3 - 2 * off));
    const double h     = 1. / load_.cells;
    const double nodal = 0.5 * h * half_width * half_width * peak; // of two across, per length
    for (const unsigned int n : top_)
      {
        const double place = scene.solid.mesh.reference[4 * n + 2] / half_width;
        const double x     = std::remainder(place - at, load_.period);
        if (std::abs(x) >= 1 + h)
          continue;
        double share = (twice_integrated(x - h) - 2 * twice_integrated(x) + twice_integrated(x + h)) / h;
        if (place < 0.5 * h || place > load_.period - 0.5 * h)
          share *= 0.5; // both faces of the seam bear it
        force[4 * n + 1] -= nodal * share;
        force[4 * n + 2] += load_.traction * nodal * share;
      }
  }


  StripPass
  RolledStrip::pass()
  {
    ++passes_;
    while (scene.time() < passes_ * period_time(load_))
      scene.step(scene.steps() % 50 == 0);
    const auto strain = element_plastic_strain(scene.solid.blocks.rail);
    StripPass  result;
    for (const auto &row : rows_)
      {
        double sum[2] = {0, 0};
        for (const std::size_t e : row)
          {
            sum[0] += strain[e];
            sum[1] += element_gradient(scene.solid.blocks.rail, e, scene.solid.displacement.data())[7];
          }
        result.strain.push_back(sum[0] / row.size());
        result.shear.push_back(sum[1] / row.size());
      }
    return result;
  }


  StripResidual
  RolledStrip::unload(const double from, const double to)
  {
    lifted_ = scene.time() * speed / half_width;
    scene.run_to(scene.time() + ramp * half_width / speed + rest);
    const auto stress = element_stress(scene.solid.blocks.rail, scene.solid.displacement.data());
    const auto along  = [&](const std::size_t e) {
      return place_of(scene.solid.mesh, scene.solid.mesh.cells[scene.solid.block_cells.rail[e]][0])[2] /
             half_width;
    };
    StripResidual result;
    for (const auto &row : rows_)
      for (const int k : {0, 1, 2, 3, 4, 5})
        {
          double low = HUGE_VAL, high = -HUGE_VAL;
          for (const std::size_t e : row)
            if (const double z = along(e); z > from && z < to)
              low = std::min(low, stress[e][k]), high = std::max(high, stress[e][k]);
          double &kind = k == 0 || k == 2 ? result.largest : result.other;
          kind         = std::max({kind, std::abs(low), std::abs(high)});
          if (k == 0 || k == 2)
            result.spread = std::max(result.spread, high - low);
        }
    result.other /= result.largest;
    result.spread /= result.largest;
    return result;
  }


  std::array<double, 2>
  RolledStrip::largest_stresses()
  {
    scene.run_to((ramp + 2) * half_width / speed);
    const auto stress = element_stress(scene.solid.blocks.rail, scene.solid.displacement.data());
    // In a half-space the stress along has the mean -P/L at all depths; the period, which cannot become
    // shorter, leaves nu/(1 - nu) of that. P = pi a p0 / 2.
    const double          nu       = scene.solid.blocks.rail.elasticity().poissons_ratio;
    const double          hindered = (1 - 2 * nu) / (1 - nu) * M_PI / 2 / load_.period * load_.peak;
    std::array<double, 2> largest{};
    for (const auto &row : rows_)
      for (const std::size_t e : row)
        {
          auto s = stress[e];
          s[2] -= hindered;
          s[0] -= nu * hindered;
          largest[0] = std::max(largest[0], von_mises(s.data()) / load_.peak);
          largest[1] = std::max(largest[1], std::abs(s[3]) / load_.peak);
        }
    return largest;
  }


  double
  growth(const std::vector<double> &from, const std::vector<double> &to, const double n)
  {
    double largest = 0;
    for (std::size_t i = 0; i < to.size(); ++i)
      largest = std::max(largest, std::abs(to[i] - from[i]) / n);
    return largest;
  }
} // namespace scenes
