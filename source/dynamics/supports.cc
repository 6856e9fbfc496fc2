#include <wheelrail/dynamics/supports.h>
#include <wheelrail/solid/boundary_nodes.h>

namespace wheelrail
{
  void
  Supports::prepare(const Solid &solid, std::vector<NodeInertia> &inertia)
  {
    for (const Boundary mark : marks_)
      for (const unsigned int n : held_boundary_nodes(solid.mesh, mark))
        inertia[n].inverse_mass = 0;
  }


  void
  Weight::prepare(const Solid &solid, std::vector<NodeInertia> &inertia)
  {
    for (std::size_t n = 0; n < inertia.size(); ++n)
      if (solid.mesh.node_body[n] == body_ && solid.mesh.owns(n))
        inertia[n].weight = solid.mass[n] * gravity_;
  }


  void
  Weight::enter(EnergyBalance &energies)
  {
    potential_ = &energies.term("potential_energy", EnergyKind::stored);
  }


  void
  Weight::add_forces(const Instant &now, Solid &solid)
  {
    if (!now.with_energy)
      return;
    for (std::size_t n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == body_ && solid.mesh.owns(n))
        potential_->here += solid.mass[n] * gravity_ * solid.displacement[4 * n + 1];
  }
} // namespace wheelrail
