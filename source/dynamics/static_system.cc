#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include <ml_MultiLevelPreconditioner.h>

#include <wheelrail/base/errors.h>
#include <wheelrail/dynamics/static_system.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace wheelrail
{
  namespace
  {
    /// Room for springs between the rail nodes of the window and the wheel nodes that face them, as
    /// far as surface filter and facets reach.
    void
    add_contact_pairs(dealii::DynamicSparsityPattern &pattern,
                      const dealii::IndexSet         &owned,
                      const Contact                  &contact)
    {
      const Lattice &lattice = contact.lattice();
      const auto    &window  = contact.window();
      // a facet up to two cells away from its rail node, and the filter one more on both sides
      const bool filtered = contact.law().filter.rail.normal != 0 || contact.law().filter.wheel.normal != 0;
      const int  reach    = filtered ? 4 : 2;
      const auto couple   = [&](const unsigned int a, const unsigned int b) {
        if (owned.is_element(3 * a))
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              pattern.add(3 * a + i, 3 * b + j);
      };
      const int last_i = lattice.n_along - 1, last_j = lattice.n_lateral - 1;
      for (int i = std::min(window.rail.first, window.wheel.first);
           i < std::max(window.rail.last, window.wheel.last);
           ++i)
        for (int j = 0; j <= last_j; ++j)
          {
            const std::size_t  here  = lattice.index(i, j);
            const unsigned int rail  = contact.rail().global_node[here];
            const unsigned int wheel = contact.wheel().global_node[here];
            for (int k = std::max(i - reach, 0); k <= std::min(i + reach, last_i); ++k)
              for (int l = std::max(j - reach, 0); l <= std::min(j + reach, last_j); ++l)
                {
                  const std::size_t  there = lattice.index(k, l);
                  const int          away  = std::max(std::abs(k - i), std::abs(l - j));
                  const unsigned int other = contact.wheel().global_node[there];
                  couple(rail, other);
                  couple(other, rail);
                  // nodes of one body are coupled through the spring they share
                  if (away < 4)
                    couple(wheel, other);
                  if (filtered && away < 3)
                    couple(rail, contact.rail().global_node[there]);
                }
          }
    }
  } // namespace


  StaticSystem::StaticSystem(const Forest &forest, const Solid &solid, const Contact &contact)
    : forest_(forest)
    , owned_(forest.dofs().locally_owned_dofs())
  {
    make_constraints();
    assemble(solid, contact);
  }


  StaticSystem::Vector
  StaticSystem::owned_vector() const
  {
    return Vector(owned_, forest_.communicator());
  }


  StaticSystem::Vector
  StaticSystem::to_dofs(const LocalMesh &mesh, const AlignedVector<double> &nodal) const
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


  void
  StaticSystem::add_to_nodes(const LocalMesh       &mesh,
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


  double
  StaticSystem::bore_force(const LocalMesh &mesh, const AlignedVector<double> &nodal) const
  {
    double sum = 0;
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      {
        const auto dof = 3 * mesh.global_node[n] + 1;
        if (owned_.is_element(dof) && constraints_.is_inhomogeneously_constrained(dof))
          sum += nodal[4 * n + 1];
      }
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, forest_.communicator());
    return sum;
  }


  void
  StaticSystem::load_springs(const std::vector<Contact::Spring> &springs)
  {
    loaded_.copy_from(stiffness_);
    std::vector<dealii::types::global_dof_index> columns;
    std::vector<double>                          pull, row;
    for (const auto &spring : springs)
      {
        columns.clear();
        pull.clear();
        for (const auto &[node, weight] : spring.nodes)
          for (unsigned int i = 0; i < 3; ++i)
            {
              columns.push_back(3 * node + i);
              pull.push_back(weight * spring.normal[i]);
            }
        row.resize(pull.size());
        for (std::size_t a = 0; a < columns.size(); ++a)
          if (owned_.is_element(columns[a]))
            {
              for (std::size_t b = 0; b < pull.size(); ++b)
                row[b] = spring.stiffness * pull[a] * pull[b];
              loaded_.add(columns[a], columns.size(), columns.data(), row.data(), false, false);
            }
      }
    loaded_.compress(dealii::VectorOperation::add);
  }


  unsigned int
  StaticSystem::solve(const Vector &rhs, Vector &x, const double tolerance) const
  {
    dealii::SolverControl    control(2000, tolerance * rhs.l2_norm() + 1e-300);
    dealii::SolverCG<Vector> cg(control);
    try
      {
        cg.solve(loaded_, x, rhs, preconditioner_);
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        throw RunError("the static start did not converge: conjugate gradients stopped after " +
                       std::to_string(control.last_step()) +
                       " steps; lower Contact/Penalty scale, or take smaller coarse cells");
      }
    return control.last_step();
  }


  void
  StaticSystem::make_preconditioner(const LocalMesh &mesh)
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


  unsigned int
  StaticSystem::solve_lift(const LocalMesh &mesh, Vector &x, const double tolerance) const
  {
    Vector rigid = owned_vector();
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      {
        const auto dof = 3 * mesh.global_node[n] + 1;
        if (owned_.is_element(dof) && mesh.node_body[n] == Body::wheel && !constraints_.is_constrained(dof))
          rigid(dof) = 1;
      }
    rigid.compress(dealii::VectorOperation::insert);
    Vector load = owned_vector();
    loaded_.vmult(load, rigid);
    load.sadd(-1, lift_load_);
    x -= rigid;
    const unsigned int steps = solve(load, x, tolerance);
    x += rigid;
    return steps;
  }


  double
  StaticSystem::vertical_change(const std::vector<Contact::Spring> &springs, const Vector &increment) const
  {
    double change = 0;
    for (const auto &spring : springs)
      {
        double closing = 0;
        for (const auto &[node, weight] : spring.nodes)
          if (owned_.is_element(3 * node))
            for (unsigned int i = 0; i < 3; ++i)
              closing += weight * spring.normal[i] * increment(3 * node + i);
        change += spring.stiffness * closing * spring.normal[1];
      }
    MPI_Allreduce(MPI_IN_PLACE, &change, 1, MPI_DOUBLE, MPI_SUM, forest_.communicator());
    return change;
  }


  void
  StaticSystem::make_constraints()
  {
    constraints_.reinit(forest_.relevant_dofs());
    constraints_.merge(forest_.constraints(), dealii::AffineConstraints<double>::no_conflicts_allowed, true);
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
  StaticSystem::assemble(const Solid &solid, const Contact &contact)
  {
    dealii::DynamicSparsityPattern pattern(forest_.relevant_dofs());
    dealii::DoFTools::make_sparsity_pattern(forest_.dofs(), pattern, constraints_, false);
    dealii::SparsityTools::distribute_sparsity_pattern(
      pattern, owned_, forest_.communicator(), forest_.relevant_dofs());
    add_contact_pairs(pattern, owned_, contact);
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
          const auto &blocks = solid.blocks[solid.mesh.cell_body[c]];
          const auto  k      = element_stiffness(element_geometry(X), blocks.elasticity(), blocks.form);
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
} // namespace wheelrail
