#pragma once

#include <wheelrail/solid/histories.h>
#include <wheelrail/solid/motion.h>

#include <mpi.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace wheelrail
{
  /// Carries the state of the bodies from one mesh of a discretization to another; see doc/theory/mesh.md.
  ///
  /// What is interpolated is the deformation: a new node lies dX off the place that the old cell has at its
  /// coordinates, since surfaces are curved and hanging nodes lie at the mean of their parents, so its
  /// displacement is the interpolated one plus H dX, with H the single-valued nodal gradient of
  /// displacements; velocities likewise. Rotations, translations and linear fields pass exactly. Cells
  /// inherit the history of the cell that they are a part of, or the mean of their parts. Momenta
  /// are conserved (conserve_momentum()).
  class SolidTransfer
  {
  public:
    /// Takes the bodies as they are on the mesh before; `middle` [m] along Z parts what is ahead of the wheel
    /// from what is behind it. Collective.
    SolidTransfer(Solid before, double middle, MPI_Comm communicator);

    /// Fills displacement, velocity and histories of bodies that are prepared for another mesh; nodes without
    /// inverse mass in `inertia` keep the velocity that is interpolated. The bulk viscosity finds its
    /// dilatation at the step behind, `time_step` [s] ago (0: there was none). Once for each object.
    /// Collective.
    void
    fill(Solid &after, const std::vector<NodeInertia> &inertia, double time_step);

  private:
    using Gradient = std::array<double, 9>;

    /// State at a place of the old mesh.
    struct Value
    {
      Vector3  X{}, u{}, v{};
      Gradient H{}, D{}; ///< gradients of displacement and velocity
    };

    /// That of a node.
    struct KeyedValue
    {
      std::uint64_t key;
      Value         value;
    };

    void
    fetch(const Solid &after);
    void
    fetch_nodes(const std::vector<std::uint64_t> &wanted);
    bool
    find(const Solid &after, std::size_t node, std::size_t cell, unsigned int vertex, Value &value) const;
    void
    fill_nodes(Solid &after) const;
    void
    fill_histories(Solid &after) const;
    void
    fill_viscous(Solid &after, double time_step) const;
    std::vector<char>
    unchanged_cells(const Solid &after) const;
    std::unordered_set<std::uint64_t>
    kept_cells(const Solid &after) const;

    Solid               before_;
    double              middle_;
    MPI_Comm            communicator_;
    std::vector<double> gradient_u_, gradient_v_; ///< of own old nodes, 9 numbers each
    // of the old mesh what this rank's part of the new one asks for, from all ranks
    std::vector<Value>                                          values_;
    std::unordered_map<std::uint64_t, std::size_t>              node_, cell_;
    std::vector<std::array<std::uint32_t, 8>>                   corners_;
    std::vector<double>                                         cells_; ///< rows of `width_`
    std::size_t                                                 width_ = 0;
    std::map<std::string, std::pair<std::size_t, unsigned int>> columns_; ///< first, number, of a history
  };

  /// Energy of the bodies alone [J]: strain, stabilisation and plastic work, the potential of the weights,
  /// and the kinetic energy at the full step of the nodes that move freely, from the velocities at the half
  /// step behind. The difference between two meshes is what a change of mesh brings in. Plastic elements flow
  /// to the strain of the moment. Collective.
  double
  body_energy(Solid &solid, const std::vector<NodeInertia> &inertia, double time_step, MPI_Comm communicator);
} // namespace wheelrail
