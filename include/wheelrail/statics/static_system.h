#pragma once

#include <wheelrail/solid/part.h>
#include <wheelrail/statics/static_multigrid.h>

#include <deal.II/lac/la_parallel_block_vector.h>

#include <mpi.h>

#include <memory>
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

  /// A change of position: of the free unknowns and of the height of the bore.
  struct StaticStep
  {
    NodeVector increment;
    double     hub_displacement = 0; ///< [m]
  };

  /// The linear system of one static start: stiffness of both bodies at rest, of the parts of the scene and
  /// of contact springs; what parts hold is held, the bore of the wheel moved vertically as one.
  ///
  /// Solved by conjugate gradients with the element kernel as operator and geometric multigrid before it.
  class StaticSystem
  {
  public:
    using Vector = NodeVector;

    /// The solid and the parts must outlive the system, the solid keep its elements. Collective.
    StaticSystem(const Discretization &discretization, Solid &solid, const SceneParts &parts);

    const StaticParts &
    parts() const
    {
      return parts_;
    }

    Vector
    zero() const
    {
      return multigrid_->finest().zero();
    }

    /// Local nodal forces, already summed over ranks, as a right-hand side.
    Vector
    right_hand_side(const AlignedVector<double> &nodal) const;

    /// Adds increment + constraints (bore raised by `hub_displacement` [m]) to the nodal values.
    void
    add_to_nodes(const Vector &increment, double hub_displacement, AlignedVector<double> &nodal) const;

    /// Sum of the vertical nodal forces on the bore [N], from local forces summed over ranks. Collective.
    double
    bore_force(const AlignedVector<double> &nodal) const;

    /// The stiffness is that of both bodies plus these springs from now on; finds about the response to a
    /// hub displacement of the bore. Collective.
    void
    set_springs(const std::vector<Contact::Spring> &springs);

    /// Increment and hub displacement together under forces on the free unknowns and on the bore [N], the
    /// latter freely moving up and down: solves until what is out of balance is below `tolerance` times the
    /// given. Returns the CG steps. Throws RunError after 500, or when a number is not finite. Collective.
    unsigned int
    solve(const Vector &forces, double bore, double tolerance, StaticStep &step);

    /// The same with the bore held, for the displacements of the free nodes alone; starts at those in
    /// `increment`.
    unsigned int
    solve_held(const Vector &forces, double tolerance, Vector &increment);

    /// An estimate of solve(), linear and symmetric in the forces: one cycle of the preconditioner, and the
    /// response to a vertical displacement with the share that balances the bore. Collective.
    StaticStep
    precondition(const Vector &forces, double bore);

    /// CG steps of set_springs() and solve() so far.
    unsigned int cg_steps = 0;

    /// Passes over the elements of the mesh that the solutions have taken so far; those of coarser levels
    /// count in proportion.
    double
    passes() const
    {
      return multigrid_->passes();
    }

  private:
    /// Displacements against a rigid vertical displacement of the whole wheel, and that displacement [m],
    /// which the first rank has; or the forces that belong to them: nodal ones, and the vertical force on the
    /// whole wheel [N].
    using Unknowns = dealii::LinearAlgebra::distributed::BlockVector<double>;
    Unknowns
    unknowns(const Vector &nodes, double hub_displacement) const;
    static void
    set_hub_displacement(Unknowns &x, double hub_displacement);
    double
    hub_displacement(const Unknowns &x) const;
    double
    product(const Vector &x, double hub_displacement, Vector &y);
    double
    precondition(const Vector &forces, double along, Vector &z);
    template <typename Values, typename Product, typename Preconditioner>
    unsigned int
    conjugate_gradients(const Product        &product,
                        const Preconditioner &preconditioner,
                        const Values         &load,
                        double                enough,
                        Values               &x);
    void
    find_lift_response();
    void
    add_stiffness_of_parts(const Vector &x, Vector &y) const;

    const LocalMesh           &mesh_;
    MPI_Comm                   communicator_;
    StaticParts                parts_;
    std::vector<unsigned char> bore_, held_; ///< 1: the node moves with the bore; it does not move freely
    std::unique_ptr<StaticMultigrid> multigrid_;
    Vector              rigid_;         ///< free nodes in a rigid vertical displacement of the wheel by 1 m
    std::vector<double> rigid_stretch_; ///< of the springs in that [1]
    Vector              response_;      ///< about, to a vertical displacement of the bore by 1 m, against it
    double              approach_stiffness_ = 0; ///< energy of the response, twice [N/m]
  };

  /// Forces of the elements of bodies at rest in their present position [N], those of hanging nodes handed to
  /// their parents, summed over ranks. Elements that may flow take the step to this position. Collective.
  AlignedVector<double>
  element_forces_at_rest(Solid &solid);
} // namespace wheelrail
