// Impact on a rigid plane: an elastic rod and a ball.

#include "scenes/dynamics.h"

#include "check.h"

using namespace scenes;
using namespace wheelrail;

namespace
{
  /// Of a rod on a wall over the exact values: mean stress of the plateau, duration of the contact, and
  /// speed of the centre after it.
  struct Rebound
  {
    double plateau, duration, speed, residual;
  };

  /// Saint-Venant's rod: stress rho c v for the time 2 L / c, then it leaves with its speed (Timoshenko and
  /// Goodier, Theory of Elasticity, 3rd edition 1970, chapter 14).
  Rebound
  rod(const Setup &setup, const unsigned int cells)
  {
    const double length = 0.1, h = length / cells, velocity = 1;
    Dynamics     scene(box({0, 0, 0}, {length, h, h}, {cells, 1, 1}), setup);
    const auto  &mesh = scene.solid.mesh;
    const auto   wall = scene.wall(select(mesh, plane(0, 0)), 0, 1, [](double) { return 0.; });
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      scene.solid.velocity[4 * n] = -velocity;
    const double c     = std::sqrt(setup.material.youngs_modulus / setup.material.density);
    const double exact = setup.material.density * c * velocity, period = 2 * length / c;
    Rebound      result{0, 0, 0, 0};
    unsigned int count = 0;
    while (scene.time() < 1.3 * period)
      {
        scene.step(scene.steps() % 50 == 0);
        const double pressure = scene.reaction(wall) / (h * h);
        if (pressure > 0.5 * exact)
          result.duration = scene.time() / period;
        if (scene.time() > 0.1 * period && scene.time() < 0.9 * period)
          result.plateau += pressure / exact, ++count;
      }
    double mass = 0;
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      result.speed += scene.solid.mass[n] * scene.solid.velocity[4 * n] / velocity,
        mass += scene.solid.mass[n];
    result.speed /= mass;
    result.plateau /= count;
    result.residual = scene.energy().residual() / scene.energy().start;
    return result;
  }

  void
  rods(Setup setup)
  {
    setup.material.poissons_ratio = 0;
    setup.bulk_viscosity          = 0.06;
    setup.step_factor             = 0.7; // every node lies on a free edge
    const Rebound     coarse = rod(setup, 200), fine = rod(setup, 400);
    const std::string name = form_name(setup) + ", rod on a wall: ";
    std::cout << "        speed after it with 200 and 400 cells: " << coarse.speed << ", " << fine.speed
              << "\n";
    test::check_near(fine.plateau, 1, 5e-3, name + "mean plateau over rho c v");
    test::check_near(fine.duration, 1, 1e-2, name + "duration of the contact over 2 L / c");
    test::check_near(fine.speed, 1, 2e-2, name + "speed after it over that before");
    // the bulk viscosity spreads the front like heat, over a width that grows with sqrt(h L)
    const double root = std::sqrt(2.);
    test::check_near((root * fine.speed - coarse.speed) / (root - 1),
                     1,
                     5e-3,
                     name + "the same, extrapolated with the root of the cell size");
    test::check_near(fine.residual, 0, 1e-2, name + "energy balance");
  }

  /// Hertz's impact of a ball on a rigid plane (Johnson, Contact Mechanics, 1985, section 11.4).
  void
  ball(const Setup &setup)
  {
    const double      radius = 0.01, velocity = 4;
    const Elasticity &m       = setup.material;
    const double      modulus = m.youngs_modulus / (1 - m.poissons_ratio * m.poissons_ratio);
    const double      weight  = 4 * M_PI / 3 * std::pow(radius, 3) * m.density;
    const double      approach =
      std::pow(15 * weight * velocity * velocity / (16 * modulus * std::sqrt(radius)), 0.4);
    const double force    = 4. / 3 * modulus * std::sqrt(radius) * std::pow(approach, 1.5);
    const double duration = 2.9432 * approach / velocity;

    const BallCells cells{0.12e-3, 0.9e-3, 1.3, 1.2e-3, 4, false};
    Dynamics        scene(quarter_ball(radius, cells), setup);
    const auto     &mesh = scene.solid.mesh;
    const auto      wall = scene.wall(select(mesh,
                                        [&](const Vector3 &X) {
                                          return norm(X - Vector3{0, 0, radius}) > 0.9999 * radius;
                                        }),
                                 2,
                                 1,
                                 [](double) { return 0.; });
    for (const int component : {0, 1})
      scene.fix(select(mesh, plane(component, 0)), component);
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      scene.solid.velocity[4 * n + 2] = -velocity;
    double most = 0, end = 0, impulse = 0, hourglass = 0;
    while (scene.time() < 1.15 * duration)
      {
        const bool measured = scene.steps() % 50 == 0;
        scene.step(measured);
        const double now = 4 * scene.reaction(wall);
        most             = std::max(most, now);
        impulse += now * scene.time_step;
        if (now > 0)
          end = scene.time();
        if (measured && scene.time() > 0.3 * duration && scene.time() < 0.7 * duration)
          hourglass = std::max(hourglass, scene.energy().stabilisation / scene.energy().strain);
      }
    const std::string name = form_name(setup) + ", ball on a plane: ";
    std::cout << "        " << mesh.cells.size() << " cells, " << scene.steps() << " steps, contact radius "
              << std::sqrt(radius * approach) * 1e3 << " mm, force " << force << " N, duration "
              << duration * 1e6 << " us\n";
    test::check_near(most / force, 1, 0.02, name + "largest force over Hertz's");
    test::check_near(end / duration, 1, 0.02, name + "duration over Hertz's");
    test::check_near(impulse / (2 * weight * velocity), 1, 0.02, name + "impulse over 2 m v");
    if (form_name(setup) == "reduced")
      test::check(hourglass < 0.01, name + "stabilisation over strain energy " + std::to_string(hourglass));
    test::check_near(scene.energy().residual() / scene.energy().start, 0, 0.01, name + "energy balance");
  }
} // namespace

int
main(int argc, char **argv)
{
  Program program(argc, argv);
  for (const Setup &setup : each_form(Setup()))
    {
      rods(setup);
      ball(setup);
    }
  return test::report();
}
