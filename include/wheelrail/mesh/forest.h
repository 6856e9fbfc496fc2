#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/affine_constraints.h>

#include <wheelrail/mesh/cell_tree.h>
#include <wheelrail/mesh/local_mesh.h>
#include <wheelrail/mesh/sweep_plan.h>
#include <wheelrail/mesh/swept_grid.h>

#include <array>
#include <cstdint>

namespace wheelrail
{
  /// Wheel and rail in one p4est forest, refined towards the strip where they touch.
  ///
  /// Which cells are divided is told by CellTree.
  ///
  /// The triangulation carries the topology only. Positions come from the exact sections: every
  /// vertex knows its place in its coarse block, hanging vertices lie at the mean of their parents.
  class Forest
  {
  public:
    /// The finest cells lie where the plan has them at the start, or in `zones` of both bodies.
    Forest(MPI_Comm communicator, const SweepPlan &plan);
    Forest(MPI_Comm communicator, SweepPlan plan, const PerBody<FineZone> &zones);

    /// Reference position [m] of a vertex of an active cell, before hanging vertices are averaged.
    std::array<double, 3>
    vertex_position(const dealii::CellAccessor<3> &cell, unsigned int vertex) const;

    /// See SweptGrid::vertex_key().
    std::uint64_t
    vertex_key(const dealii::CellAccessor<3> &cell, unsigned int vertex) const;

    /// The rank's part as plain arrays.
    LocalMesh
    local_mesh() const;

    const SweepPlan &
    plan() const
    {
      return plan_;
    }
    const SweptGrid &
    grid(const Body body) const
    {
      return grids_[body];
    }
    const dealii::DoFHandler<3> &
    dofs() const
    {
      return dofs_;
    }
    MPI_Comm
    communicator() const
    {
      return triangulation_.get_communicator();
    }

  private:
    /// Where a cell lies, as SweptMesh counts.
    CellPlace
    place(const dealii::CellAccessor<3> &cell) const;

    CellPlace
    coarse_place(unsigned int coarse_cell) const;

    /// A vertex of a cell in the finest lattice of its block and body.
    std::array<int, 3>
    vertex_place(const CellPlace &cell, unsigned int vertex) const;

    void
    make_coarse_mesh();
    void
    refine(const PerBody<FineZone> &zones);
    void
    number();

    SweepPlan                                       plan_;
    PerBody<SweptGrid>                              grids_;
    dealii::parallel::distributed::Triangulation<3> triangulation_;
    dealii::FESystem<3>                             element_;
    dealii::DoFHandler<3>                           dofs_;
    dealii::AffineConstraints<double>               constraints_;
    dealii::IndexSet                                relevant_;
    unsigned int n_rail_cells_ = 0; ///< coarse cells of the rail come first
  };
} // namespace wheelrail
