// Thick cylinder and thick sphere under internal pressure, loaded beyond yield and unloaded, without
// hardening: plastic front, displacement, stresses under load and residual stresses.

#include "scenes/shapes.h"
#include "scenes/vessel.h"

#include "parallel.h"

#include <cmath>
#include <iostream>
#include <string>

using namespace scenes;
using namespace wheelrail;

namespace
{
  void
  vessel(const Setup &setup, const int n, const unsigned int radial, const double c)
  {
    const double      Y = setup.plasticity.yield_stress;
    const Vessel      exact{n, n == 2 ? 2 * Y / std::sqrt(3.) : Y};
    const LocalMesh   mesh = n == 2
                               ? quarter_cylinder(inner_radius, outer_radius, 5e-3, {radial, radial, 1}, 1.5)
                               : sphere_octant(inner_radius, outer_radius, radial, radial / 2, 1.5);
    const VesselState m    = load_vessel(setup, exact, mesh, c);
    const double      p    = exact.pressure(c);
    const std::string name = form_name(setup) + (n == 2 ? ", cylinder, " : ", sphere, ") + "front at " +
                             std::to_string(int(1e3 * c)) + " mm: ";
    std::cout << "        " << mesh.cells.size() << " cells, pressure " << p * 1e-6 << " MPa, front "
              << 1e3 * m.front << " mm, outer displacement " << 1e6 * m.displacement << " um\n";
    BOOST_TEST(test::near(
      exact.pressure(m.front) / p, 1, 0.01, name + "exact pressure of the front found over that applied"));
    BOOST_TEST(test::near(m.displacement / exact.outer_displacement(c, setup.material),
                          1,
                          0.01,
                          name + "displacement of the outer surface over the exact one"));
    BOOST_TEST(
      test::near(m.radial / Y, 0, 0.02, name + "radial stress, largest error over the yield stress"));
    BOOST_TEST(test::near(m.hoop / Y, 0, 0.02, name + "hoop stress, largest error over the yield stress"));
    BOOST_TEST(
      test::near(m.residual / Y, 0, 0.02, name + "residual stresses, largest error over the yield stress"));
    BOOST_TEST(test::near(m.energy.error(), 0, 0.01, name + "energy error"));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(solid_vessels, test::Parallel)
{
  Setup base;
  base.plasticity.yield_stress = 240e6;
  for (const Setup &setup : each_form(base))
    {
      vessel(setup, 2, 16, 0.14);
      if (test::sanitized)
        continue;
      vessel(setup, 2, 16, 0.16);
      vessel(setup, 3, 16, 0.14);
    }
}
