#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/affine_constraints.h>

#include <wheelrail/mesh/local_mesh.h>
#include <wheelrail/mesh/sweep_plan.h>

#include <array>

namespace wheelrail
{
  /// Wheel and rail in one p4est forest, refined towards the strip where they touch.
  ///
  /// All cells that overlap the box below the strip are of the finest level. Cells beside it grow with
  /// the distance, and are not divided where the blocks are so thin that their parts would be thinner
  /// than the finest cells: those alone should govern the stable time step.
  ///
  /// The triangulation carries the topology only. Positions come from the exact sections: every
  /// vertex knows its place in its coarse block, hanging vertices lie at the mean of their parents.
  class Forest
  {
  public:
    Forest(MPI_Comm communicator, SweepPlan plan);

    /// Reference position [m] of a vertex of an active cell, before hanging vertices are averaged.
    std::array<double, 3>
    vertex_position(const dealii::CellAccessor<3> &cell, unsigned int vertex) const;

    /// The rank's part as plain arrays.
    LocalMesh
    local_mesh() const;

    const SweepPlan &
    plan() const
    {
      return plan_;
    }
    const dealii::DoFHandler<3> &
    dofs() const
    {
      return dofs_;
    }
    /// Hanging-node constraints of the three displacement components; dof = 3 node + component.
    const dealii::AffineConstraints<double> &
    constraints() const
    {
      return constraints_;
    }
    const dealii::IndexSet &
    relevant_dofs() const
    {
      return relevant_;
    }
    MPI_Comm
    communicator() const
    {
      return triangulation_.get_communicator();
    }

  private:
    /// Block coordinates of a cell within its coarse cell: lower corner and size.
    struct Box
    {
      std::array<double, 3> corner;
      double                size;
    };
    Box
    box(const dealii::CellId &id) const;

    /// Distances of a cell from the box of finest cells: across the strip, in depth, along the track.
    double
    distance_from_fine_box(const dealii::CellAccessor<3> &cell) const;

    /// Smallest stretch of the unit cube onto a cell [m]: the edge of a cube, the thickness of a flat or
    /// skewed cell. The stable time step is in proportion to it.
    double
    cell_width(const dealii::CellAccessor<3> &cell) const;

    std::array<double, 3>
    position(unsigned int coarse_cell, const std::array<double, 3> &xi) const;

    void
    make_coarse_mesh();
    void
    refine();
    void
                                                    number();
    SweepPlan                                       plan_;
    dealii::parallel::distributed::Triangulation<3> triangulation_;
    dealii::FESystem<3>                             element_;
    dealii::DoFHandler<3>                           dofs_;
    dealii::AffineConstraints<double>               constraints_;
    dealii::IndexSet                                relevant_;
    unsigned int n_rail_cells_ = 0; ///< coarse cells of the rail come first
  };
} // namespace wheelrail
