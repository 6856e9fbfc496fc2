#pragma once

#include <wheelrail/solid/part.h>

#include <mpi.h>

#include <vector>

namespace wheelrail
{
  /// What the parts of a scene give to a static solution: nodes that they hold, steady loads, stiffness.
  /// Their own unknowns are in equilibrium with the nodes and do not appear.
  class StaticParts
  {
  public:
    /// Prepares the parts for the mesh of the solid; all must outlive the object. Collective.
    StaticParts(const SceneParts &parts, const Solid &solid, MPI_Comm communicator);

    /// 1 for nodes that do not move.
    const std::vector<unsigned char> &
    held() const
    {
      return held_;
    }

    /// The steady loads, summed over ranks, 4 numbers a node [N].
    const AlignedVector<double> &
    loads() const
    {
      return loads_;
    }

    /// Springs about as stiff, 4 numbers a node [N/m]; empty without any.
    const AlignedVector<double> &
    springs() const
    {
      return springs_;
    }

    /// What takes of those springs, of all parts.
    std::vector<JoinedNodes>
    joined() const;

    /// Adds the forces of the parts in the present position of the solid, but for the steady loads.
    /// Collective.
    void
    add_forces(AlignedVector<double> &force) const;

    /// y += stiffness x, on all nodes that do not hang. Collective.
    void
    add_stiffness(const double *x, double *y) const;

  private:
    const SceneParts          &parts_;
    const Solid               &solid_;
    std::vector<unsigned char> held_;
    AlignedVector<double>      loads_, springs_;
  };
} // namespace wheelrail
