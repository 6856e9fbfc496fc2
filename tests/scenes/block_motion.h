#pragma once

// A block of cubes pressed on one face, the other faces on rollers: the program's elements, exchange
// and update of nodes without contact and axle, on any number of ranks. Motion is one-dimensional.

#include "dynamics.h"

#include <wheelrail/dynamics/time_loop.h>

#include <string>
#include <vector>

namespace scenes
{
  /// One scene: x = 0 is pressed from t = 0 on, the rollers are at the other five sides.
  struct BlockScene
  {
    LocalMesh             mesh;                      ///< whole, on every rank
    double                low[3] = {}, high[3] = {}; ///< its corners [m]
    Elasticity            material;
    wheelrail::Plasticity plasticity;
    double                pressure  = 0; ///< [Pa]
    double                time_step = 0; ///< [s]
    unsigned long         steps     = 0;
  };

  /// n x n x n cubes of edge `h` [m], numbered x first; the step is `factor` times h over the wave speed.
  BlockScene
  block_of_cubes(unsigned int n, double h, double pressure, double factor, unsigned long steps);

  /// A scene of hexahedra from a mesh in gmsh's format 2.2 and its figures in JSON: `path`.msh and
  /// `path`.json with E, nu, rho, sigma_y, E_t, material (elastic or plastic), pressure, dt, steps. Throws
  /// InputError that names the file and what it lacks.
  BlockScene
  read_block(const std::string &path);

  /// Displacement of the pressed face at the time t [m], for t up to 2 L / c with L the length of the block
  /// and c the speed of elastic waves when it yields: an elastic and a plastic front move apart (Rankine and
  /// Hugoniot's relations; Davison 2008). Elastic blocks swing with the period 4 L / c, at any time.
  double
  exact_face(const BlockScene &scene, double t);

  /// What acts on the block: rollers, and the dead pressure.
  class BlockBoundary : public wheelrail::Part
  {
  public:
    BlockBoundary(const BlockScene &scene, MPI_Comm communicator)
      : scene_(scene)
      , communicator_(communicator)
    {
    }

    void
    prepare(const Solid &solid, std::vector<NodeInertia> &inertia) override;
    void
    add_shares(const Instant &now, Solid &solid) override;
    void
    constrain(const Instant &now, Solid &solid, const std::vector<NodeInertia> &inertia) override;

    /// Nodes of the pressed face that this rank owns.
    const Nodes &
    face() const
    {
      return face_;
    }

  private:
    BlockScene               scene_;
    MPI_Comm                 communicator_;
    Nodes                    face_;
    std::vector<std::size_t> held_; ///< places of the node arrays
    std::vector<double>      load_; ///< along x on the nodes of the face [N]
  };

  class BlockMotion
  {
  public:
    /// Collective.
    BlockMotion(const BlockScene      &scene,
                wheelrail::ElementForm form,
                double                 bulk_viscosity,
                MPI_Comm               communicator);

    void
    step(const bool with_energy = false)
    {
      loop.step(with_energy);
    }

    /// Mean displacement of the nodes of the pressed face along x [m]. Collective.
    double
    face_displacement() const;

    Solid         solid;
    BlockBoundary boundary;
    /// Its clock is the CPU time of this process: on a busy machine wall time would count the others.
    wheelrail::TimeLoop loop;

  private:
    MPI_Comm communicator_;
  };
} // namespace scenes
