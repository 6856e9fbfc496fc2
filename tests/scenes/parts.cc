#include "parts.h"

#include <wheelrail/solid/exchange.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace scenes
{
  using namespace wheelrail;

  void
  Tie::enter(EnergyBalance &energies)
  {
    work_ = &energies.term("external_work", EnergyKind::supplied);
  }


  void
  Tie::constrain(const Instant &now, Solid &solid, const std::vector<NodeInertia> &inertia)
  {
    const double value = value_(now.time + now.step);
    reaction           = 0;
    double way         = 0;
    for (const unsigned int n : nodes_)
      {
        if (inertia[n].inverse_mass == 0)
          continue;
        const unsigned int k    = 4 * n + component_;
        const double       gain = now.velocity_update.gain * inertia[n].inverse_mass;
        const double       u = solid.displacement[k], v = solid.velocity[k];
        const double       free   = now.velocity_update.retain * v + gain * solid.force[k];
        const double       target = side_ == 0 ? value : value - solid.mesh.reference[k];
        if (side_ != 0 && side_ * (u + now.step * free - target) >= 0)
          continue;
        const double wanted = (target - u) / now.step, force = (wanted - free) / gain;
        solid.force[k] += force;
        reaction += force;
        way += force * 0.5 * (v + wanted);
      }
    work_->add_work(now.velocity_update.duration * way);
  }


  void
  Seam::constrain(const Instant &, Solid &solid, const std::vector<NodeInertia> &)
  {
    for (std::size_t n = 0; n < one_.size(); ++n)
      for (int i = 0; i < 3; ++i)
        {
          double &a = solid.force[4 * one_[n] + i], &b = solid.force[4 * other_[n] + i];
          a = b = 0.5 * (a + b);
        }
  }


  void
  NodalLoad::prepare(const Solid &solid, std::vector<NodeInertia> &)
  {
    nodal_.assign(solid.force.size(), 0.);
  }


  void
  NodalLoad::enter(EnergyBalance &energies)
  {
    work_ = &energies.term("external_work", EnergyKind::supplied);
  }


  void
  NodalLoad::add_forces(const Instant &now, Solid &solid)
  {
    std::fill(nodal_.begin(), nodal_.end(), 0.);
    force_(now.time, solid, nodal_.data());
    condense(solid.mesh, nodal_.data());
    for (std::size_t k = 0; k < nodal_.size(); ++k)
      solid.force[k] += nodal_[k];
  }


  void
  NodalLoad::account(const Instant &now, const Solid &solid, const std::vector<NodeInertia> &inertia)
  {
    double power = 0;
    for (unsigned int n = 0; n < inertia.size(); ++n)
      if (inertia[n].inverse_mass > 0)
        power += dot(Vector3{nodal_[4 * n], nodal_[4 * n + 1], nodal_[4 * n + 2]},
                     mean_velocity(solid, inertia, n, now.velocity_update));
    work_->add_work(now.velocity_update.duration * power);
  }


  NodalLoad::Force
  dead_pressure(const LocalMesh &mesh, const std::vector<BoundaryFace> &faces, const Function &pressure)
  {
    // integrals of shape function times outward normal, 2 x 2 Gauss points
    std::vector<double> loads(4 * mesh.n_nodes(), 0.);
    for (const auto &face : faces)
      for (int q = 0; q < 4; ++q)
        {
          const double x     = 0.5 + (q & 1 ? 0.5 : -0.5) / std::sqrt(3.),
                       y     = 0.5 + (q >> 1 ? 0.5 : -0.5) / std::sqrt(3.);
          const double N[4]  = {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
          const double dx[4] = {y - 1, 1 - y, -y, y}, dy[4] = {x - 1, -x, 1 - x, x};
          Vector3      a{}, b{};
          for (int k = 0; k < 4; ++k)
            {
              add(a, dx[k], place_of(mesh, face.nodes[k]));
              add(b, dy[k], place_of(mesh, face.nodes[k]));
            }
          const Vector3 normal = cross(a, b);
          for (int k = 0; k < 4; ++k)
            for (int i = 0; i < 3; ++i)
              loads[4 * face.nodes[k] + i] += 0.25 * N[k] * normal[i];
        }
    return [loads, pressure](const double time, const Solid &, double *force) {
      const double p = pressure(time);
      for (std::size_t k = 0; k < loads.size(); ++k)
        force[k] -= p * loads[k];
    };
  }
} // namespace scenes
