#include "ball_impact.h"

#include <algorithm>
#include <cmath>

namespace scenes
{
  using namespace wheelrail;

  BallImpact
  ball_impact(const Setup &setup, const double velocity, const BallCells &cells)
  {
    const double      radius  = 0.01;
    const Elasticity &m       = setup.material;
    const double      modulus = m.youngs_modulus / (1 - m.poissons_ratio * m.poissons_ratio);
    const double      weight  = 4 * M_PI / 3 * std::pow(radius, 3) * m.density;
    const double      approach =
      std::pow(15 * weight * velocity * velocity / (16 * modulus * std::sqrt(radius)), 0.4);
    BallImpact result{};
    result.hertz_force    = 4. / 3 * modulus * std::sqrt(radius) * std::pow(approach, 1.5);
    result.hertz_duration = 2.9432 * approach / velocity;

    Dynamics    scene(quarter_ball(radius, cells), setup);
    const auto &mesh       = scene.solid.mesh;
    const auto  on_surface = [&](const Vector3 &X) {
      return norm(X - Vector3{0, 0, radius}) > 0.9999 * radius;
    };
    const auto wall = scene.wall(select(mesh, on_surface), 2, 1, [](double) { return 0.; });
    for (const int component : {0, 1})
      scene.fix(select(mesh, plane(component, 0)), component);
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      scene.solid.velocity[4 * n + 2] = -velocity;
    while (scene.time() < 1.15 * result.hertz_duration)
      {
        const double when     = scene.time() / result.hertz_duration;
        const bool   measured = scene.steps() % 50 == 0;
        scene.step(measured);
        const double now = 4 * scene.reaction(wall);
        result.force     = std::max(result.force, now / result.hertz_force);
        result.impulse += now * scene.time_step / (2 * weight * velocity);
        if (now > 0)
          result.duration = scene.time() / result.hertz_duration;
        if (measured && when > 0.3 && when < 0.7)
          result.stabilisation = std::max(
            result.stabilisation, scene.energy()["stabilisation_energy"] / scene.energy()["strain_energy"]);
      }
    result.residual = scene.energy().residual() / scene.energy().start();
    result.cells    = mesh.cells.size();
    result.steps    = scene.steps();
    return result;
  }
} // namespace scenes
