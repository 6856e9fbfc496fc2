// label: fast

// Elastic-plastic bars: waves of a bilinear rod on a wall, cyclic loading with both kinds of hardening, and
// shocks that yield in one step.

#include "scenes/dynamics.h"

#include "parallel.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace scenes;
using namespace wheelrail;

namespace
{
  constexpr double length = 0.1;

  /// A wave in two steps: stresses behind both fronts [Pa] and their speeds [m/s].
  struct TwoWaves
  {
    double elastic_stress, plastic_stress, elastic_speed, plastic_speed;
  };

  /// Rod: uniaxial stress (von Karman and Duwez 1950); block: uniaxial strain, with the moduli lambda + 2 mu
  /// and K + 4/3 of the shear tangent.
  TwoWaves
  exact_waves(const Setup &setup, const bool confined, const double velocity)
  {
    const Elasticity &m  = setup.material;
    const Plasticity &p  = setup.plasticity;
    const double      nu = m.poissons_ratio, E_t = p.tangent_modulus;
    const double      H = m.youngs_modulus * E_t / (m.youngs_modulus - E_t), mu = m.shear_modulus();
    const double      elastic = confined ? m.lame_lambda() + 2 * mu : m.youngs_modulus;
    const double      plastic = confined ? m.bulk_modulus() + 4. / 3 * mu * H / (3 * mu + H) : E_t;
    TwoWaves          w;
    w.elastic_speed       = std::sqrt(elastic / m.density);
    w.plastic_speed       = std::sqrt(plastic / m.density);
    w.elastic_stress      = p.yield_stress * (confined ? (1 - nu) / (1 - 2 * nu) : 1);
    const double at_yield = w.elastic_stress / (m.density * w.elastic_speed);
    w.plastic_stress      = w.elastic_stress + m.density * w.plastic_speed * (velocity - at_yield);
    return w;
  }

  /// The body flies against a wall; stresses over the exact ones and places of both fronts over the exact
  /// ones just before the elastic wave reaches the far end.
  void
  impact(Setup setup, const bool confined, const double velocity, const std::string &text)
  {
    const unsigned int cells = 300;
    const double       h     = length / cells;
    const std::string  name  = form_name(setup) + (confined ? ", block, " : ", rod, ") + text + ": ";
    setup.bulk_viscosity     = 0.06;
    setup.step_factor        = confined ? 0.9 : 0.7; // every node lies on a free edge
    Dynamics    scene(box({0, 0, 0}, {length, h, h}, {cells, 1, 1}), setup);
    const auto &mesh = scene.solid.mesh;
    if (confined)
      for (const int component : {1, 2})
        scene.fix(select(mesh, [](const Vector3 &) { return true; }), component);
    const auto wall = scene.wall(select(mesh, plane(0, 0)), 0, 1, [](double) { return 0.; });
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      scene.solid.velocity[4 * n] = -velocity;
    const TwoWaves exact = exact_waves(setup, confined, velocity);
    const double   end   = 0.85 * length / exact.elastic_speed;
    double         force = 0;
    unsigned int   count = 0;
    while (scene.time() < end)
      {
        scene.step(scene.steps() % 100 == 0);
        if (scene.time() > 0.3 * end)
          force += scene.reaction(wall) / (h * h), ++count;
      }
    scene.step(true);
    const auto   stress  = element_stress(scene.solid.blocks.wheel, scene.solid.displacement.data());
    const double middle  = 0.5 * (exact.elastic_stress + exact.plastic_stress);
    double       mean[2] = {0, 0}, front[2] = {0, 0};
    unsigned int number[2] = {0, 0};
    for (unsigned int e = 0; e < cells; ++e)
      {
        const double x = (e + 0.5) * h, s = -stress[e][0];
        const double reached[2] = {exact.plastic_speed * end, exact.elastic_speed * end};
        if (x < 0.7 * reached[0])
          mean[0] += s / exact.plastic_stress, ++number[0];
        if (x > 1.5 * reached[0] && x < 0.6 * reached[1])
          mean[1] += s / exact.elastic_stress, ++number[1];
        front[0] = s > middle ? (x + h / 2) / reached[0] : front[0];
        front[1] = s > 0.5 * exact.elastic_stress ? (x + h / 2) / reached[1] : front[1];
      }
    std::cout << "        stresses " << exact.elastic_stress * 1e-6 << ", " << exact.plastic_stress * 1e-6
              << " MPa, speeds " << exact.elastic_speed << ", " << exact.plastic_speed << " m/s\n";
    BOOST_TEST(test::near(force / count / exact.plastic_stress, 1, 0.01, name + "force on the wall"));
    if (number[1] > 0)
      BOOST_TEST(test::near(mean[1] / number[1], 1, 0.01, name + "stress behind the elastic front"));
    BOOST_TEST(test::near(front[1], 1, 0.015, name + "place of the elastic front"));
    if (exact.plastic_speed * end > 20 * h)
      {
        BOOST_TEST(test::near(mean[0] / number[0], 1, 0.01, name + "stress behind the plastic front"));
        BOOST_TEST(test::near(front[0], 1, 0.03, name + "place of the plastic front"));
      }
    BOOST_TEST(test::near(scene.energy().error(), 0, 0.01, name + "energy error"));
  }

  /// Stress of the bilinear law in one dimension at the end of a path of strains (Simo and Hughes 1998, box
  /// 1.5, exact for monotonic pieces).
  std::vector<double>
  one_dimension(const Setup &setup, const std::vector<double> &path)
  {
    const Plasticity &p = setup.plasticity;
    const double      E = setup.material.youngs_modulus, H = E * p.tangent_modulus / (E - p.tangent_modulus);
    double            plastic = 0, accumulated = 0, back = 0;
    std::vector<double> stress;
    for (const double strain : path)
      {
        const double trial = E * (strain - plastic), relative = trial - back;
        const double over =
          std::abs(relative) - p.yield_stress - (1 - p.kinematic_fraction) * H * accumulated;
        const double flow = std::max(0., over) / (E + H), sign = relative > 0 ? 1 : -1;
        plastic += sign * flow, accumulated += flow, back += p.kinematic_fraction * H * sign * flow;
        stress.push_back(E * (strain - plastic));
      }
    return stress;
  }

  /// A bar pulled and pushed slowly, stress at the turning points of the strain.
  void
  cyclic(Setup setup, const double fraction)
  {
    setup.plasticity                   = {280e6, 21e9, fraction};
    setup.mass_damping                 = 1e5;
    setup.step_factor                  = 0.7;
    const std::vector<double> path     = {3e-3, -3e-3, 2e-3, 1e-3, 4e-3, 0};
    const auto                expected = one_dimension(setup, path);
    const double              L = 4e-3, quarter = 4e-4;
    Dynamics                  scene(box({0, 0, 0}, {L, 2e-3, 2e-3}, {4, 2, 2}), setup);
    const auto               &mesh = scene.solid.mesh;
    for (int component = 0; component < 3; ++component)
      scene.fix(select(mesh, plane(component, 0)), component);
    scene.prescribe(select(mesh, plane(0, L)), 0, [=](const double t) {
      const unsigned int k = std::min<double>(t / quarter, path.size() - 1);
      const double       s = std::min(1., t / quarter - k), from = k > 0 ? path[k - 1] : 0;
      // smooth between the turning points; Green's strain is prescribed
      const double strain = from + (path[k] - from) * s * s * (3 - 2 * s);
      return L * (std::sqrt(1 + 2 * strain) - 1);
    });
    double worst = 0;
    for (std::size_t k = 0; k < path.size(); ++k)
      {
        scene.run_to((k + 1) * quarter);
        scene.step(true);
        const auto &solid = scene.solid;
        double      S     = 0;
        const auto  all   = element_stress(solid.blocks.wheel, solid.displacement.data());
        for (std::size_t e = 0; e < all.size(); ++e)
          {
            // Cauchy stress back to the second Piola-Kirchhoff stress: J / F_xx^2
            const auto   H = element_gradient(solid.blocks.wheel, e, solid.displacement.data());
            const double J = (1 + H[0]) * (1 + H[4]) * (1 + H[8]);
            S += all[e][0] * J / std::pow(1 + H[0], 2) / all.size();
          }
        worst = std::max(worst, std::abs(S - expected[k]));
        std::cout << "        strain " << path[k] << ": " << S * 1e-6 << " MPa, exact " << expected[k] * 1e-6
                  << "\n";
      }
    const std::string name =
      form_name(setup) + ", cyclic bar, kinematic part " + std::to_string(fraction).substr(0, 3);
    BOOST_TEST(
      test::near(worst / 280e6, 0, 2e-3, name + ": largest error of the stress over the yield stress"));
    BOOST_TEST(test::near(scene.energy().error(), 0, 0.01, name + ": energy error"));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(solid_plastic_waves, test::Parallel)
{
  for (Setup setup : each_form(Setup()))
    {
      const double E = setup.material.youngs_modulus;
      // a tenth of a steel's yield stress keeps strains so small that their squares do not matter
      setup.plasticity = {28e6, 0.1 * E, 0};
      impact(setup, false, 1.5, "tangent modulus 10 %");
      setup.plasticity.kinematic_fraction = 1;
      impact(setup, false, 1.5, "kinematic hardening");
      setup.plasticity = {28e6, 1e-3 * E, 0};
      impact(setup, false, 0.9, "tangent modulus 0.1 %");
      setup.plasticity = {28e6, 0, 0};
      impact(setup, false, 1.5, "no hardening");
      // the first step strains the cells at the wall seven times beyond yield
      impact(setup, true, 6, "shock that yields in one step");
      for (const double fraction : {0., 0.5, 1.})
        cyclic(setup, fraction);
    }
}
