#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <wheelrail/statics/iterative_coarse_solver.h>

#include <ml_MultiLevelPreconditioner.h>

#include <algorithm>
#include <array>
#include <cmath>

// Coarse solver where exact factors would take a gigabyte: conjugate gradients after ML's smoothed
// aggregation (doc/theory/rolling.md, Static start, 4).

namespace wheelrail
{
  namespace
  {
    using Vector = dealii::TrilinosWrappers::MPI::Vector;

    // Steps of conjugate gradients: one cycle of ML alone leaves nine tenths of the bending of a rail or a
    // wheel disc, and all finer levels wait for it.
    constexpr unsigned int most_steps = 10;
    constexpr double       tolerance  = 0.2;
    constexpr unsigned int patience   = 3; // of solutions that leave more than they began with

    /// Norm (Frobenius) of a - factor x b.
    double
    distance(const SpringBlocks &a, const SpringBlocks &b, const double factor)
    {
      // both lists may have pairs that the other one lacks: those count whole
      double square = 0;
      for (const auto &[pair, block] : a)
        {
          const auto other = b.find(pair);
          for (int k = 0; k < 9; ++k)
            // relative change of the springs' matrix: a preconditioner that knows 70 % of them will do
            square += std::pow(block[k] - (other == b.end() ? 0 : factor * other->second[k]), 2);
        }
      for (const auto &[pair, block] : b)
        if (a.count(pair) == 0)
          for (const double value : block)
            square += std::pow(factor * value, 2);
      return std::sqrt(square);
    }
  } // namespace


  struct IterativeCoarseSolver::Matrix
  {
    dealii::IndexSet                                           owned;
    dealii::AffineConstraints<double>                          held;
    std::vector<dealii::FullMatrix<double>>                    elements;
    dealii::TrilinosWrappers::SparseMatrix                     matrix;
    std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> preconditioner;
    std::vector<double>                                        modes;   ///< ML keeps a pointer to them
    SpringBlocks                                               springs; ///< that the preconditioner knows
    Vector                                                     in, out;
  };


  IterativeCoarseSolver::IterativeCoarseSolver(const LocalMesh                  &mesh,
                                               const PerBody<ElementBlocks>     &blocks,
                                               const std::vector<unsigned char> &held,
                                               AlignedVector<double>             ground,
                                               MPI_Comm                          communicator)
    : mesh_(mesh)
    , ground_(std::move(ground))
    , communicator_(communicator)
    , matrix_(std::make_unique<Matrix>())
  {
    Matrix &m = *matrix_;
    // 1. Unknowns: three components a node, numbers ascending with the ranks
    m.owned.set_size(3 * dealii::Utilities::MPI::sum(mesh.n_owned, communicator));
    if (mesh.n_owned > 0)
      m.owned.add_range(dof(0, 0), dof(0, 0) + 3 * mesh.n_owned);
    m.in.reinit(m.owned, communicator);
    m.out.reinit(m.owned, communicator);
    // 2. Stiffness of each coarse element at rest, 24 x 24 [N/m]; it does not change, only springs do
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      {
        std::array<Vector3, 8> X;
        for (int a = 0; a < 8; ++a)
          for (int i = 0; i < 3; ++i)
            X[a][i] = mesh.reference[4 * mesh.cells[c][a] + i];
        const ElementBlocks &body = blocks[mesh.cell_body[c]];
        m.elements.emplace_back(
          24, 24, element_stiffness(element_geometry(X), body.elasticity(), body.form).data());
      }
    // 3. Nodes that do not move: their rows and columns become those of the unit matrix
    for (unsigned int n = 0; n < mesh.n_nodes(); ++n)
      for (int i = 0; i < 3 && held[n]; ++i)
        m.held.add_line(dof(n, i));
    m.held.close();
    make_modes();
  }


  IterativeCoarseSolver::~IterativeCoarseSolver() = default;


  /// The six rigid motions of both bodies together: smoothed aggregation must know them.
  void
  IterativeCoarseSolver::make_modes()
  {
    // Vectors without strain energy (near null space). Smoothed aggregation (Vanek, Mandel and Brezina 1996)
    // builds its coarse trial functions from them: without rotations each aggregate would resist turning, and
    // the bending of rail and disc would converge slowly.
    Matrix           &m      = *matrix_;
    const std::size_t n_rows = m.owned.n_elements();
    m.modes.assign(6 * n_rows, 0.);
    for (unsigned int n = 0; n < mesh_.n_owned; ++n)
      for (int i = 0; i < 3; ++i)
        {
          const double *X = &mesh_.reference[4 * n];
          const int     j = (i + 1) % 3, k = (i + 2) % 3;
          // translation along i: u = e_i
          m.modes[i * n_rows + 3 * n + i] = 1;
          // rotation about i: u = e_i x X
          m.modes[(3 + i) * n_rows + 3 * n + j] = -X[k];
          m.modes[(3 + i) * n_rows + 3 * n + k] = X[j];
        }
  }


  std::vector<std::uint32_t>
  IterativeCoarseSolver::unknowns(const std::array<unsigned int, 8> &cell) const
  {
    std::vector<std::uint32_t> all;
    for (const unsigned int n : cell)
      for (int i = 0; i < 3; ++i)
        all.push_back(dof(n, i));
    return all;
  }


  void
  IterativeCoarseSolver::set_springs(const StaticSprings &springs)
  {
    Matrix      &m      = *matrix_;
    SpringBlocks blocks = spring_blocks(springs);
    if (m.preconditioner && distance(blocks, m.springs, 1) < 0.3 * distance(blocks, m.springs, 0))
      return;
    // springs that differ by less than 30 % leave the matrix as it is: it only preconditions
    m.springs = std::move(blocks);
    m.preconditioner.reset();
    m.matrix.reinit(m.owned, m.owned, pattern(), communicator_);
    assemble();
    make_preconditioner();
  }


  dealii::DynamicSparsityPattern
  IterativeCoarseSolver::pattern() const
  {
    // couplings of the elements and, 3 x 3, of each pair of nodes that a spring joins
    const Matrix                  &m = *matrix_;
    dealii::DynamicSparsityPattern pattern(m.owned.size(), m.owned.size());
    for (const auto &cell : mesh_.cells)
      m.held.add_entries_local_to_global(unknowns(cell), pattern, false);
    for (const auto &[pair, block] : m.springs)
      // each rank adds the rows that it owns
      if (m.owned.is_element(3 * pair.first))
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            pattern.add(3 * pair.first + i, 3 * pair.second + j);
    dealii::IndexSet relevant = m.owned;
    for (unsigned int n = 0; n < mesh_.n_nodes(); ++n)
      relevant.add_range(dof(n, 0), dof(n, 0) + 3);
    dealii::SparsityTools::distribute_sparsity_pattern(pattern, m.owned, communicator_, relevant);
    return pattern;
  }


  void
  IterativeCoarseSolver::assemble()
  {
    Matrix &m = *matrix_;
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c)
      m.held.distribute_local_to_global(m.elements[c], unknowns(mesh_.cells[c]), m.matrix);
    for (std::size_t k = 0; k < ground_.size() && k < 4 * mesh_.n_owned; ++k)
      if (ground_[k] > 0)
        m.matrix.add(dof(k / 4, k % 4), dof(k / 4, k % 4), ground_[k]);
    for (const auto &[pair, block] : m.springs)
      if (m.owned.is_element(3 * pair.first))
        for (int i = 0; i < 3; ++i)
          {
            const dealii::types::global_dof_index columns[3] = {
              3 * pair.second, 3 * pair.second + 1, 3 * pair.second + 2};
            m.matrix.add(3 * pair.first + i, 3, columns, &block[3 * i], false, false);
          }
    // entries for rows of other ranks are sent and added
    m.matrix.compress(dealii::VectorOperation::add);
  }


  void
  IterativeCoarseSolver::make_preconditioner()
  {
    Matrix                &m = *matrix_;
    Teuchos::ParameterList list;
    ML_Epetra::SetDefaults("SA", list);
    // A node's three unknowns stay in one aggregate, and all couplings count as strong (threshold 0): flat
    // cells have weak ones across, which bending needs.
    list.set("ML output", 0);
    list.set("PDE equations", 3);
    list.set("aggregation: type", "Uncoupled");
    list.set("aggregation: threshold", 0.);
    // On flat cells whose Poisson's ratio is high the incomplete factors need not be definite: 144 thousand
    // unknowns were not solved in 150 steps. Elsewhere they take half of Chebyshev's time.
    if (failures_ < patience)
      {
        list.set("smoother: type", "IFPACK");
        list.set("smoother: ifpack type", "ILU");
        list.set("smoother: sweeps", 1);
      }
    else
      {
        list.set("smoother: type", "Chebyshev");
        list.set("smoother: sweeps", 4);
      }
    // W cycle: coarser levels are visited twice
    list.set("prec type", "MGW"); // nearly all of the work is on its finest level
    // the smallest system is factored
    list.set("coarse: type", "Amesos-KLU");
    // the six rigid motions of make_modes()
    list.set("null space: type", "pre-computed");
    list.set("null space: dimension", 6);
    list.set("null space: vectors", m.modes.data());
    m.preconditioner = std::make_unique<dealii::TrilinosWrappers::PreconditionAMG>();
    m.preconditioner->initialize(m.matrix, list);
  }


  void
  IterativeCoarseSolver::conjugate_gradients()
  {
    Matrix &m = *matrix_;
    // solved for K z = f [N] to z [m] from zero, so that the solution depends on the forces alone
    const double norm = m.in.l2_norm();
    m.out             = m.in;
    if (!std::isfinite(norm)) // it is for the caller to notice
      return;
    // ten steps at most, or a fifth of the residual: a rough solution that is not linear in the forces, so
    // that the outer conjugate gradients are flexible ones
    dealii::IterationNumberControl control(most_steps, tolerance * norm);
    dealii::SolverCG<Vector>       cg(control);
    m.out     = 0;
    bool lost = false;
    try
      {
        cg.solve(m.matrix, m.out, m.in, *m.preconditioner);
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        lost = true; // a residual that is no number: incomplete factors without a pivot
      }
    if (lost && failures_ >= patience)
      std::fill(m.out.begin(), m.out.end(), std::nan("")); // it is for the caller to notice
    // a third failure in all, or a residual that is no number: Chebyshev's polynomial smooths from now on,
    // and this solution is done again
    else if (lost || (!(control.last_value() <= norm) && failures_ + 1 == patience))
      {
        failures_ = patience;
        m.preconditioner.reset();
        make_preconditioner();
        conjugate_gradients();
      }
    else if (!(control.last_value() <= norm))
      ++failures_;
  }


  void
  IterativeCoarseSolver::solve(const NodeVector &forces, NodeVector &z)
  {
    Matrix &m = *matrix_;
    for (unsigned int n = 0; n < mesh_.n_owned; ++n)
      std::copy_n(forces.begin() + 4 * n, 3, m.in.begin() + 3 * n);
    conjugate_gradients();
    for (unsigned int n = 0; n < mesh_.n_owned; ++n)
      std::copy_n(m.out.begin() + 3 * n, 3, z.begin() + 4 * n);
  }
} // namespace wheelrail
