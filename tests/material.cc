// label: fast

// The material laws against closed forms: Hooke; uniaxial curves, cycles, energy and widths of the bilinear
// law.

#include <wheelrail/material/bilinear.h>

#include "near.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

using namespace wheelrail;
namespace stdx = std::experimental;

namespace
{
  template <int W>
  using History = BilinearLaw::History<Simd<W>>;

  /// One point pulled along x with free lateral strain.
  struct Bar
  {
    BilinearLaw law;
    double      poissons_ratio;
    History<1>  history{};
    double      stress = 0, work = 0, elastic = 0;

    /// Goes to an axial strain; the lateral strain follows from zero lateral stress, found by secants.
    void
    go_to(const double strain)
    {
      const double shear = law.shear, bulk = law.lambda + 2 * shear / 3;
      double       lateral = -poissons_ratio * strain;
      for (int iteration = 0; iteration < 200; ++iteration)
        {
          History<1>    trial = history;
          Simd<1>       S[6], w = 0.;
          const Simd<1> E[6] = {strain, lateral, lateral, 0., 0., 0.};
          point_response(law, E, trial, S, w);
          if (std::abs(S[1][0]) < 1e-4)
            {
              history = trial;
              stress  = S[0][0];
              work += w[0];
              elastic = law.stored_energy(E, trial, S)[0];
              return;
            }
          // the elastic slope is never too flat, so this goes down monotonically
          lateral -= S[1][0] / (2 * bulk + 2 * shear / 3);
        }
      BOOST_TEST(false, "lateral stress vanishes");
    }

    /// Goes to a strain in small steps. Returns the external work by the trapezoidal rule [J/m3].
    double
    walk_to(const double from, const double to, const int steps)
    {
      double external = 0;
      for (int n = 1; n <= steps; ++n)
        {
          const double before = stress;
          go_to(from + (to - from) * n / steps);
          external += 0.5 * (before + stress) * (to - from) / steps;
        }
      return external;
    }
  };

  /// Uniaxial strain and shear of the elastic law.
  void
  hooke()
  {
    const Elasticity             steel;
    const ElasticLaw             law(steel);
    ElasticLaw::History<Simd<1>> nothing(law);
    const Simd<1>                strain[6] = {0.01, 0., 0., 0., 0., 0.02};
    Simd<1>                      S[6], work = 0.;
    const double                 nu = steel.poissons_ratio, G = steel.youngs_modulus / (2 + 2 * nu);
    const double                 confined = 2 * G * (1 - nu) / (1 - 2 * nu);
    BOOST_TEST((!point_response(law, strain, nothing, S, work) && work[0] == 0),
               "an elastic law never flows");
    BOOST_TEST(test::near(S[0][0], confined * 0.01, 1, "elastic stress along a confined strain"));
    BOOST_TEST(test::near(S[1][0], confined * 0.01 * nu / (1 - nu), 1, "elastic stress across it"));
    BOOST_TEST(test::near(S[5][0], 2 * G * 0.02, 1, "elastic shear stress"));
    BOOST_TEST(test::near(law.stored_energy(strain, nothing, S)[0],
                          0.5 * confined * 1e-4 + 2 * G * 4e-4,
                          1e-3,
                          "elastic energy density"));
  }

  Bar
  bar(const double tangent, const double kinematic)
  {
    const Elasticity steel;
    return {BilinearLaw(steel, {480e6, tangent, kinematic}), steel.poissons_ratio};
  }

  constexpr double E = 210e9, Et = 21e9, yield = 480e6;

  void
  uniaxial(const double kinematic)
  {
    const std::string name = " (kinematic fraction " + std::to_string(kinematic).substr(0, 3) + ")";
    Bar               b    = bar(Et, kinematic);
    const double      ey = yield / E, e1 = 6e-3;
    b.go_to(0.999 * ey);
    BOOST_TEST(test::near(b.stress, 0.999 * yield, 1, "elastic up to yield" + name));
    BOOST_TEST(test::near(b.history.accumulated[0], 0, 0, "no plastic strain before yield" + name));
    b.go_to(e1);
    const double s1 = yield + Et * (e1 - ey);
    BOOST_TEST(test::near(b.stress, s1, 1e3, "loading follows the tangent modulus" + name));
    BOOST_TEST(test::near(b.history.strain[0][0], e1 - s1 / E, 1e-10, "plastic strain" + name));
    b.go_to(e1 - 0.5 * ey);
    BOOST_TEST(test::near(b.stress, s1 - 0.5 * yield, 1e3, "unloading is elastic" + name));
    b.go_to(e1);
    BOOST_TEST(test::near(b.stress, s1, 1e3, "reloading returns to the same point" + name));
    // reversal: the elastic range is 2 (yield + (1 - f) H alpha)
    const double H     = E * Et / (E - Et);
    const double alpha = e1 - s1 / E;
    const double range = 2 * (yield + (1 - kinematic) * H * alpha);
    const double e2    = e1 - range / E - 4e-3;
    b.go_to(e2);
    const double s2 = s1 - range - Et * 4e-3;
    BOOST_TEST(test::near(b.stress, s2, 1e3, "reversed yield" + name));
    const double plastic = 4e-3 * (1 - Et / E);
    BOOST_TEST(test::near(b.history.accumulated[0], alpha + plastic, 1e-10, "accumulated strain" + name));
    // and back: the range has grown by the isotropic part
    const double range2 = 2 * (yield + (1 - kinematic) * H * (alpha + plastic));
    b.go_to(e2 + range2 / E + 2e-3);
    BOOST_TEST(test::near(b.stress, s2 + range2 + Et * 2e-3, 1e3, "second reversal" + name));
  }

  void
  energy(const double tangent, const double kinematic)
  {
    Bar    b        = bar(tangent, kinematic);
    double external = b.walk_to(0, 8e-3, 400);
    external += b.walk_to(8e-3, -8e-3, 800);
    external += b.walk_to(-8e-3, 2e-3, 500);
    BOOST_TEST(test::near((b.elastic + b.work) / external,
                          1,
                          1e-4,
                          "elastic energy and plastic work are the external work, E_t = " +
                            std::to_string(tangent / 1e9) + " GPa, kinematic " + std::to_string(kinematic)));
    BOOST_TEST(b.work > 0, "plastic work is positive");
  }

  void
  perfect_plasticity()
  {
    Bar b = bar(0, 0.5);
    b.go_to(0.05);
    BOOST_TEST(test::near(b.stress, yield, 1e3, "perfect plasticity keeps the yield stress"));
    b.go_to(-0.05);
    BOOST_TEST(test::near(b.stress, -yield, 1e3, "and in compression"));
    // pure shear: yields at yield / sqrt(3), whatever the step
    const Elasticity  steel;
    const BilinearLaw law(steel, {yield, 0, 0});
    History<1>        history;
    Simd<1>           S[6], work = 0.;
    const Simd<1>     strain[6] = {0., 0., 0., 0., 0., 0.01};
    point_response(law, strain, history, S, work);
    BOOST_TEST(test::near(S[5][0], yield / std::sqrt(3.), 1, "shear yield stress"));
    BOOST_TEST(test::near(
      work[0], S[5][0] * 2 * (0.01 - S[5][0] / (2 * law.shear)), 1e-6, "plastic work of one large step"));
  }

  /// Shear slope in flow and volumetric elasticity.
  void
  tangent()
  {
    const Elasticity  steel;
    const BilinearLaw law(steel, {yield, Et, 0.3});
    History<1>        history;
    Simd<1>           S0[6], S1[6], work = 0.;
    Simd<1>           strain[6] = {0.001, 0.001, 0.001, 0., 0., 0.005};
    point_response(law, strain, history, S0, work);
    strain[5] = 0.006;
    point_response(law, strain, history, S1, work);
    BOOST_TEST(test::near(
      (S1[5][0] - S0[5][0]) / (2 * law.shear * 0.001), law.tangent_ratio, 1e-9, "shear slope in flow"));
    BOOST_TEST(test::near(S1[0][0], 3 * steel.bulk_modulus() * 0.001, 10, "volume changes stay elastic"));
  }

  template <int W>
  void
  width()
  {
    const Elasticity                       steel;
    const BilinearLaw                      law(steel, {yield, Et, 0.4});
    std::mt19937                           random(3);
    std::uniform_real_distribution<double> value(-0.004, 0.004);
    History<W>                             many;
    History<1>                             one[W];
    double                                 worst = 0;
    bool                                   any   = false;
    for (int step = 0; step < 20; ++step)
      {
        Simd<W> E[6], S[6], work = 0.;
        for (auto &e : E)
          for (int l = 0; l < W; ++l)
            e[l] = value(random) * (l % 3); // lane 0 never yields
        any = point_response(law, E, many, S, work) || any;
        for (int l = 0; l < W; ++l)
          {
            Simd<1> e[6], s[6], w = 0.;
            for (int k = 0; k < 6; ++k)
              e[k] = E[k][l];
            point_response(law, e, one[l], s, w);
            for (int k = 0; k < 6; ++k)
              worst = std::max(std::abs(s[k][0] - S[k][l]), worst); // lets a NaN through
            worst = std::max(std::abs(w[0] - double(work[l])), worst);
          }
      }
    BOOST_TEST(test::near(worst / yield, 0, 1e-13, "width " + std::to_string(W) + " equals width 1"));
    BOOST_TEST((any == (W > 1)), "yield is reported");
    BOOST_TEST(test::near(many.accumulated[0], 0, 0, "the lane at rest keeps no history"));
  }
} // namespace


BOOST_AUTO_TEST_CASE(material)
{
  hooke();
  for (const double kinematic : {0., 0.5, 1.})
    {
      uniaxial(kinematic);
      energy(Et, kinematic);
      energy(0, kinematic);
      energy(0.21e9, kinematic);
    }
  perfect_plasticity();
  tangent();
  width<1>();
  width<2>();
  width<4>();
  width<8>();
}
