#pragma once

#include <wheelrail/mesh/cell_tree.h>
#include <wheelrail/mesh/local_mesh.h>
#include <wheelrail/mesh/sweep_plan.h>
#include <wheelrail/mesh/swept_grid.h>

#include <memory>
#include <vector>

#include <mpi.h>

// deal.II's headers take seconds to parse: those who use what is behind these names include them.
namespace dealii
{
  template <int, int>
  class DoFHandler;
  template <typename>
  class AffineConstraints;
  template <int, int>
  class CellAccessor;
  namespace parallel
  {
    namespace distributed
    {
      template <int, int>
      class Triangulation;
    }
  } // namespace parallel
} // namespace dealii

namespace wheelrail
{
  /// Wheel and rail as swept sections of coarse blocks, refined towards the strip where they touch: one
  /// distributed triangulation of deal.II on p4est, with a trilinear scalar unknown at each vertex and the
  /// constraints of those that hang. The one maker of meshes, for the start, the moving window, passages and
  /// unloading.
  ///
  /// Which cells are divided is told by CellTree, and positions come from the exact sections; hanging
  /// vertices lie at the mean of their parents. So the vertices of the triangulation itself have no meaning.
  class Discretization
  {
  public:
    using Triangulation = dealii::parallel::distributed::Triangulation<3, 3>;
    using Dofs          = dealii::DoFHandler<3, 3>;
    using Constraints   = dealii::AffineConstraints<double>;

    /// A cell of the triangulation and where it lies in its body.
    struct Cell
    {
      int       level, index;
      CellPlace place;
    };

    /// The coarse blocks of both bodies, or of those that are named, with no cells laid. Collective.
    Discretization(MPI_Comm                 communicator,
                   SweepPlan                plan,
                   const std::vector<Body> &bodies = {Body::rail, Body::wheel});
    ~Discretization();
    Discretization(const Discretization &) = delete;

    /// Lays the finest cells into `zones`; none: the blocks stay whole. The ranks share the cells in p4est's
    /// order so that each has as much work; `work` is that of a cell of each body. Collective.
    void
    lay(const PerBody<FineZone> &zones, const PerBody<int> &work = {1, 1});

    /// The part of this rank as plain arrays. Cells follow each other in p4est's order, own nodes in that in
    /// which the cells use them, whatever meshes were laid before. Collective.
    LocalMesh
    local_mesh() const;

    /// The cells of this rank in p4est's order, which does not depend on what was laid before.
    const std::vector<Cell> &
    own_cells() const
    {
      return own_cells_;
    }
    /// Of a cell that this rank has or that lies beside one of those: where it lies.
    CellPlace
    place(const dealii::CellAccessor<3, 3> &cell) const;

    const Triangulation &
    triangulation() const
    {
      return *triangulation_;
    }
    const Dofs &
    dofs() const
    {
      return *dofs_;
    }
    const Constraints &
    hanging() const
    {
      return *hanging_;
    }
    const SweepPlan &
    plan() const
    {
      return plan_;
    }
    const PerBody<SweptGrid> &
    grids() const
    {
      return grids_;
    }
    const SweptGrid &
    grid(const Body body) const
    {
      return grids_[body];
    }
    MPI_Comm
    communicator() const
    {
      return communicator_;
    }

  private:
    void
    create_blocks();
    void
    find_own_cells();
    void
    number_unknowns();

    SweepPlan                      plan_;
    PerBody<SweptGrid>             grids_;
    MPI_Comm                       communicator_;
    std::unique_ptr<Triangulation> triangulation_;
    std::vector<CellPlace>         blocks_; ///< of each of p4est's trees
    std::unique_ptr<Dofs>          dofs_;
    std::unique_ptr<Constraints>   hanging_;
    std::vector<Cell>              own_cells_;
    std::vector<Body>              bodies_;
  };
} // namespace wheelrail
