#pragma once

// The explicit central difference scheme of the program for idealised scenes: any body, motions and
// loads given as functions of time, extra forces by callback, and the energy balance.

#include "meshes.h"

#include <wheelrail/solid/solid.h>

#include <optional>

namespace scenes
{
  using wheelrail::Elasticity;
  using wheelrail::Solid;

  using Function = std::function<double(double time)>;

  /// Energies [J] at a full step. The kinetic energy is half the mass times the product of the velocities
  /// of both half steps around it: with it, central differences keep the energy of a linear body to
  /// round-off at any stable step (the mean of both squares would exceed it by up to the strain energy of
  /// the highest waves).
  struct Energy
  {
    double kinetic = 0, strain = 0, stabilisation = 0;
    double plastic = 0; ///< work done on plastic strains, stored in hardening or dissipated
    double viscous = 0; ///< dissipated by the bulk viscosity
    double damping = 0; ///< dissipated by the mass damping
    double work    = 0; ///< done by loads, extra forces, prescribed motions and walls
    double start   = 0; ///< total at the start

    /// What the parts fail to add up to since the start.
    double
    residual() const
    {
      return kinetic + strain + stabilisation + plastic + viscous + damping - work - start;
    }
    /// |residual| over strain plus dissipated energy, as in the program's summary.
    double
    error() const
    {
      return std::abs(residual()) / (strain + stabilisation + plastic + viscous + damping);
    }
  };

  /// Materials and the scheme of a scene.
  struct Setup
  {
    Elasticity            material; ///< of both bodies
    wheelrail::Plasticity plasticity;
    /// Of the wheel instead, if it differs.
    std::optional<Elasticity> wheel_material;
    wheelrail::ElementForm    form           = wheelrail::ElementForm::reduced;
    double                    bulk_viscosity = 0;    ///< linear coefficient; 0.06 in the program
    double                    step_factor    = 0.95; ///< of the stable step
    double                    mass_damping   = 0;    ///< force -c m v, for static problems only [1/s]
  };

  /// The setup once for each element form; the tests run over them.
  std::vector<Setup>
  each_form(const Setup &setup);

  /// Name of the element form, for the texts of checks.
  std::string
  form_name(const Setup &setup);

  /// Starts and ends MPI, which the solid needs; keep one in main().
  struct Program
  {
    Program(int &argc, char **&argv);
    ~Program();
  };

  /// One scene. Add motions, walls and forces, then call step(). The state is `solid`; displacement and
  /// velocity set before the first step belong to the same instant. Needs MPI (class Program).
  class Dynamics
  {
  public:
    Dynamics(LocalMesh mesh, const Setup &setup);

    /// The component of the nodes follows displacement(t) [m], whose value at t = 0 must be that of the
    /// start. Returns a number for reaction(). Hanging nodes are left to their parents.
    unsigned int
    prescribe(const Nodes &nodes, int component, const Function &displacement);

    /// The component of the nodes stays where it is.
    unsigned int
    fix(const Nodes &nodes, int component);

    /// A rigid frictionless wall: side x (position of the component - level(t)) >= 0, side = 1 or -1.
    /// Exact impenetrability by the forward increment Lagrange multiplier (Carpenter, Taylor and Katona
    /// 1991): no penalty, no limit on the step. A node that hits loses the energy of its normal velocity.
    /// Returns a number for reaction().
    unsigned int
    wall(const Nodes &nodes, int component, int side, const Function &level);

    /// Adds forces in every step. force: 4 numbers a node [N]; the velocity in `solid` is that of the
    /// half step behind. The work of the force is counted.
    using Force = std::function<void(double time, const Solid &solid, double *force)>;
    void
    add_force(const Force &force);

    /// Dead load: pressure(t) [Pa] on the faces in the reference configuration.
    void
    press(const std::vector<BoundaryFace> &faces, const Function &pressure);

    /// One time step. `with_energy` updates energy().
    void
    step(bool with_energy = false);

    /// Steps until `time` [s] is reached or passed.
    void
    run_to(double time);

    /// Sum of the forces of a motion or wall on the body at the last full step [N].
    double
    reaction(const unsigned int number) const
    {
      return ties_[number].reaction;
    }

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
    const Energy &
    energy() const
    {
      return balance_;
    }
    /// Of the velocities in `solid` [J].
    double
    kinetic_energy() const;

    /// Largest angular frequency of small vibrations with the motions prescribed so far held, by power
    /// iteration with the kernel's own forces [1/s]. A lower bound that `iterations` bring up to the value.
    double
    highest_frequency(unsigned int iterations = 2000) const;

    Solid  solid;
    double time_step; ///< may be changed before the first step [s]
    double mass_damping;

  private:
    using Vector = wheelrail::AlignedVector<double>;
    /// Nodes whose component is prescribed (side 0) or bounded by a wall (side 1 or -1).
    struct Tie
    {
      Nodes        nodes;
      unsigned int component;
      int          side;
      Function     value;
      double       reaction;
    };
    unsigned int
    add_tie(const Nodes &nodes, int component, int side, const Function &value);
    double
    mass(const unsigned int node) const
    {
      return solid.mass[node] + solid.added_mass[node];
    }
    void
    add_internal_forces(bool with_energy);
    void
    add_external_forces();
    void
    move_nodes(double kick);
    void
    apply(Tie &tie, double kick);
    void
    balance(const Energy &before);

    double                   bulk_viscosity_;
    Nodes                    masses_;          ///< nodes with mass
    Vector                   velocity_before_; ///< of the half step behind [m/s]
    Vector                   external_;        ///< extra forces of this step [N]
    std::vector<Tie>         ties_;
    std::vector<Force>       forces_;
    wheelrail::ElementEnergy elements_;
    Energy                   energy_;  ///< sums up to the last half step
    Energy                   balance_; ///< of the last full step that asked for it
    double                   time_  = 0;
    unsigned long            steps_ = 0;
  };
} // namespace scenes
