#pragma once

#include <deal.II/base/index_set.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <wheelrail/contact/contact.h>
#include <wheelrail/mesh/forest.h>
#include <wheelrail/solid/solid.h>

#include <vector>

namespace wheelrail
{
  /// The linear system of one static start: stiffness of both bodies at rest plus contact springs,
  /// feet and ends of the rail held, the bore of the wheel moved vertically as one.
  ///
  /// This header brings deal.II's linear algebra along: for the files of the static start only.
  class StaticSystem
  {
  public:
    using Vector = dealii::TrilinosWrappers::MPI::Vector;

    /// Assembles the stiffness, with room for the springs of the contact's window. Collective.
    StaticSystem(const Forest &forest, const Solid &solid, const Contact &contact);

    Vector
    owned_vector() const;

    /// Local nodal forces, already summed over ranks, as a right-hand side.
    Vector
    to_dofs(const LocalMesh &mesh, const AlignedVector<double> &nodal) const;

    /// Adds increment + constraints (bore raised by `lift` [m]) to the nodal values.
    void
    add_to_nodes(const LocalMesh       &mesh,
                 const Vector          &increment,
                 double                 lift,
                 AlignedVector<double> &nodal) const;

    /// Sum of the vertical nodal forces on the bore [N], from local forces summed over ranks. Collective.
    double
    bore_force(const LocalMesh &mesh, const AlignedVector<double> &nodal) const;

    /// Sets the matrix to the stiffness of both bodies plus the contact springs of the moment.
    void
    load_springs(const std::vector<Contact::Spring> &springs);

    /// Smoothed aggregation of the loaded matrix, with the six rigid motions as near null space.
    /// deal.II's own settings know translations only, which takes about ten times as many steps here.
    void
    make_preconditioner(const LocalMesh &mesh);

    /// One cycle of the preconditioner: z, about the increment under the forces.
    void
    precondition(const Vector &forces, Vector &z) const
    {
      preconditioner_.vmult(z, forces);
    }

    /// Solves with the loaded matrix to `tolerance` times the norm of the right-hand side; returns the
    /// CG steps. Throws RunError after 2000.
    unsigned int
    solve(const Vector &rhs, Vector &x, double tolerance) const;

    /// Increment x of the free unknowns when the bore is raised by 1 m: a rigid lift of the wheel, minus what
    /// the springs hold back, which is solved for to `tolerance` of its own load (the forces at the bore
    /// are 10^4 times as large and would hide it). Begins with the x given; returns the CG steps.
    unsigned int
    solve_lift(const LocalMesh &mesh, Vector &x, double tolerance) const;

    /// Vertical contact force on the wheel that the springs lose in an increment [N]. Collective.
    double
    vertical_change(const std::vector<Contact::Spring> &springs, const Vector &increment) const;

  private:
    void
    make_constraints();
    void
    assemble(const Solid &solid, const Contact &contact);

    const Forest                             &forest_;
    dealii::IndexSet                          owned_;
    dealii::AffineConstraints<double>         constraints_;
    dealii::TrilinosWrappers::SparseMatrix    stiffness_, loaded_;
    dealii::TrilinosWrappers::PreconditionAMG preconditioner_;
    Vector                                    lift_load_;
    std::vector<double>                       modes_; ///< ML keeps a pointer to them
  };
} // namespace wheelrail
