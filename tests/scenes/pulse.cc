#include "pulse.h"

#include <cmath>

namespace scenes
{
  using namespace wheelrail;

  BarScene::BarScene(const Bar &bar, const Function &displacement)
    : Dynamics(box({0, 0, 0}, {bar_length, bar.height(), bar.height()}, {bar.cells, 1, 1}), bar.setup)
  {
    if (bar.confined)
      for (const int component : {1, 2})
        fix(select(solid.mesh, [](const Vector3 &) { return true; }), component);
    prescribe(select(solid.mesh, plane(0, 0)), 0, displacement);
    if (bar.end == End::fixed)
      fix(select(solid.mesh, plane(0, bar_length)), 0);
  }


  double
  pulse_error(const Bar &bar, const Pulse &pulse, const double step)
  {
    const double c = bar.speed();
    BarScene     scene(bar, [=](const double t) { return pulse.displacement(t); });
    const double end   = 1.4 * bar_length / c;
    const auto   steps = static_cast<unsigned int>(std::ceil(end / step));
    scene.time_step    = end / steps;
    while (scene.steps() < steps)
      scene.step();
    double       sum  = 0;
    const double sign = bar.end == End::free ? 1 : -1;
    for (unsigned int n = 0; n < scene.solid.mesh.n_nodes(); ++n)
      {
        const double x = scene.solid.mesh.reference[4 * n];
        const double u =
          pulse.displacement(end - x / c) + sign * pulse.displacement(end - (2 * bar_length - x) / c);
        sum += std::pow(scene.solid.displacement[4 * n] - u, 2);
      }
    return std::sqrt(sum / scene.solid.mesh.n_nodes()) / pulse.displacement(pulse.duration);
  }
} // namespace scenes
