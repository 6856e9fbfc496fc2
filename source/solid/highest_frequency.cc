#include <deal.II/lac/tridiagonal_matrix.h>

#include <wheelrail/solid/highest_frequency.h>
#include <wheelrail/solid/law_scope.h>

#include <cmath>
#include <vector>

// Highest omega^2 of a whole mesh. The bound of the elements is exact for endless meshes, not at free edges:
// a free block of cubes swings 1.028 times as fast (doc/theory/verification.md, Stable step).

namespace wheelrail
{
  namespace
  {
    /// M^-1/2 K M^-1/2 on the nodes of all ranks, in displacements small enough for linearity.
    class ScaledStiffness
    {
    public:
      ScaledStiffness(Solid &solid, MPI_Comm communicator)
        : solid_(solid)
        , communicator_(communicator)
        , displacement_(4 * solid.mesh.n_nodes(), 0.)
        , rail_(solid.blocks.rail)
        , wheel_(solid.blocks.wheel)
      {
      }

      void
      apply(const AlignedVector<double> &x, AlignedVector<double> &y)
      {
        // strains of about small x / (sqrt(mass) h) < 1e-5 for cells h of steel from 0.1 mm on: Green's
        // strain is linear, and far from round-off
        constexpr double small = 1e-9;
        for (std::size_t n = 0; n < solid_.mass.size(); ++n)
          for (int i = 0; i < 3; ++i)
            displacement_[4 * n + i] =
              // u = M^-1/2 x; eigenvalues of M^-1/2 K M^-1/2 are omega^2, K from the kernel's own forces
              solid_.mass[n] > 0 ? small * x[4 * n + i] / std::sqrt(solid_.mass[n]) : 0.;
        // hanging nodes follow, their forces go to the parents: K of the nodes that move
        distribute(solid_.mesh, displacement_.data());
        // y = M^-1/2 K M^-1/2 x; the kernel subtracts, hence the sign below
        y.assign(4 * solid_.mass.size(), 0.);
        ElementEnergy ignored;
        subtract_internal_force(
          solid_.blocks, displacement_.data(), y.data(), BulkViscosity(), false, ignored);
        condense(solid_.mesh, y.data());
        sum_over_ranks(solid_.mesh, y.data());
        for (std::size_t n = 0; n < solid_.mass.size(); ++n)
          for (int i = 0; i < 3; ++i)
            y[4 * n + i] = solid_.mass[n] > 0 ? -y[4 * n + i] / (small * std::sqrt(solid_.mass[n])) : 0.;
      }

      double
      dot(const AlignedVector<double> &a, const AlignedVector<double> &b) const
      {
        // a dot b over all ranks, of four numbers a node the first three
        double sum = 0;
        for (std::size_t n = 0; n < solid_.mass.size(); ++n)
          // each node once, on the rank that owns it
          if (solid_.mesh.owns(n))
            for (int i = 0; i < 3; ++i)
              sum += a[4 * n + i] * b[4 * n + i];
        MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_DOUBLE, MPI_SUM, communicator_);
        return sum;
      }

      /// A start with all wave lengths, the same on every partition; zero at hanging nodes.
      AlignedVector<double>
      start() const
      {
        AlignedVector<double> x(4 * solid_.mass.size(), 0.);
        for (std::size_t n = 0; n < solid_.mass.size(); ++n)
          if (solid_.mass[n] > 0)
            for (int i = 0; i < 3; ++i)
              x[4 * n + i] = solid_.mesh.noise(n, i);
        return x;
      }

    private:
      Solid                &solid_;
      MPI_Comm              communicator_;
      AlignedVector<double> displacement_;
      const ElasticScope    rail_, wheel_; ///< trial vectors are no steps in time
    };
  } // namespace


  double
  highest_frequency(Solid &solid, MPI_Comm communicator, const int steps)
  {
    ScaledStiffness       K(solid, communicator);
    AlignedVector<double> v = K.start(), before(v.size(), 0.), w;
    // Lost orthogonality of the Lanczos vectors gives copies of eigenvalues already found, which do not
    // change the largest one: no vector but the last two is kept.
    std::vector<double> diagonal, off_diagonal;
    double              beta = std::sqrt(K.dot(v, v));
    for (int step = 0; step < steps && beta > 0; ++step)
      {
        for (double &value : v)
          value /= beta;
        // Lanczos (1950): beta v_next = K v - alpha v - beta v_before. The largest Ritz value of the
        // tridiagonal matrix comes to omega^2 from below.
        K.apply(v, w);
        // alpha_k and beta_k: diagonal and off-diagonal of the tridiagonal matrix
        const double alpha = K.dot(w, v);
        for (std::size_t k = 0; k < w.size(); ++k)
          w[k] -= alpha * v[k] + (step > 0 ? beta : 0.) * before[k];
        diagonal.push_back(alpha);
        before = v;
        // beta v_next; divided by beta at the next step
        v    = w;
        beta = std::sqrt(K.dot(v, v));
        if (beta <= 1e-12 * std::abs(alpha)) // round-off alone is left: the Ritz values are exact
          break;
        off_diagonal.push_back(beta);
      }
    // Ritz values: eigenvalues of the tridiagonal matrix
    dealii::TridiagonalMatrix<double> ritz(diagonal.size(), true);
    for (unsigned int k = 0; k < diagonal.size(); ++k)
      {
        ritz(k, k) = diagonal[k];
        if (k + 1 < diagonal.size())
          ritz(k, k + 1) = off_diagonal[k];
      }
    ritz.compute_eigenvalues();
    return ritz.eigenvalue(ritz.n() - 1);
  }


  void
  lower_stable_step(Solid &solid, const double bulk_viscosity, MPI_Comm communicator)
  {
    // only ever lowered: where the mesh is slower than its elements, their bound stays
    const double step = stable_step(highest_frequency(solid, communicator), bulk_viscosity);
    if (step < solid.stable.step)
      {
        solid.stable.step             = step;
        solid.stable.lowered_by_edges = true;
      }
  }


  void
  lower_stable_step(Solid &solid, const SceneParts &parts)
  {
    double added = 0;
    for (const auto &part : parts)
      // omega^2 of the whole is at most the sum of that of the bodies and those of the parts
      added += part->squared_frequency(solid);
    // springs and masses of parts stand on the same nodes: energies and inertias add up, and the quotient of
    // sums is no larger than the sum of the quotients
    const double bodies = 2 / solid.stable.step; // with their viscosity
    if (added > 0)
      {
        // omega^2 <= omega_bodies^2 + omega_parts^2, parts without viscosity (doc/theory/rolling.md, Time
        // stepping)
        solid.stable.step     = 2 / std::sqrt(bodies * bodies + added);
        solid.stable.of_parts = 1 - 0.5 * bodies * solid.stable.step;
      }
  }
} // namespace wheelrail
