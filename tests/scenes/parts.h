#pragma once

// Parts of the program's time loop for idealised scenes on one rank: motions, walls and loads given as
// functions of time.

#include "meshes.h"

#include <wheelrail/solid/part.h>

#include <functional>
#include <vector>

namespace scenes
{
  using wheelrail::EnergyBalance;
  using wheelrail::EnergyTerm;
  using wheelrail::Instant;
  using wheelrail::NodeInertia;
  using wheelrail::Solid;

  using Function = std::function<double(double time)>;

  /// Nodes whose component is prescribed (side 0) or bounded by a rigid frictionless wall (side 1 or -1):
  /// side x (position of the component - value) >= 0. The reaction is the force that leads a node where it
  /// must be at the next full step, the forward increment Lagrange multiplier (Carpenter, Taylor and Katona
  /// 1991): no penalty, no limit on the step. A node that hits a wall loses the energy of its normal
  /// velocity.
  class Tie : public wheelrail::Part
  {
  public:
    Tie(const Nodes &nodes, const int component, const int side, const Function &value)
      : nodes_(nodes)
      , component_(component)
      , side_(side)
      , value_(value)
    {
    }

    void
    enter(EnergyBalance &energies) override;
    void
    constrain(const Instant &now, Solid &solid, const std::vector<NodeInertia> &inertia) override;

    /// Sum of the forces on the body at the last full step [N].
    double reaction = 0;

    /// Whether the motion is prescribed, and not only bounded.
    bool
    prescribed() const
    {
      return side_ == 0;
    }
    const Nodes &
    nodes() const
    {
      return nodes_;
    }
    unsigned int
    component() const
    {
      return component_;
    }

  private:
    Nodes        nodes_;
    unsigned int component_;
    int          side_;
    Function     value_;
    EnergyTerm  *work_ = nullptr;
  };

  /// Two faces that are one, as in a body that repeats itself: nodes in pairs, of equal masses, which move
  /// alike.
  class Seam : public wheelrail::Part
  {
  public:
    Seam(const Nodes &one, const Nodes &other)
      : one_(one)
      , other_(other)
    {
    }

    void
    constrain(const Instant &now, Solid &solid, const std::vector<NodeInertia> &inertia) override;

  private:
    Nodes one_, other_;
  };

  /// Nodal forces given by a function of time and state; their work is counted.
  class NodalLoad : public wheelrail::Part
  {
  public:
    /// Adds to `force`, 4 numbers a node [N]; the velocity in `solid` is that of the half step behind.
    using Force = std::function<void(double time, const Solid &solid, double *force)>;

    explicit NodalLoad(const Force &force)
      : force_(force)
    {
    }

    void
    prepare(const Solid &solid, std::vector<NodeInertia> &inertia) override;
    void
    enter(EnergyBalance &energies) override;
    void
    add_forces(const Instant &now, Solid &solid) override;
    void
    account(const Instant &now, const Solid &solid, const std::vector<NodeInertia> &inertia) override;

  private:
    Force force_;
    wheelrail::AlignedVector<double>
                nodal_; ///< forces of this step, those of hanging nodes at their parents [N]
    EnergyTerm *work_ = nullptr;
  };

  /// Dead load: pressure(t) [Pa] on the faces in the reference configuration.
  NodalLoad::Force
  dead_pressure(const LocalMesh &mesh, const std::vector<BoundaryFace> &faces, const Function &pressure);
} // namespace scenes
