// label: fast

// Chaboche's law against closed forms: curves in tension and shear, a published step, ratcheting in each
// cycle, thresholds, reversed flow, saturation, steps of any size, widths, energies.

#include <wheelrail/material/material_point.h>

#include "near.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;

namespace
{
  const Elasticity steel;
  constexpr double E = 210e9, nu = 0.3;

  CyclicHardening
  hardening(const double               yield,
            const double               Q,
            const double               b,
            const std::vector<double> &C,
            const std::vector<double> &gamma)
  {
    CyclicHardening h;
    h.yield_stress   = yield;
    h.isotropic      = Q;
    h.isotropic_rate = b;
    h.moduli         = C;
    h.rates          = gamma;
    return h;
  }

  MaterialPoint
  point(const CyclicHardening &h)
  {
    return MaterialPoint(ChabocheLaw(steel, h));
  }

  /// Drives along x with free sides, by strain or stress.
  void
  pull(MaterialPoint &p, const double from, const double to, const int steps, const bool of_stress)
  {
    PointTarget target;
    target.of_stress = {of_stress, true, true, true, true, true};
    for (int n = 1; n <= steps; ++n)
      {
        target.value[0] = from + (to - from) * n / steps;
        p.go_to(target);
      }
  }

  void
  curves()
  {
    const double Y = 300e6, Q = 100e6, b = 20, C = 40e9, gamma = 200, C2 = 5e9;
    double       error[2] = {0, 0};
    for (const int k : {0, 1})
      {
        MaterialPoint p = point(hardening(Y, Q, b, {C, C2}, {gamma, 0}));
        pull(p, 0, 0.02, 400 << k, false);
        const double ep = 0.02 - p.stress()[0] / E;
        const double exact =
          Y + Q * (1 - std::exp(-b * ep)) + C / gamma * (1 - std::exp(-gamma * ep)) + C2 * ep;
        BOOST_TEST(near(p.plastic_strain()[0], ep, 1e-9, "plastic strain in tension"));
        BOOST_TEST(near(p.accumulated(), ep, 1e-9, "and accumulated"));
        BOOST_TEST(near(p.stress()[0] / exact, 1, 2e-3, "stress of the tension test over the closed form"));
        error[k] = std::abs(p.stress()[0] / exact - 1);
      }
    BOOST_TEST(near(error[1] / error[0], 0.5, 0.02, "the error falls with the step"));
    MaterialPoint perfect = point(hardening(Y, 0, 0, {}, {}));
    pull(perfect, 0, 0.01, 200, false);
    BOOST_TEST(near(perfect.stress()[0] / Y, 1, 1e-9, "stress without hardening over the yield stress"));

    MaterialPoint p = point(hardening(Y, Q, b, {C, C2}, {gamma, 0}));
    PointTarget   target;
    target.of_stress = {true, true, true, true, true, false};
    for (int n = 1; n <= 2000; ++n)
      {
        target.value[5] = 0.015 * n / 2000;
        p.go_to(target);
      }
    const double slip = 2 * (0.015 - p.stress()[5] * (1 + nu) / E), ep = slip / std::sqrt(3.);
    const double exact =
      (Y + Q * (1 - std::exp(-b * ep)) + C / gamma * (1 - std::exp(-gamma * ep)) + C2 * ep) / std::sqrt(3.);
    BOOST_TEST(near(p.accumulated() / ep, 1, 1e-9, "accumulated strain in shear"));
    BOOST_TEST(near(p.stress()[5] / exact, 1, 1e-3, "stress in shear over the closed form"));
  }

  /// matmodfit (github.com/KnutAM/matmodfit), examples/example04: R' = 10000 (1 - R / 400), C 5000, gamma 10,
  /// shear stresses printed after strains in proportion, which ten implicit steps give to all digits.
  void
  published()
  {
    MaterialPoint p = point(hardening(400e6, 400e6, 25, {5e9}, {10}));
    PointTarget   target;
    for (int n = 1; n <= 10; ++n)
      {
        const double s = n / 10.;
        target.value   = {0.005 * s, -0.002 * s, -0.00125 * s, 0.0025 * s, 0.001 * s, 0};
        p.go_to(target);
      }
    BOOST_TEST(near(1e-6 * p.stress()[4], 55.5186, 5e-5, "published stress 13 [MPa]"));
    BOOST_TEST(near(1e-6 * p.stress()[3], 138.796, 5e-4, "published stress 23 [MPa]"));
  }

  void
  ratcheting()
  {
    CyclicHardening h     = hardening(379e6, 0, 0, {24.75e9}, {55});
    const double    bound = 24.75e9 / 55, k = 379e6, top = 700e6, low = -500e6;
    const double    exact =
      std::log((bound * bound - std::pow(low + k, 2)) / (bound * bound - std::pow(top - k, 2))) / 55;
    MaterialPoint p = point(h);
    pull(p, 0, top, 2000, true);
    double last = 0;
    for (int cycle = 0; cycle < 3; ++cycle)
      {
        const double before = p.strain()[0];
        pull(p, top, low, 8000, true);
        pull(p, low, top, 8000, true);
        last = p.strain()[0] - before;
      }
    BOOST_TEST(near(exact, 0.0115627, 5e-8, "closed form of the ratcheting of Armstrong and Frederick"));
    BOOST_TEST(near(last / exact, 1, 1e-3, "ratcheting of a cycle over it"));

    h.recovery      = 0;
    MaterialPoint q = point(h);
    pull(q, 0, top, 10, true);
    const double before = q.strain()[0];
    pull(q, top, low, 10, true);
    pull(q, low, top, 10, true);
    BOOST_TEST(near(q.strain()[0] - before, 0, 1e-9, "Ohno and Wang do not ratchet below the threshold"));
    pull(q, top, 828e6, 500, true);
    BOOST_TEST(q.strain()[0] - before > 5e-3,
               "flow goes on at the threshold's stress, " + std::to_string(1e-6 * (k + bound)));

    h.recovery      = 0.1;
    MaterialPoint r = point(h);
    pull(r, 0, top, 2000, true);
    double first = r.strain()[0];
    pull(r, top, low, 2000, true);
    pull(r, low, top, 2000, true);
    const double slow = r.strain()[0] - first;
    BOOST_TEST((slow > 0.02 * exact && slow < 0.3 * exact),
               "a tenth of the recovery below it ratchets little");
  }

  void
  cycles()
  {
    const double  Y = 379e6, Q = 189e6, b = 500, C = 24.75e9, gamma = 55;
    MaterialPoint p = point(hardening(Y, Q, b, {C}, {gamma}));
    const double  a = 0.01;
    pull(p, 0, a, 200, false);
    const double top = p.stress()[0];
    const double R   = Q * (1 - std::exp(-b * p.accumulated()));
    pull(p, a, a - 1.99 * (Y + R) / E, 5, false);
    BOOST_TEST(near(
      (top - p.stress()[0]) / (1.99 * (Y + R)), 1, 1e-6, "unloading over twice the yield stress is elastic"));
    pull(p, a - 1.99 * (Y + R) / E, -a, 200, false);
    for (int cycle = 0; cycle < 20; ++cycle)
      {
        pull(p, -a, a, 1000, false);
        pull(p, a, -a, 1000, false);
      }
    const double s = -p.stress()[0], range = 2 * (a - s / E);
    BOOST_TEST(near(
      s / (Y + Q + C / gamma * std::tanh(gamma * range / 2)), 1, 1e-3, "saturated stress of strain cycles"));
  }

  /// One step and a thousand to the same strain, with all kinds of recovery; steps far beyond any use.
  void
  steps()
  {
    for (const double recovery : {1., 0.3, 0.})
      {
        CyclicHardening h = hardening(300e6, 80e6, 50, {150e9, 30e9, 4e9}, {2000, 300, 20});
        h.recovery        = recovery;
        std::vector<double> stress;
        for (const int n : {1, 10, 100, 1000})
          {
            MaterialPoint p = point(h);
            pull(p, 0, 0.01, n, false);
            stress.push_back(p.stress()[0]);
          }
        const std::string text = " (recovery " + std::to_string(recovery).substr(0, 3) + ")";
        BOOST_TEST(near(stress[0] / stress[3], 1, 0.1, "one step and a thousand" + text));
        BOOST_TEST(near(stress[2] / stress[3], 1, 0.003, "a hundred steps and a thousand" + text));
        MaterialPoint far = point(h);
        for (const double strain : {1., -1., 30., 0., 1e-6})
          {
            PointTarget target;
            target.value = {strain, -strain / 2, -strain / 2, strain, 0, strain / 3};
            far.go_to(target);
            BOOST_TEST(std::isfinite(far.stress()[0]),
                       "a step to the strain " + std::to_string(strain) + text);
          }
      }
  }

  template <int W>
  using Lanes = ChabocheLaw::History<Simd<W>>;

  /// Random steps of all sizes: widths agree, the stress lies on the yield surface where it flows, back
  /// stresses stay within their bounds, and less is stored than done.
  template <int W>
  void
  random_steps(const double recovery)
  {
    CyclicHardening h = hardening(300e6, 80e6, 50, {150e9, 30e9, 4e9}, {2000, 300, 0});
    h.recovery        = recovery;
    const ChabocheLaw                      law(steel, h);
    std::mt19937                           random(11);
    std::uniform_real_distribution<double> value(-1, 1);
    Lanes<W>                               many(law);
    std::vector<Lanes<1>>                  one(W, Lanes<1>(law));
    double                                 apart = 0, off = 0, beyond = 0, heat = 0;
    double                                 done[W] = {}, lost[W] = {};
    for (int step = 0; step < 300; ++step)
      {
        Simd<W>      e[6], S[6], work = 0.;
        const double size = 3e-3 * std::pow(10., 1.5 * value(random));
        for (auto &component : e)
          for (int l = 0; l < W; ++l)
            component[l] = size * value(random) * (l % 3); // lane 0 never yields
        point_response(law, e, many, S, work);
        for (int l = 0; l < W; ++l)
          {
            Simd<1> e1[6], s1[6], w = 0., trial[6];
            for (int k = 0; k < 6; ++k)
              e1[k] = e[k][l];
            const double strained = one[l].accumulated[0];
            point_response(law, e1, one[l], s1, w);
            for (int k = 0; k < 6; ++k)
              apart = std::max(apart, std::abs(s1[k][0] - double(S[k][l])) / 300e6);
            const double q = std::sqrt(law.trial(e1, one[l], trial)[0]), limit = law.limit(one[l])[0];
            off = std::max(off, one[l].accumulated[0] > strained ? std::abs(q / limit - 1) : q / limit - 1);
            for (int i = 0; i < 2; ++i)
              beyond = std::max(beyond,
                                std::sqrt(1.5 * contract_deviators(one[l].back[i], one[l].back[i])[0]) /
                                  law.threshold[i]);
            done[l] += w[0];
            const double now = done[l] - law.hardening_energy(one[l])[0];
            heat             = std::max(heat, lost[l] - now);
            lost[l]          = now;
          }
      }
    const std::string text =
      " (width " + std::to_string(W) + ", recovery " + std::to_string(recovery).substr(0, 3) + ")";
    BOOST_TEST(near(apart, 0, recovery < 1 ? 1e-10 : 1e-12, "lanes do not know of each other" + text));
    BOOST_TEST(near(off, 0, 1e-9, "stresses lie on the yield surface" + text));
    BOOST_TEST((beyond <= 1 + 1e-9 && (W == 1 || beyond > 0.5)),
               "back stresses stay within their bounds, at most " + std::to_string(beyond) + text);
    BOOST_TEST(near(many.accumulated[0], 0, 0, "the lane at rest keeps no history" + text));
    BOOST_TEST((W == 1 || heat <= 0), "no step gives heat back" + text);
  }

  /// One modulus without recovery is the bilinear law with kinematic hardening.
  void
  bilinear()
  {
    const Plasticity      plasticity{300e6, 21e9, 1};
    const CyclicHardening h   = hardening(300e6, 0, 0, {plasticity.hardening_modulus(steel)}, {0});
    MaterialPoint         one = point(h), other{BilinearLaw(steel, plasticity)};
    std::mt19937          random(5);
    std::uniform_real_distribution<double> value(-6e-3, 6e-3);
    double                                 worst = 0;
    for (int n = 0; n < 100; ++n)
      {
        PointTarget target;
        for (double &component : target.value)
          component = value(random);
        one.go_to(target);
        other.go_to(target);
        for (std::size_t k = 0; k < 6; ++k)
          worst = std::max(worst, std::abs(one.stress()[k] - other.stress()[k]) / 300e6);
      }
    BOOST_TEST(near(worst, 0, 1e-10, "stresses of the bilinear law"));
    BOOST_TEST(near(one.plastic_work() / other.plastic_work(), 1, 1e-10, "and its plastic work"));
    BOOST_TEST(near(one.hardening_energy() / other.hardening_energy(), 1, 1e-9, "and what hardening stores"));
  }

  void
  energies()
  {
    MaterialPoint p        = point(hardening(379e6, 100e6, 50, {24.75e9, 60e9}, {55, 600}));
    double        external = 0, at = 0;
    for (const double to : {0.01, -0.008, 0.004})
      {
        const double from = at;
        for (int n = 1; n <= 500; ++n)
          {
            const double before = p.stress()[0], there = p.strain()[0];
            pull(p, from + (to - from) * (n - 1) / 500, from + (to - from) * n / 500, 1, false);
            external += 0.5 * (before + p.stress()[0]) * (p.strain()[0] - there);
          }
        at = to;
      }
    const double elastic = p.stress()[0] * p.stress()[0] / (2 * E);
    BOOST_TEST(near((elastic + p.plastic_work()) / external,
                    1,
                    1e-4,
                    "elastic energy and plastic work are the external work"));
    BOOST_TEST(
      (p.hardening_energy() > 0.01 * p.plastic_work() && p.hardening_energy() < 0.2 * p.plastic_work()),
      "hardening stores a few per cent of it");
  }
} // namespace


BOOST_AUTO_TEST_CASE(chaboche)
{
  curves();
  published();
  ratcheting();
  cycles();
  steps();
  random_steps<1>(1);
  for (const double recovery : {1., 0.3, 0.})
    {
      random_steps<4>(recovery);
      random_steps<8>(recovery);
    }
  bilinear();
  energies();
}
