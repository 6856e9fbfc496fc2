#pragma once

#include <wheelrail/solid/energy_balance.h>
#include <wheelrail/solid/motion.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace wheelrail
{
  /// The full step of which a scene's parts are asked, and how its forces change velocities.
  struct Instant
  {
    double         time = 0; ///< of the full step [s]
    double         step = 0; ///< to the next one [s]
    VelocityUpdate velocity_update;
    bool first = false; ///< the velocity_update begins at the full step, with the velocities of that instant
    bool with_energy = false; ///< energies are asked for
  };

  /// What one step leaves to the next of a part's own unknowns, as saved files hold it [SI].
  struct PartState
  {
    std::map<std::string, double> numbers; ///< that all ranks know alike
    /// Nodes with values of their own, by LocalMesh::node_key: those that this rank owns; of a whole state
    /// those of all ranks.
    std::vector<std::uint64_t> nodes;
    std::vector<double>        values; ///< of these nodes, equally many each
  };

  /// Nodes that a part joins: a force of the size stiffness x sum of (weight . displacement) along the
  /// weights of all of them. Of the nodes only those that this rank owns.
  struct JoinedNodes
  {
    double                                        stiffness; ///< [N/m], may be negative
    std::vector<std::pair<unsigned int, Vector3>> nodes;
  };

  /// What a part tells of itself at a full step, a column of the run's history.
  struct PartMeasure
  {
    std::string name, unit;
    double      value; ///< [SI]
  };

  /// A part of a scene, whole: it gives forces to the nodes of the bodies, or holds or moves some of them,
  /// and says what its share is in the time loop, in a static solution, in saved states, in the stable step
  /// and in the energy balance. A part does what it has to do and leaves out the others.
  ///
  /// The time loop asks its parts in their order, phase by phase. Forces stand in solid.force, 4 numbers a
  /// node [N]; displacement is that of the full step, velocity that of the half step behind (of the full step
  /// itself when it is the first).
  class Part
  {
  public:
    virtual ~Part() = default;

    // --- the mesh ---

    /// Fills all that follows from the mesh and the masses, and nothing else does: a start, a resumed run and
    /// a changed mesh come through here. `inertia` has the inverse masses of all nodes; a part that fixes or
    /// moves nodes itself sets those to zero, one with steady loads sets weights. Static solutions hold these
    /// nodes and bear these weights, too. Collective.
    virtual void
    prepare(const Solid &, std::vector<NodeInertia> &)
    {
    }

    // --- the time loop ---

    /// Enters the energy terms of the part.
    virtual void
    enter(EnergyBalance &)
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

    /// Of the last full step with energies, alike on all ranks; always the same names in the same order.
    virtual std::vector<PartMeasure>
    measures() const
    {
      return {};
    }

    /// By how much the part's stiffness can raise the square of the highest angular frequency of the bodies,
    /// its own masses included [1/s2]: the stable step is that of both together. After prepare(). Collective.
    virtual double
    squared_frequency(const Solid &) const
    {
      return 0;
    }

    // --- static solutions; they change nothing of the part ---

    /// y += stiffness x in the position of the solid, x and y with 4 numbers a node: what the nodes feel when
    /// the part's own unknowns are in equilibrium with them (static condensation). Of nodes that do not hang,
    /// alike on all ranks that hold one. Of the wheel only nodes whose motion is relative to the axle
    /// may have stiffness. Symmetric, not negative. Collective.
    virtual void
    add_stiffness(const Solid &, const double *, double *) const
    {
    }

    /// Adds the forces on such nodes in the position of the solid, 4 numbers a node [N]; unless it is told
    /// otherwise, the part is linear. Weights set in prepare() do not belong here. Collective.
    virtual void
    add_static_forces(const Solid &solid, AlignedVector<double> &force) const
    {
      AlignedVector<double> pull(force.size(), 0.);
      add_stiffness(solid, solid.displacement.data(), pull.data());
      for (std::size_t k = 0; k < force.size(); ++k)
        force[k] -= pull[k];
    }

    /// Adds a spring along each axis of a node, 4 numbers a node [N/m], for the preconditioner: the nearer
    /// these and joined() come to the stiffness, the fewer steps. Without any, static solutions ask no part
    /// for its stiffness.
    virtual void
    add_springs(double *) const
    {
    }

    /// What an unknown of the part's own, in equilibrium with many nodes, takes off those springs: terms of
    /// low rank, of which the preconditioner's coarsest level takes account exactly. Alike in number and
    /// order on all ranks; with add_springs() positive semidefinite.
    virtual std::vector<JoinedNodes>
    joined() const
    {
      return {};
    }

    /// After a static solution: brings the part's own unknowns into equilibrium with the displacements and
    /// the velocities of the solid, both of the same instant. Collective.
    virtual void
    start(const Solid &)
    {
    }

    // --- saved states ---

    /// What its state is called in saved files, unique in a scene; empty: it has none.
    virtual std::string
    name() const
    {
      return "";
    }

    virtual PartState
    state() const
    {
      return {};
    }

    /// Goes on from a whole state, after prepare(). Throws std::out_of_range when it lacks something.
    virtual void
    set_state(const PartState &)
    {
    }
  };

  /// The parts of a scene in the order in which the time loop asks them.
  using SceneParts = std::vector<std::unique_ptr<Part>>;

  /// Prepares parts for the mesh and the masses of a solid, and returns what they make of its nodes.
  /// Collective.
  std::vector<NodeInertia>
  prepare_parts(const SceneParts &parts, const Solid &solid);

  /// 1 for nodes that parts hold or move, which would move freely otherwise.
  std::vector<unsigned char>
  held_nodes(const Solid &solid, const std::vector<NodeInertia> &inertia);
} // namespace wheelrail
