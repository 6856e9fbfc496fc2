// Coarse meshes in bending and twisting: tip deflection of a cantilever, torsion of a square bar, flat cells
// and nearly incompressible ones, all static by damped motion.

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
  struct Beam
  {
    double       length, height, width;
    unsigned int along, through, across;
  };

  /// Lowest angular frequency of a cantilever in bending (Timoshenko, Vibration Problems, 1937) [1/s].
  double
  first_frequency(const Beam &beam, const Elasticity &m)
  {
    return 3.516 * beam.height / (std::sqrt(12.) * beam.length * beam.length) *
           std::sqrt(m.youngs_modulus / m.density);
  }

  /// Deflection of the end under a shear force on the end's face, over that of Timoshenko's beam with
  /// fixed end (shear coefficient of Cowper 1966). Clamped: all components of the nodes there.
  struct Result
  {
    double deflection, stabilisation;
  };

  Result
  tip_deflection(Setup setup, const Beam &beam)
  {
    const Elasticity &m = setup.material;
    setup.mass_damping  = 2 * first_frequency(beam, m);
    Dynamics scene(
      box({0, 0, 0}, {beam.length, beam.height, beam.width}, {beam.along, beam.through, beam.across}), setup);
    const auto &mesh = scene.solid.mesh;
    // the end is held as the beam theory has it: no axial motion, free to contract
    const Nodes held = select(mesh, plane(0, 0));
    scene.fix(held, 0);
    scene.fix(
      select(mesh, [&](const Vector3 &X) { return X[0] < 1e-9 && std::abs(X[1] - beam.height / 2) < 1e-9; }),
      1);
    scene.fix(
      select(mesh, [&](const Vector3 &X) { return X[0] < 1e-9 && std::abs(X[2] - beam.width / 2) < 1e-9; }),
      2);
    const Nodes  tip   = select(mesh, plane(0, beam.length));
    const double I     = beam.width * std::pow(beam.height, 3) / 12;
    const double force = 1e-5 * m.youngs_modulus * I / (beam.length * beam.length);
    // shares of the nodes: uniform over the face
    double sum = 0;
    for (const unsigned int n : tip)
      sum += scene.solid.mass[n];
    scene.add_force([&, tip, sum](double, const Solid &solid, double *f) {
      for (const unsigned int n : tip)
        f[4 * n + 1] += force * solid.mass[n] / sum;
    });
    scene.run_to(3.5 * 2 * M_PI / first_frequency(beam, m));
    scene.step(true);
    double deflection = 0;
    for (const unsigned int n : tip)
      deflection += scene.solid.displacement[4 * n + 1] * scene.solid.mass[n] / sum;
    const double kappa = 10 * (1 + m.poissons_ratio) / (12 + 11 * m.poissons_ratio);
    const double exact = force * std::pow(beam.length, 3) / (3 * m.youngs_modulus * I) +
                         force * beam.length / (kappa * m.shear_modulus() * beam.height * beam.width);
    BOOST_TEST(scene.kinetic_energy() < 1e-6 * scene.energy()["strain_energy"], "the beam has come to rest");
    return {deflection / exact,
            scene.energy()["stabilisation_energy"] /
              (scene.energy()["strain_energy"] + scene.energy()["stabilisation_energy"])};
  }

  void
  bending(const Setup &base)
  {
    for (const double nu : {0.3, 0.49})
      for (const unsigned int through : {2, 4})
        {
          if (base.form == ElementForm::full && nu > 0.4 && through == 4)
            continue; // slow

          Setup setup                   = base;
          setup.material.poissons_ratio = nu;
          const Beam   beam{0.1, 0.01, 0.01, 10 * through, through, through};
          const Result result = tip_deflection(setup, beam);
          std::cout << "        part of the stabilisation in the energy " << result.stabilisation << "\n";
          BOOST_TEST(test::near(result.deflection,
                                1,
                                0.03,
                                form_name(setup) + ", nu " + std::to_string(nu).substr(0, 4) + ", " +
                                  std::to_string(through) +
                                  " cells through the beam: tip deflection over Timoshenko's"));
        }
    // cells twenty times as long as high: parasitic shear makes the full element G/E (length of a cell /
    // height of the beam)^2 stiffer
    const Beam   flat{0.1, 0.005, 0.01, 4, 4, 2};
    const double parasitic = base.form == ElementForm::reduced ? 0 : std::pow(0.025 / 0.005, 2) / 2.6;
    BOOST_TEST(test::near(tip_deflection(base, flat).deflection * (1 + parasitic),
                          1,
                          0.03,
                          form_name(base) + ", cells of aspect ratio 20: tip deflection over " +
                            (parasitic > 0 ? "that of a locking beam" : "Timoshenko's")));
  }

  /// Torque of a square bar whose ends turn in their planes and are free to warp, over Saint-Venant's
  /// 0.140577 G a^4 (Timoshenko and Goodier, Theory of Elasticity, 3rd edition 1970, section 109).
  double
  torque(Setup setup, const unsigned int through)
  {
    const double a = 0.01, length = 0.03, twist = 1e-4; // angle of the whole bar
    setup.mass_damping = 4e5;
    Dynamics scene(box({0, -a / 2, -a / 2}, {length, a / 2, a / 2}, {3 * through, through, through}), setup);
    const auto &mesh = scene.solid.mesh;
    struct Turned
    {
      Vector3      X;
      unsigned int y, z;
    };
    std::vector<Turned> turned;
    const double        ramp = 2e-5;
    for (const double x : {0., length})
      for (const unsigned int n : select(mesh, plane(0, x)))
        {
          const Vector3 X     = place_of(mesh, n);
          const auto    angle = [=](const double t) { return (x > 0 ? twist : 0) * std::min(1., t / ramp); };
          Turned        node{X, 0, 0};
          node.y = scene.prescribe({n}, 1, [=](const double t) { return -angle(t) * X[2]; });
          node.z = scene.prescribe({n}, 2, [=](const double t) { return angle(t) * X[1]; });
          if (x > 0)
            turned.push_back(node);
        }
    scene.fix(select(mesh, [](const Vector3 &X) { return norm(X) < 1e-9; }), 0);
    scene.run_to(1.5e-4);
    scene.step(true);
    double torque = 0;
    for (const auto &node : turned)
      torque += node.X[1] * scene.reaction(node.z) - node.X[2] * scene.reaction(node.y);
    BOOST_TEST(scene.kinetic_energy() < 1e-6 * scene.energy()["strain_energy"], "the bar has come to rest");
    return torque / (0.140577 * setup.material.shear_modulus() * std::pow(a, 4) * twist / length);
  }

  void
  torsion(const Setup &setup)
  {
    const double two = torque(setup, 2), four = torque(setup, 4), eight = torque(setup, 8);
    std::cout << "        torque over Saint-Venant's with 2, 4, 8 cells through the bar: " << two << " "
              << four << " " << eight << "\n";
    BOOST_TEST(test::near(eight, 1, 0.02, form_name(setup) + ": torque with 8 cells through the bar"));
    BOOST_TEST(
      test::near(std::log2((four - 1) / (eight - 1)), 2, 0.3, form_name(setup) + ": order of the torque"));
  }
} // namespace


BOOST_FIXTURE_TEST_CASE(solid_bending, test::Parallel)
{
  Setup base;
  base.step_factor = 0.6; // thin bodies of nearly incompressible cells: beyond what the estimate covers
  for (const Setup &setup : each_form(base))
    {
      bending(setup);
      torsion(setup);
    }
}
