#include <deal.II/base/index_set.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>
#include <deal.II/numerics/vector_tools.h>

#include <ml_MultiLevelPreconditioner.h>

#include <wheelrail/base/errors.h>
#include <wheelrail/dynamics/start_tractions.h>
#include <wheelrail/dynamics/static_start.h>

#include <cmath>

namespace wheelrail
{
  namespace
  {
    using Vector = dealii::TrilinosWrappers::MPI::Vector;

    /// The linear system of one static start.
    class StaticSystem
    {
    public:
      StaticSystem(const Forest &forest, const Solid &solid, const Contact &contact)
        : forest_(forest)
        , owned_(forest.dofs().locally_owned_dofs())
      {
        make_constraints();
        assemble(solid, contact);
      }

      Vector
      owned_vector() const
      {
        return Vector(owned_, forest_.communicator());
      }

      /// Local nodal forces, already summed over ranks, as a right-hand side.
      Vector
      to_dofs(const LocalMesh &mesh, const AlignedVector<double> &nodal) const
      {
        Vector vector = owned_vector();
        for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
          {
            const auto dof = 3 * mesh.global_node[n];
            if (owned_.is_element(dof))
              for (unsigned int i = 0; i < 3; ++i)
                vector(dof + i) = constraints_.is_constrained(dof + i) ? 0. : nodal[4 * n + i];
          }
        vector.compress(dealii::VectorOperation::insert);
        return vector;
      }

      /// Adds factor x (increment + constraints, bore raised by `lift`) to the nodal values.
      void
      add_to_nodes(const LocalMesh       &mesh,
                   const Vector          &increment,
                   const double           lift,
                   AlignedVector<double> &nodal) const
      {
        Vector ghosted(owned_, forest_.relevant_dofs(), forest_.communicator());
        ghosted = increment;
        for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
          for (unsigned int i = 0; i < 3; ++i)
            {
              const auto dof = 3 * mesh.global_node[n] + i;
              if (!constraints_.is_constrained(dof))
                nodal[4 * n + i] += ghosted(dof);
              else if (constraints_.is_inhomogeneously_constrained(dof))
                nodal[4 * n + i] += lift;
            }
        distribute(mesh, nodal.data());
      }

      /// Sets the matrix to the stiffness of both bodies plus the contact springs of the moment.
      void
      load_springs(const Contact &contact, const std::vector<Contact::Spring> &springs)
      {
        loaded_.copy_from(stiffness_);
        for (const auto &spring : springs)
          {
            const std::array<unsigned int, 5> nodes = spring_nodes(contact, spring);
            const std::array<double, 5>       w     = {
                        1, -spring.weight[0], -spring.weight[1], -spring.weight[2], -spring.weight[3]};
            for (unsigned int a = 0; a < 5; ++a)
              if (owned_.is_element(3 * nodes[a]))
                for (unsigned int b = 0; b < 5; ++b)
                  for (unsigned int i = 0; i < 3; ++i)
                    for (unsigned int j = 0; j < 3; ++j)
                      loaded_.add(3 * nodes[a] + i,
                                  3 * nodes[b] + j,
                                  spring.stiffness * w[a] * w[b] * spring.normal[i] * spring.normal[j]);
          }
        loaded_.compress(dealii::VectorOperation::add);
      }

      /// Solves with the loaded matrix; returns the CG steps.
      unsigned int
      solve(const Vector &rhs, Vector &x, const double tolerance) const
      {
        dealii::SolverControl    control(2000, tolerance * rhs.l2_norm() + 1e-300);
        dealii::SolverCG<Vector> cg(control);
        try
          {
            cg.solve(loaded_, x, rhs, preconditioner_);
          }
        catch (const dealii::SolverControl::NoConvergence &)
          {
            throw RunError(
              "the static start did not converge: conjugate gradients stopped after 2000 steps; "
              "look at the mesh quality in the log, or lower Contact/Penalty scale");
          }
        return control.last_step();
      }

      /// Forces that hold the bodies when the bore is raised by 1 m.
      const Vector &
      lift_load() const
      {
        return lift_load_;
      }

    private:
      static std::array<unsigned int, 5>
      spring_nodes(const Contact &contact, const Contact::Spring &spring)
      {
        std::array<unsigned int, 5> nodes = {contact.rail().global_node[spring.rail]};
        for (unsigned int m = 0; m < 4; ++m)
          nodes[m + 1] = contact.wheel().global_node[spring.wheel[m]];
        return nodes;
      }

      /// Room for springs between each rail node of the window and the wheel nodes that face it.
      void
      add_contact_pairs(dealii::DynamicSparsityPattern &pattern, const Contact &contact) const
      {
        const Lattice &lattice = contact.lattice();
        const auto    &window  = contact.window();
        const auto     couple  = [&](const unsigned int a, const unsigned int b) {
          if (owned_.is_element(3 * a))
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int j = 0; j < 3; ++j)
                pattern.add(3 * a + i, 3 * b + j);
        };
        const auto pairs = [&](const int i, const int j, const auto &use) {
          for (int k = std::max(i - 2, 0); k <= std::min<int>(i + 2, lattice.n_along - 1); ++k)
            for (int l = std::max(j - 2, 0); l <= std::min<int>(j + 2, lattice.n_lateral - 1); ++l)
              use(contact.wheel().global_node[lattice.index(k, l)]);
        };
        for (int i = window.rail_first; i < window.rail_last; ++i)
          for (unsigned int j = 0; j < lattice.n_lateral; ++j)
            {
              const unsigned int rail = contact.rail().global_node[lattice.index(i, j)];
              pairs(i, j, [&](const unsigned int wheel) {
                couple(rail, wheel);
                couple(wheel, rail);
              });
              // wheel nodes of one facet are coupled through the rail node they share
              const unsigned int own = contact.wheel().global_node[lattice.index(i, j)];
              pairs(i, j, [&](const unsigned int wheel) { couple(own, wheel); });
            }
      }

      void
      make_constraints()
      {
        constraints_.reinit(forest_.relevant_dofs());
        constraints_.merge(
          forest_.constraints(), dealii::AffineConstraints<double>::no_conflicts_allowed, true);
        const dealii::Functions::ZeroFunction<3>     zero(3);
        const dealii::Functions::ConstantFunction<3> raised(std::vector<double>{0., 1., 0.});
        for (const Boundary mark : {Boundary::foot, Boundary::end})
          dealii::VectorTools::interpolate_boundary_values(
            forest_.dofs(), static_cast<unsigned int>(mark), zero, constraints_);
        dealii::VectorTools::interpolate_boundary_values(
          forest_.dofs(), static_cast<unsigned int>(Boundary::bore), raised, constraints_);
        constraints_.close();
      }

      void
      assemble(const Solid &solid, const Contact &contact)
      {
        dealii::DynamicSparsityPattern pattern(forest_.relevant_dofs());
        dealii::DoFTools::make_sparsity_pattern(forest_.dofs(), pattern, constraints_, false);
        dealii::SparsityTools::distribute_sparsity_pattern(
          pattern, owned_, forest_.communicator(), forest_.relevant_dofs());
        add_contact_pairs(pattern, contact);
        stiffness_.reinit(owned_, owned_, pattern, forest_.communicator());
        lift_load_ = owned_vector();

        dealii::FullMatrix<double>                   K(24, 24);
        dealii::Vector<double>                       zero(24);
        std::vector<dealii::types::global_dof_index> dofs(24);
        std::size_t                                  c = 0;
        for (const auto &cell : forest_.dofs().active_cell_iterators())
          if (cell->is_locally_owned())
            {
              std::array<Vector3, 8> X;
              for (int a = 0; a < 8; ++a)
                for (int i = 0; i < 3; ++i)
                  X[a][i] = solid.mesh.reference[4 * solid.mesh.cells[c][a] + i];
              const auto &blocks = solid.blocks[static_cast<int>(solid.mesh.cell_body[c])];
              const auto  k      = element_stiffness(element_geometry(X), blocks.material, blocks.form);
              K.fill(k.data());
              cell->get_dof_indices(dofs);
              constraints_.distribute_local_to_global(K, zero, dofs, stiffness_, lift_load_, true);
              ++c;
            }
        stiffness_.compress(dealii::VectorOperation::add);
        loaded_.reinit(stiffness_);
        lift_load_.compress(dealii::VectorOperation::add);
        // unknowns of the increments at constrained dofs stay zero
        for (const auto dof : owned_)
          if (constraints_.is_constrained(dof))
            lift_load_(dof) = 0;
        lift_load_.compress(dealii::VectorOperation::insert);
      }

      /// Smoothed aggregation of nodes with the six rigid motions as near null space. deal.II's own
      /// settings know translations only, which takes about ten times as many steps here.
    public:
      void
      make_preconditioner(const LocalMesh &mesh)
      {
        const std::size_t n_rows = owned_.n_elements();
        modes_.assign(6 * n_rows, 0.);
        for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
          {
            const auto dof = 3 * mesh.global_node[n];
            if (!owned_.is_element(dof))
              continue;
            const std::size_t row = owned_.index_within_set(dof);
            const double     *X   = &mesh.reference[4 * n];
            for (int i = 0; i < 3; ++i)
              {
                const int j = (i + 1) % 3, k = (i + 2) % 3;
                modes_[i * n_rows + row + i]       = 1;
                modes_[(3 + i) * n_rows + row + j] = -X[k];
                modes_[(3 + i) * n_rows + row + k] = X[j];
              }
          }
        Teuchos::ParameterList list;
        ML_Epetra::SetDefaults("SA", list);
        list.set("ML output", 0);
        list.set("PDE equations", 3);
        list.set("aggregation: type", "Uncoupled");
        list.set("aggregation: threshold", 0.);
        list.set("smoother: type", "Chebyshev");
        list.set("smoother: sweeps", 2);
        list.set("coarse: type", "Amesos-KLU");
        list.set("null space: type", "pre-computed");
        list.set("null space: dimension", 6);
        list.set("null space: vectors", modes_.data());
        preconditioner_.initialize(loaded_, list);
      }

    private:
      const Forest                             &forest_;
      dealii::IndexSet                          owned_;
      dealii::AffineConstraints<double>         constraints_;
      dealii::TrilinosWrappers::SparseMatrix    stiffness_, loaded_;
      dealii::TrilinosWrappers::PreconditionAMG preconditioner_;
      Vector                                    lift_load_;
      std::vector<double>                       modes_; ///< ML keeps a pointer to them
    };

    /// Weight and centrifugal load of the wheel, per node.
    void
    add_wheel_loads(const Solid &solid, const AxleData &axle, const double rate, AlignedVector<double> &force)
    {
      for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
        if (solid.mesh.node_body[n] == Body::wheel)
          {
            const double *X      = &solid.mesh.reference[4 * n];
            const Vector3 arm    = Vector3{X[0], X[1], X[2]} - axle.centre;
            const Vector3 radial = arm - dot(arm, axle.axis) * axle.axis;
            for (int i = 0; i < 3; ++i)
              force[4 * n + i] += solid.mass[n] * rate * rate * radial[i];
            force[4 * n + 1] -= solid.mass[n] * axle.gravity;
          }
    }

    /// Contact, internal and external forces of the present displacement, condensed and summed.
    AlignedVector<double>
    out_of_balance(Solid          &solid,
                   Contact        &contact,
                   SharedSum      &sum,
                   const AxleData &axle,
                   const double    rate,
                   ContactSums    &sums)
    {
      AlignedVector<double> force(solid.force.size(), 0.);
      ElementEnergy         ignored;
      for (auto &blocks : solid.blocks)
        subtract_internal_force(
          blocks, solid.displacement.data(), force.data(), BulkViscosity(), false, ignored);
      condense(solid.mesh, force.data());
      sum(force.data());
      add_wheel_loads(solid, axle, rate, force);
      contact.gather(solid.displacement.data(), solid.velocity.data());
      sums = contact.evaluate(0);
      contact.add_forces(force.data());
      return force;
    }

    /// Vertical contact force on the wheel that the springs lose in an increment.
    double
    vertical_change(const Contact                      &contact,
                    const std::vector<Contact::Spring> &springs,
                    const Vector                       &increment,
                    const dealii::IndexSet             &owned,
                    MPI_Comm                            communicator)
    {
      double change = 0;
      for (const auto &spring : springs)
        {
          double     opening  = 0;
          const auto add_node = [&](const Surface &surface, unsigned int k, double weight) {
            const auto d = 3 * surface.global_node[k];
            if (owned.is_element(d))
              for (unsigned int i = 0; i < 3; ++i)
                opening += weight * spring.normal[i] * increment(d + i);
          };
          add_node(contact.rail(), spring.rail, -1);
          for (int m = 0; m < 4; ++m)
            add_node(contact.wheel(), spring.wheel[m], spring.weight[m]);
          change -= spring.stiffness * opening * spring.normal[1];
        }
      MPI_Allreduce(MPI_IN_PLACE, &change, 1, MPI_DOUBLE, MPI_SUM, communicator);
      return change;
    }
  } // namespace


  StaticResult
  static_start(const Forest                           &forest,
               Solid                                  &solid,
               Contact                                &contact,
               const StaticLoads                      &loads,
               const std::function<void(std::string)> &report)
  {
    MPI_Comm     communicator = forest.communicator();
    SharedSum    sum(solid.mesh, communicator);
    StaticResult result;
    result.wheel_load = (loads.axle.sprung_mass + loads.axle.mass +
                         mass_properties(solid, Body::wheel, loads.axle.centre, communicator).mass) *
                        loads.axle.gravity;

    report("static start: assembling the stiffness");
    StaticSystem system(forest, solid, contact);
    const auto  &owned = forest.dofs().locally_owned_dofs();

    // begin with the bodies pressed into each other rigidly; the part of the undeformed profiles that
    // dips in by some 0.55 of the approach is close to the true patch
    Vector increment = system.owned_vector(), lifted = system.owned_vector();
    result.lift = -0.55 * loads.first_approach;
    for (unsigned int n = 0; n < solid.mesh.n_nodes(); ++n)
      if (solid.mesh.node_body[n] == Body::wheel)
        solid.displacement[4 * n + 1] = result.lift;

    std::vector<unsigned int> preconditioned; // rail nodes whose springs the preconditioner knows
    double                    rate    = loads.axle.velocity / loads.rolling_radius;
    bool                      sheared = frictionless(contact.law().friction);
    // the given tractions, set in every step: an iterate that unloads a node must not erase its own for good
    std::vector<Vector3> shear;
    for (int step = 0; step < 60; ++step)
      {
        for (std::size_t k = 0; k < shear.size(); ++k)
          contact.set_shear(k, shear[k]);
        ContactSums sums;
        auto        force = out_of_balance(solid, contact, sum, loads.axle, rate, sums);
        if (sums.nodes == 0)
          throw RunError(
            "the static start lost the contact between wheel and rail; give a smaller first approach");
        const Vector residual = system.to_dofs(solid.mesh, force);
        result.residual       = residual.linfty_norm() / result.wheel_load;
        result.contact_force  = sums.force;
        result.newton_steps   = step;
        const double missing  = result.wheel_load - sums.force[1];
        if (result.residual < 2e-6 && std::abs(missing) < 1e-5 * result.wheel_load)
          {
            if (sheared)
              break;
            // normal contact has settled: add the shear tractions and go on
            const double G = solid.blocks[0].material.shear_modulus();
            const auto   tractions =
              loads.rate_held ? start_tractions_at_creepage(contact, loads.creepage, G)
                                : start_tractions(contact, loads.traction_coefficient * result.wheel_load, G);
            shear           = tractions.shear;
            result.creepage = tractions.creepage;
            rate            = loads.axle.velocity / loads.rolling_radius * (1 + result.creepage);
            sheared         = true;
            continue;
          }
        if (step == 59)
          throw RunError("the static start did not converge: after 60 steps " + std::to_string(missing) +
                         " N of the wheel load are missing; lower Contact/Penalty scale or refine the mesh");

        const auto springs = contact.springs();
        system.load_springs(contact, springs);
        // a preconditioner of another patch costs three times the steps
        std::vector<unsigned int> active;
        for (const auto &spring : springs)
          active.push_back(spring.rail);
        const bool changed = active != preconditioned;
        if (changed)
          system.make_preconditioner(solid.mesh);
        preconditioned = active;
        increment      = 0;
        // Newton's steps need no more than they can use while the patch still changes
        result.cg_steps += system.solve(residual, increment, result.residual > 1e-3 ? 1e-2 : 1e-3);
        result.cg_steps += system.solve(system.lift_load(), lifted, 1e-2);
        // the lift that restores the vertical balance
        const double by_increment = vertical_change(contact, springs, increment, owned, communicator);
        const double by_lift      = vertical_change(contact, springs, lifted, owned, communicator);
        double       lift         = (missing - by_increment) / by_lift;
        increment.add(lift, lifted);
        // full steps can turn in circles between two patches, as in the flange root: shorter ones end that
        if (changed && step > 8)
          {
            const double part = std::max(0.15, 3. / (step - 5));
            increment *= part;
            lift *= part;
          }
        system.add_to_nodes(solid.mesh, increment, lift, solid.displacement);
        result.lift += lift;
      }
    if (frictionless(contact.law().friction))
      result.creepage = loads.rate_held ? loads.creepage : 0;
    return result;
  }
} // namespace wheelrail
