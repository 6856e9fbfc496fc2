#include <wheelrail/base/gather_all.h>
#include <wheelrail/solid/transfer.h>

#include <array>
#include <vector>

namespace wheelrail
{
  double
  body_energy(Solid                          &solid,
              const std::vector<NodeInertia> &inertia,
              const double                    time_step,
              MPI_Comm                        communicator)
  {
    distribute(solid.mesh, solid.velocity.data());
    AlignedVector<double> force(4 * solid.mesh.n_nodes(), 0.);
    ElementEnergy         energy;
    subtract_internal_force(
      solid.blocks, solid.displacement.data(), force.data(), BulkViscosity{}, true, energy);
    condense(solid.mesh, force.data());
    std::array<double, 1> sum{energy.strain + energy.stabilisation + energy.plastic_work};
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      if (inertia[n].inverse_mass > 0)
        {
          const double *const v = &solid.velocity[4 * n], *const f = &force[4 * n];
          // v(n-1/2) m v(n+1/2)/2 = m v^2/2 + dt f . v/2 with v = v(n-1/2), f the elements' forces and the
          // weight
          sum[0] += 0.5 * time_step * (f[0] * v[0] + f[1] * v[1] + f[2] * v[2] - inertia[n].weight * v[1]);
          // potential of the weight, m g u_y
          sum[0] += inertia[n].weight * solid.displacement[4 * n + 1];
          if (solid.mesh.owns(n))
            sum[0] += 0.5 / inertia[n].inverse_mass * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        }
    ordered_sum(sum, communicator);
    return sum[0];
  }
} // namespace wheelrail
