#pragma once

#include <wheelrail/solid/energy_book.h>
#include <wheelrail/solid/motion.h>

#include <vector>

namespace wheelrail
{
  /// The full step of which a scene's parts are asked, and how its forces change velocities.
  struct Instant
  {
    double time = 0; ///< of the full step [s]
    double step = 0; ///< to the next one [s]
    Kick   kick;
    bool   first       = false; ///< the kick begins at the full step, with the velocities of that instant
    bool   with_energy = false; ///< energies are asked for
  };

  /// A part of a scene: it gives forces to the nodes of the bodies, or holds or moves some of them. The time
  /// loop asks its parts in their order, phase by phase; a part does what it has to do in a phase and leaves
  /// out the others.
  ///
  /// Forces stand in solid.force, 4 numbers a node [N]; displacement is that of the full step, velocity that
  /// of the half step behind (of the full step itself when it is the first).
  class Part
  {
  public:
    virtual ~Part() = default;

    /// Fills all that follows from the mesh and the masses, and nothing else does: a start, a resumed run and
    /// a changed mesh come through here. `inertia` has the inverse masses of all nodes; a part that fixes or
    /// moves nodes itself sets those to zero, one with steady loads sets weights. Collective.
    virtual void
    prepare(const Solid &, std::vector<NodeInertia> &)
    {
    }

    /// Enters the energy terms of the part.
    virtual void
    enter(EnergyBook &)
    {
    }

    /// Adds forces of which each rank knows its own share; they are summed over the ranks that hold a node.
    virtual void
    add_shares(const Instant &, Solid &)
    {
    }

    /// Adds forces that all ranks know alike for the nodes they hold.
    virtual void
    add_forces(const Instant &, Solid &)
    {
    }

    /// All forces are there: adds reactions that lead nodes where they must be, and moves nodes that the part
    /// has taken from the loop.
    virtual void
    constrain(const Instant &, Solid &, const std::vector<NodeInertia> &)
    {
    }

    /// Forces are final: brings works up to date, and the other energies when they are asked for.
    virtual void
    account(const Instant &, const Solid &, const std::vector<NodeInertia> &)
    {
    }
  };
} // namespace wheelrail
