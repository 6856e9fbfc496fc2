#include <wheelrail/dynamics/rolling_velocities.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace wheelrail
{
  void
  rolling_velocities(Solid                       &solid,
                     const SceneParts            &parts,
                     const AxleData              &axle,
                     const double                 pitch_rate,
                     const AlignedVector<double> &still,
                     const bool                   travelling)
  {
    AlignedVector<double> moving = solid.displacement;
    for (std::size_t k = 0; k < moving.size(); ++k)
      moving[k] -= still[k];
    const auto gradient =
      travelling ? nodal_gradient(solid, moving.data()) : std::vector<double>(9 * solid.mesh.n_nodes(), 0.);
    GuidedPath::Rate led{{axle.lateral_creepage, 0, 0}, {}};
    if (axle.path)
      led = axle.path->rate(0);
    led.centre[1] += axle.rise;
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      {
        const double *H = &gradient[9 * n];
        double       *v = &solid.velocity[4 * n];
        if (solid.mesh.node_body[n] == Body::wheel)
          {
            const Vector3 arm = solid.mesh.place(n) + vector_at(still, n) - axle.centre; // dents turn, too
            const Vector3 w   = pitch_rate * cross(axle.axis, arm);
            for (int i = 0; i < 3; ++i)
              v[i] = w[i] + H[3 * i] * w[0] + H[3 * i + 1] * w[1] + H[3 * i + 2] * w[2];
            const Vector3 moved = led.centre + cross(led.spin, arm);
            for (int i = 0; i < 3; ++i)
              v[i] += axle.velocity * moved[i];
            v[2] += axle.velocity;
          }
        else
          for (int i = 0; i < 3; ++i)
            v[i] = -axle.velocity * H[3 * i + 2];
      }
    const std::vector<unsigned char> held = held_nodes(solid, prepare_parts(parts, solid));
    for (std::size_t n = 0; n < held.size(); ++n)
      if (held[n])
        std::fill_n(&solid.velocity[4 * n], 3, 0.);
    distribute(solid.mesh, solid.velocity.data());
    for (const auto &part : parts)
      part->start(solid);
  }
} // namespace wheelrail
