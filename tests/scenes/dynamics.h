#pragma once

// The program's time loop for idealised scenes: any body, motions and loads given as functions of time,
// extra forces by callback, and the energy balance.

#include "parts.h"

#include <wheelrail/dynamics/time_loop.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace scenes
{
  using wheelrail::Elasticity;

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

  /// One scene. Add motions, walls and forces, then call step(). The state is `solid`; displacement and
  /// velocity set before the first step belong to the same instant. Needs MPI (test::Parallel).
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

    /// A rigid frictionless wall: side x (position of the component - level(t)) >= 0, side = 1 or -1; see
    /// Tie. Returns a number for reaction().
    unsigned int
    wall(const Nodes &nodes, int component, int side, const Function &level);

    /// Makes two faces one: nodes in pairs move alike. Their masses must be equal.
    void
    join(const Nodes &one, const Nodes &other);

    /// Adds forces in every step, and counts their work.
    void
    add_force(const NodalLoad::Force &force);

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
      return ties_[number]->reaction;
    }

    double
    time() const
    {
      return loop_.time();
    }
    unsigned long
    steps() const
    {
      return loop_.steps();
    }
    const EnergyBalance &
    energy() const
    {
      return loop_.energy();
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
    unsigned int
    add_tie(const Nodes &nodes, int component, int side, const Function &value);
    double
    mass(const unsigned int node) const
    {
      return solid.mass[node] + solid.added_mass[node];
    }

    Nodes                                   masses_; ///< nodes with mass
    std::vector<std::unique_ptr<Tie>>       ties_;
    std::vector<std::unique_ptr<Seam>>      seams_;
    std::vector<std::unique_ptr<NodalLoad>> loads_;
    wheelrail::TimeLoop                     loop_;
  };
} // namespace scenes
