#include <deal.II/lac/linear_operator.h>
#include <deal.II/lac/solver_cg.h>

#include <wheelrail/solid/law_scope.h>
#include <wheelrail/statics/static_level.h>

#include <algorithm>
#include <array>
#include <map>

// One level of the multigrid: K x from the kernel's own forces, and a smoother over the nodes' diagonal
// blocks D with the springs in full, (D + B'C B)^-1 = D^-1 - D^-1 B' (C^-1 + B D^-1 B')^-1 B D^-1 (Sherman,
// Morrison and Woodbury): springs ten times as stiff as a cell would slow down a smoother that has their
// diagonals alone.

namespace wheelrail
{
  namespace
  {
    constexpr int smoothing_steps = 2;

    /// Size of the displacement that the kernel sees, over that which is meant: squares of its gradients are
    /// lost against the gradients themselves.
    constexpr double tiny = 1e-12;

    using Symmetric = dealii::SymmetricTensor<2, 3>;

    Vector3
    times(const Symmetric &m, const double *x)
    {
      const dealii::Tensor<1, 3> y = m * dealii::Tensor<1, 3>({x[0], x[1], x[2]});
      return {y[0], y[1], y[2]};
    }

    /// A node of a cell, or a parent of one that hangs, with its weight in the cell's vertex.
    struct Share
    {
      unsigned int vertex, node;
      double       weight;
    };

    /// Adds the diagonal blocks of an element's stiffness to its nodes, hanging ones to their parents.
    void
    add_diagonal(const std::array<double, 24 * 24> &K,
                 const std::vector<Share>          &shares,
                 double                            *sum_a,
                 double                            *sum_b)
    {
      for (const Share &a : shares)
        for (const Share &b : shares)
          if (a.node == b.node)
            {
              // W' K W on a node, W the weights of parents of hanging nodes
              const double w = a.weight * b.weight;
              const auto   k = [&](const int i, const int j) {
                return w * K[24 * (3 * a.vertex + i) + 3 * b.vertex + j];
              };
              double *first = sum_a + 4 * a.node, *second = sum_b + 4 * a.node;
              first[0] += k(0, 0), first[1] += k(1, 1), first[2] += k(2, 2);
              // both orders of two vertices come, so that the sum is symmetric
              second[0] += k(1, 2), second[1] += k(0, 2), second[2] += k(0, 1);
            }
    }
  } // namespace


  StaticLevel::StaticLevel(const LocalMesh                  &mesh,
                           PerBody<ElementBlocks>           &blocks,
                           const std::vector<unsigned char> &held,
                           StaticGround                      ground,
                           MPI_Comm                          communicator)
    : mesh_(mesh)
    , blocks_(blocks)
    , held_(held)
    , ground_(std::move(ground))
    , communicator_(communicator)
    , tiny_(zero())
    , force_(zero())
    , step_(zero())
  {
    // K is never assembled: its nodes' 3 x 3 blocks and its largest eigenvalue are all that the smoother
    // needs
    make_diagonal();
    find_largest_eigenvalue();
  }


  void
  StaticLevel::set_springs(StaticSprings springs)
  {
    springs_ = std::move(springs);
    make_coupling();
  }


  /// -tiny x stiffness x x on the free nodes.
  void
  StaticLevel::find_elastic_force(const NodeVector &x)
  {
    tiny_.zero_out_ghost_values();
    // K x = -f(tiny x)/tiny: Green's strain has (H' H)/2 of relative size tiny; strains are exact to
    // round-off since H is never added to 1 in the elastic stress
    tiny_.equ(tiny, x);
    tiny_.update_ghost_values();
    distribute(mesh_, tiny_.begin());
    force_ = 0;
    {
      const ElasticScope rail(blocks_.rail), wheel(blocks_.wheel);
      ElementEnergy      ignored;
      subtract_internal_force(blocks_, tiny_.begin(), force_.begin(), BulkViscosity(), false, ignored);
    }
    condense(mesh_, force_.begin());
    force_.compress(dealii::VectorOperation::add);
    for (std::size_t n = 0; n < mesh_.n_owned; ++n)
      if (held_[n])
        std::fill_n(force_.begin() + 4 * n, 3, 0.);
    ++products;
  }


  void
  StaticLevel::elastic_product(const NodeVector &x, NodeVector &y)
  {
    find_elastic_force(x);
    // the kernel gives the force on the nodes, -K x
    y.equ(-1 / tiny, force_);
  }


  /// y += factor x ground x on the free nodes that the rank owns.
  void
  StaticLevel::add_ground(const double factor, const NodeVector &x, double *y) const
  {
    if (!ground_.springs.empty())
      for (std::size_t k = 0; k < 4 * mesh_.n_owned; ++k)
        if (!held_[k / 4])
          // diagonal ground springs of sleepers [N/m]
          y[k] += factor * ground_.springs[k] * x.begin()[k];
    ground_.joined.add_product(factor, x.begin(), y);
  }


  void
  StaticLevel::product(const NodeVector &x, NodeVector &y)
  {
    // K = bodies + ground + B' C B
    elastic_product(x, y);
    add_ground(1, x, y.begin());
    springs_.add_product(1, x.begin(), y.begin());
  }


  void
  StaticLevel::subtract_product(const NodeVector &x, NodeVector &residual)
  {
    find_elastic_force(x);
    residual.add(1 / tiny, force_);
    add_ground(-1, x, residual.begin());
    springs_.add_product(-1, x.begin(), residual.begin());
  }


  void
  StaticLevel::smooth(NodeVector &x, NodeVector &residual, const bool last_residual)
  {
    // k = 1 has no step before: d_1 = 4/(3 lambda_max) D^-1 r
    step_ = 0;
    for (int k = 1; k <= smoothing_steps; ++k)
      {
        // Chebyshev's polynomial of the fourth kind (Lottes 2023): d_k = (2k - 3)/(2k + 1) d_k-1 + (8k -
        // 4)/(2k + 1)/lambda_max D^-1 r_k. It asks for the largest eigenvalue alone.
        smoothing_step(residual, (2. * k - 3) / (2 * k + 1), (8. * k - 4) / (2 * k + 1) / largest_, step_, x);
        if (k < smoothing_steps || last_residual)
          subtract_product(step_, residual);
      }
  }


  void
  StaticLevel::make_diagonal()
  {
    constexpr unsigned int    no = ~0u;
    std::vector<unsigned int> hangs(mesh_.n_nodes(), no); // place in the list of hanging nodes
    for (unsigned int k = 0; k < mesh_.hanging.size(); ++k)
      hangs[mesh_.hanging[k]] = k;
    AlignedVector<double> sum_a(4 * mesh_.n_nodes(), 0.), sum_b(4 * mesh_.n_nodes(), 0.);
    std::vector<Share>    shares;
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c)
      {
        std::array<Vector3, 8> X;
        shares.clear();
        for (unsigned int v = 0; v < 8; ++v)
          {
            const unsigned int node = mesh_.cells[c][v];
            for (int i = 0; i < 3; ++i)
              X[v][i] = mesh_.reference[4 * node + i];
            // a hanging node has no equation of its own: its share of K goes to its parents
            const unsigned int k = hangs[node];
            if (k == no)
              shares.push_back({v, node, 1});
            else
              for (unsigned int p = mesh_.hanging_begin[k]; p < mesh_.hanging_begin[k + 1]; ++p)
                shares.push_back({v, mesh_.parents[p], mesh_.weights[p]});
          }
        const ElementBlocks &blocks = blocks_[mesh_.cell_body[c]];
        add_diagonal(element_stiffness(element_geometry(X), blocks.elasticity(), blocks.form),
                     shares,
                     sum_a.data(),
                     sum_b.data());
      }
    // a node on the border of ranks has elements on each
    for (auto *const sum : {&sum_a, &sum_b})
      sum_over_ranks(mesh_, sum->data());
    for (std::size_t k = 0; k < ground_.springs.size(); ++k)
      sum_a[k] += ground_.springs[k];
    inverse_.resize(mesh_.n_nodes());
    for (std::size_t n = 0; n < mesh_.n_nodes(); ++n)
      {
        const double *a = &sum_a[4 * n], *b = &sum_b[4 * n];
        const double  entries[6] = {a[0], a[1], a[2], b[2], b[1], b[0]};
        // order of deal.II: xx, yy, zz, xy, xz, yz
        const Symmetric block(entries);
        // zeros at hanging nodes
        inverse_[n] = !held_[n] && determinant(block) > 0 ? invert(block) : Symmetric();
      }
  }


  /// (C^-1 + B D^-1 B^T)^-1 B D^-1 residual: what the springs take of the smoother's step.
  std::vector<double>
  StaticLevel::spring_forces(const NodeVector &residual) const
  {
    // 1. B D^-1 r on each rank's nodes, summed; 2. the small system in the springs, a band where springs
    // share nodes, the same on all ranks
    std::vector<double> forces(springs_.size(), 0.);
    if (forces.empty())
      return forces;
    for (std::size_t k = 0; k < images_.size(); ++k)
      if (const unsigned int n = springs_.local_nodes()[k]; mesh_.owns(n))
        for (int i = 0; i < 3; ++i)
          // B D^-1 r
          forces[springs_.parts()[k].spring] += images_[k][i] * residual.begin()[4 * n + i];
    MPI_Allreduce(
      MPI_IN_PLACE, forces.data(), static_cast<int>(forces.size()), MPI_DOUBLE, MPI_SUM, communicator_);
    coupling_.solve(forces.data());
    return forces;
  }


  /// step = keep x step + take x z; x += step, with z = (D + B^T C B)^-1 residual
  /// = D^-1 residual - D^-1 B^T (C^-1 + B D^-1 B^T)^-1 B D^-1 residual.
  void
  StaticLevel::smoothing_step(const NodeVector &residual,
                              const double      keep,
                              const double      take,
                              NodeVector       &step,
                              NodeVector       &x) const
  {
    // 1. z = D^-1 r, block by block; 2. less what the springs hold back, at the nodes of springs alone
    const std::vector<double> forces = spring_forces(residual);
    const double             *r      = residual.begin();
    double                   *s = step.begin(), *to = x.begin();
    for (std::size_t n = 0; n < mesh_.n_owned; ++n)
      {
        const Vector3 z = times(inverse_[n], r + 4 * n);
        for (int i = 0; i < 3; ++i)
          {
            s[4 * n + i] = keep * s[4 * n + i] + take * z[i];
            to[4 * n + i] += s[4 * n + i];
          }
      }
    for (std::size_t k = 0; k < images_.size(); ++k)
      if (const unsigned int n = springs_.local_nodes()[k]; mesh_.owns(n))
        for (int i = 0; i < 3; ++i)
          {
            // D^-1 B' times the spring forces
            const double held_back = take * forces[springs_.parts()[k].spring] * images_[k][i];
            s[4 * n + i] -= held_back;
            to[4 * n + i] -= held_back;
          }
  }


  void
  StaticLevel::make_coupling()
  {
    const auto &parts = springs_.parts();
    coupling_         = BandCholesky<double>(springs_.size(), springs_.band());
    // D^-1 B' of each part of a spring [m], once for a set of springs
    images_.assign(parts.size(), Vector3{});
    std::map<unsigned int, std::vector<std::size_t>> at_node; // parts of the rank's own nodes
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (const unsigned int n = springs_.local_nodes()[k]; mesh_.owns(n))
        {
          // D^-1 B'
          images_[k] = times(inverse_[n], parts[k].weight.data());
          at_node[n].push_back(k);
        }
    for (const auto &at : at_node)
      for (const std::size_t a : at.second)
        for (const std::size_t b : at.second)
          if (parts[b].spring <= parts[a].spring)
            // B D^-1 B', lower half, in the band of springs that share a node
            coupling_(parts[a].spring, parts[b].spring) += dot(images_[a], parts[b].weight);
    MPI_Allreduce(MPI_IN_PLACE,
                  coupling_.data(),
                  static_cast<int>(coupling_.n_data()),
                  MPI_DOUBLE,
                  MPI_SUM,
                  communicator_);
    for (std::size_t k = 0; k < springs_.size(); ++k)
      // C^-1 + B D^-1 B' (Sherman, Morrison and Woodbury)
      coupling_(k, k) += 1 / springs_.stiffness()[k];
    coupling_.factorise();
  }


  /// Of the diagonal blocks' inverse times the stiffness, by Lanczos' method on a vector of noise. Springs do
  /// not raise it beyond one where they govern.
  void
  StaticLevel::find_largest_eigenvalue()
  {
    constexpr double margin = 1.1; // Lanczos comes from below
    // Conjugate gradients with D^-1 are Lanczos' method: the coefficients of n steps give a tridiagonal
    // matrix whose largest eigenvalue is a lower bound of that of D^-1 K. Noise has a share of all vectors.
    // Chebyshev's polynomial amplifies what lies beyond its bound.
    NodeVector noise = zero(), solution = zero(), step = zero();
    for (std::size_t n = 0; n < mesh_.n_owned; ++n)
      for (unsigned int i = 0; i < 3; ++i)
        if (inverse_[n][i][i] > 0)
          noise.begin()[4 * n + i] = mesh_.noise(n, i);
    dealii::LinearOperator<NodeVector> matrix, inverse;
    matrix.vmult  = [&](NodeVector &y, const NodeVector &x) { product(x, y); };
    inverse.vmult = [&](NodeVector &z, const NodeVector &r) {
      z = 0;
      smoothing_step(r, 0, 1, step, z);
    };
    // its tridiagonal matrix has one row less than steps are made
    dealii::IterationNumberControl            control(13, 0.);
    dealii::PrimitiveVectorMemory<NodeVector> memory; // others keep their vectors
    dealii::SolverCG<NodeVector>              lanczos(control, memory);
    lanczos.connect_eigenvalues_slot(
      [this](const std::vector<double> &all) { largest_ = margin * all.back(); });
    lanczos.solve(matrix, solution, noise, inverse);
  }
} // namespace wheelrail
