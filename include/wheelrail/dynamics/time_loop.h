#pragma once

#include <wheelrail/solid/exchange.h>
#include <wheelrail/solid/part.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace wheelrail
{
  /// Internal forces of the elements of both bodies, with the linear bulk viscosity, and their energies.
  /// `plastic_work` is all work of plastic flow, `hardening_energy` the part of it that
  /// hardening stores; the rest is heat.
  class ElementForces
  {
  public:
    void
    enter(EnergyBalance &energies);

    /// Subtracts the internal forces of the rank's elements; the first step only records the dilatation, from
    /// which the viscosity of the next one takes its rate.
    void
    add_shares(const Instant &now, double bulk_viscosity, Solid &solid);

  private:
    EnergyTerm *strain_ = nullptr, *stabilisation_ = nullptr, *plastic_ = nullptr, *hardening_ = nullptr,
               *viscous_ = nullptr;
  };

  /// Constants of the scheme.
  struct TimeScheme
  {
    double time_step      = 0; ///< [s]
    double bulk_viscosity = 0; ///< coefficient of the linear bulk viscosity
    double mass_damping = 0; ///< force -rate x mass x velocity on all nodes, for scenes that shall rest [1/s]
  };

  /// The one explicit time loop: central differences for deformable bodies and for the parts of a scene.
  ///
  /// Displacements are known at full steps, velocities at half steps; a start has both at the same instant.
  /// One step: shares of the forces (elements, then the parts), their sum over ranks, forces that all ranks
  /// have alike (contact, loads), constraints (axle, supports, walls), energies, and then all free nodes.
  class TimeLoop
  {
  public:
    /// The state in `solid` (displacement and velocity at the same instant) is the start.
    TimeLoop(Solid &solid, const TimeScheme &scheme, MPI_Comm communicator);
    TimeLoop(const TimeLoop &) = delete;

    /// Parts act in the order in which they are added; each must outlive the loop.
    void
    add(Part &part);

    /// Prepares the loop and all parts for the mesh and the masses that `solid` has now: before the first
    /// step, and whenever the mesh changes. Collective.
    void
    prepare();

    /// Goes on with the bodies on another mesh: `remake` prepares solid, and what else the parts are made of,
    /// for it; then loop and parts are prepared, and the state is carried over (SolidTransfer). `middle` [m]:
    /// Z of the contact. What the change brings in or takes out is the supplied energy `mesh_change_work`.
    /// Collective.
    void
    change_mesh(const std::function<void()> &remake, double middle);

    /// Lets a body turn faster about `centre`, by a rigid rotation with the rate `spin` [rad/s]. Returns the
    /// kinetic energy that the free nodes gain, of those that this rank owns [J].
    double
    add_spin(Body body, const Vector3 &centre, const Vector3 &spin);

    /// One time step. `with_energy` brings the energies up to date, too. Collective.
    void
    step(bool with_energy);

    /// May be changed as long as no step is made.
    TimeScheme scheme;

    double
    time() const
    {
      return time_;
    }
    unsigned long
    steps() const
    {
      return steps_;
    }
    const EnergyBalance &
    energy() const
    {
      return energies_;
    }
    /// For works that no part does.
    EnergyBalance &
    energy()
    {
      return energies_;
    }

    /// What one step leaves to the next beside the bodies and the contact.
    struct State
    {
      double               time  = 0; ///< [s]
      unsigned long        steps = 0;
      EnergyBalance::State energy;
      /// Of the parts that have a name.
      std::map<std::string, PartState> parts;
    };
    State
    state() const;
    /// Throws std::out_of_range when the state of a part lacks something.
    void
    set_state(const State &state);

    /// Seconds spent since the start (this rank).
    struct Timing
    {
      double elements = 0; ///< forces of the elements
      double exchange = 0; ///< sums over ranks
      double parts    = 0; ///< contact, loads, constraints
      double update   = 0; ///< of the nodes
      double mesh     = 0; ///< changes of the mesh

      double
      sum() const
      {
        return elements + exchange + parts + update + mesh;
      }
    };
    const Timing &
    timing() const
    {
      return timing_;
    }
    /// Where seconds come from, wall time unless set: a benchmark on a busy machine takes CPU time.
    double (*clock)();

  private:
    Instant
    instant(bool with_energy) const;
    void
    account(const Instant &now);
    void
    move(const Instant &now);

    Solid                   &solid_;
    MPI_Comm                 communicator_;
    ElementForces            elements_;
    std::vector<Part *>      parts_;
    std::vector<NodeInertia> inertia_;
    EnergyBalance            energies_;
    EnergyTerm              &kinetic_, &mesh_change_;
    double                   time_  = 0;
    unsigned long            steps_ = 0;
    Timing                   timing_;
  };
} // namespace wheelrail
