// label: fast

// Chaboche's law in both elements: without recovery the forces of the bilinear law, widths, and the energy of
// cycles with flow in it.

#include "explicit_brick.h"
#include "near.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

using namespace test;

namespace
{
  CyclicHardening
  hardening(const std::vector<double> &moduli, const std::vector<double> &rates, const double recovery = 1)
  {
    CyclicHardening h;
    h.yield_stress = 300e6;
    h.moduli       = moduli;
    h.rates        = rates;
    h.recovery     = recovery;
    return h;
  }

  /// A brick of elements of a law.
  struct Body : Brick
  {
    Body(const Mesh &mesh, const MaterialLaw &law, const ElementForm form, const int width = native_width)
      : Brick(mesh, Elasticity(), Plasticity())
    {
      blocks = pack_elements(mesh.geometry, mesh.cells, law, width, form);
    }

    void
    go(const double amount, const bool linear)
    {
      AlignedVector<double> target(u.size(), 0.);
      for (std::size_t n = 0; n < mesh.vertices.size(); ++n)
        {
          const Vector &X    = mesh.vertices[n];
          const double  bend = linear ? 0. : 1.;
          target[4 * n]      = amount * (X[0] + bend * 2 * X[1] * X[2]);
          target[4 * n + 1]  = amount * (-0.5 * X[1] + 0.8 * X[2] + bend * X[0] * X[0]);
          target[4 * n + 2]  = amount * (-0.5 * X[2] - bend * X[0] * X[1]);
        }
      external += move_to(target);
    }

    double external = 0;
  };

  double
  apart(const Body &one, const Body &other)
  {
    double most = 0, largest = 0;
    for (std::size_t k = 0; k < one.f.size(); ++k)
      {
        most    = std::max(most, std::abs(one.f[k] - other.f[k]));
        largest = std::max(largest, std::abs(one.f[k]));
      }
    return most / largest;
  }

  /// In the full element any motion, in the reduced one such without hourglass patterns, which have no back
  /// stress.
  void
  bilinear(const ElementForm form)
  {
    const Mesh       mesh = brick({3, 2, 2}, {1, 1, 1}, 0.2);
    const Plasticity plasticity{300e6, 21e9, 1};
    const bool       linear = form == ElementForm::reduced;
    Body             one(
      mesh, ChabocheLaw(Elasticity(), hardening({plasticity.hardening_modulus(Elasticity())}, {0})), form),
      other(mesh, BilinearLaw(Elasticity(), plasticity), form);
    double worst = 0;
    for (const double amount : {3e-3, 6e-3, -4e-3, 1e-3})
      {
        one.go(amount, linear);
        other.go(amount, linear);
        worst = std::max(worst, apart(one, other));
      }
    const std::string text = linear ? " (reduced)" : " (full)";
    BOOST_TEST(near(worst, 0, 1e-10, "forces of the bilinear law" + text));
    BOOST_TEST(
      near(one.energy.plastic_work / other.energy.plastic_work, 1, 1e-10, "and its plastic work" + text));
    BOOST_TEST(
      near(one.energy.hardening / other.energy.hardening, 1, 1e-9, "and what hardening stores" + text));
    BOOST_TEST(one.energy.hardening > 0, "which is not nothing" + text);
  }

  void
  widths_and_energy(const ElementForm form, const double recovery)
  {
    const Mesh        mesh = brick({3, 3, 1}, {1, 1, 1}, 0.2);
    const ChabocheLaw law(Elasticity(), hardening({60e9, 20e9, 5e9}, {600, 100, 0}, recovery));
    Body              body(mesh, law, form), narrow(mesh, law, form, 1);
    double            worst = 0, at = 0;
    for (const double to : {4e-3, -3e-3, 2e-3})
      {
        const double from = at;
        for (int n = 1; n <= 100; ++n)
          {
            at = from + (to - from) * n / 100;
            body.go(at, false);
            narrow.go(at, false);
            worst = std::max(worst, apart(body, narrow));
          }
      }
    const std::string text = std::string(form == ElementForm::full ? " (full" : " (reduced") + ", recovery " +
                             std::to_string(recovery).substr(0, 3) + ")";
    BOOST_TEST(near(worst, 0, 1e-9, "width 1 and the widest" + text));
    const ElementEnergy &e = body.energy;
    BOOST_TEST(near((e.strain + e.stabilisation + e.plastic_work) / body.external,
                    1,
                    3e-3,
                    "stored and plastic energies are the external work" + text));
    BOOST_TEST((e.hardening > 0 && e.hardening < e.plastic_work),
               "hardening stores a part of the plastic work" + text);
  }
} // namespace


BOOST_AUTO_TEST_CASE(chaboche_elements)
{
  for (const ElementForm form : {ElementForm::reduced, ElementForm::full})
    {
      bilinear(form);
      widths_and_energy(form, 1);
      widths_and_energy(form, 0);
    }
}
