// A flat rigid punch on a strip: the limit load of Prandtl is met without locking.

#include "scenes/dynamics.h"

#include "parallel.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

using namespace scenes;
using namespace wheelrail;

namespace
{
  constexpr double half = 0.5; ///< half width of the punch [m]

  /// Mean pressure below a smooth punch over half of a strip 5 x 4 half widths large, over Prandtl's
  /// (2 + pi) Y / sqrt(3): at the end, and at 3/4 of the path.
  struct Curve
  {
    double three_quarters, end;
  };

  Curve
  press(Setup setup, const unsigned int cells, const double depth, const double waves)
  {
    const double      h = half / cells, W = 5 * half, H = 4 * half;
    const Elasticity &m = setup.material;
    // the motion is slow: it takes the time of this many shear waves across the strip
    const double duration = waves * W / std::sqrt(m.shear_modulus() / m.density);
    setup.mass_damping    = 10 / duration * std::sqrt(waves);
    Dynamics    scene(box({0, 0, 0}, {W, H, h}, {5 * cells, 4 * cells, 1}), setup);
    const auto &mesh = scene.solid.mesh;
    const auto  all  = [](const Vector3 &) { return true; };
    scene.fix(select(mesh, all), 2);
    scene.fix(select(mesh, plane(0, 0)), 0);
    scene.fix(select(mesh, plane(0, W)), 0);
    for (const int component : {0, 1})
      scene.fix(select(mesh, plane(1, 0)), component);
    const auto punch =
      scene.prescribe(select(mesh, [&](const Vector3 &X) { return X[1] > H - 1e-9 && X[0] < half + 1e-9; }),
                      1,
                      [=](const double t) {
                        const double s = std::min(1., t / duration);
                        return -depth * (s < 0.1 ? 5 * s * s : s - 0.05) / 0.95;
                      });
    const double limit = (2 + M_PI) * setup.plasticity.yield_stress / std::sqrt(3.);
    Curve        curve{0, 0};
    unsigned int count[2] = {0, 0};
    while (scene.time() < duration)
      {
        scene.step();
        const double s = scene.time() / duration, p = -scene.reaction(punch) / (half * h * limit);
        if (s > 0.7 && s < 0.8)
          curve.three_quarters += p, ++count[0];
        if (s > 0.95)
          curve.end += p, ++count[1];
      }
    curve.three_quarters /= count[0];
    curve.end /= count[1];
    return curve;
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(solid_punch, test::Parallel)
{
  // de Souza Neto, Peric and Owen, Computational Methods for Plasticity, 2008, section 7.5.4, footing of
  // weightless soil; the density does not matter
  Setup base;
  base.material                = {1e10, 0.48, 2000};
  base.plasticity.yield_stress = 848.7e3;
  base.bulk_viscosity          = 0.06;
  base.step_factor             = 0.7;
  for (const Setup &setup : each_form(base))
    {
      const Curve       coarse = press(setup, 4, 2e-3, 40), fine = press(setup, 8, 2e-3, 40);
      const std::string name = form_name(setup) + ", punch on a strip: ";
      std::cout << "        mean pressure over Prandtl's, 4 and 8 cells in half the punch: " << coarse.end
                << ", " << fine.end << "\n";
      // the punch ends between its last node and the next: an error in proportion to the cell size
      BOOST_TEST(test::near(2 * fine.end - coarse.end,
                            1,
                            0.02,
                            name + "limit pressure over Prandtl's, extrapolated to cells of no size"));
      BOOST_TEST(
        test::near(fine.end / fine.three_quarters, 1, 0.01, name + "the pressure does not rise any more"));
    }

  if (test::sanitized)
    return;
  // steel of 280 MPa yield stress pressed far beyond yield: both elements on one mesh
  Setup steel          = base;
  steel.material       = Elasticity();
  steel.plasticity     = {280e6, 21e9, 0};
  const auto   two     = each_form(steel);
  const Curve  reduced = press(two[0], 8, 0.01, 20), full = press(two[1], 8, 0.01, 20);
  const double to_yield = (2 + M_PI) / std::sqrt(3.);
  std::cout << "        steel of 280 MPa, mean pressure over the yield stress: reduced "
            << reduced.end * to_yield << ", full " << full.end * to_yield << "\n";
  BOOST_TEST(test::near(
    reduced.end / full.end, 1, 0.02, "punch on steel: pressure of reduced over that of full cells"));
}
