#include <wheelrail/base/interrupt.h>
#include <wheelrail/halfspace/krylov.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/vector.h>

#include <algorithm>

namespace wheelrail
{
  namespace
  {
    using Vector = dealii::Vector<double>;

    /// A map as deal.II's solvers call it.
    struct Applied
    {
      const LinearMap            &map;
      mutable std::vector<double> from, to;

      void
      vmult(Vector &result, const Vector &argument) const
      {
        leave_if_interrupted();
        from.assign(argument.begin(), argument.end());
        map(from, to);
        std::copy(to.begin(), to.end(), result.begin());
      }
    };
  } // namespace


  int
  solve_gmres(const LinearMap           &A,
              const LinearMap           &M,
              const std::vector<double> &b,
              const double               tolerance,
              const int                  max_iterations,
              std::vector<double>       &x)
  {
    // A x = b by GMRES (Saad and Schultz 1986), preconditioned from the right so that the residual is that of
    // A itself and the tolerance means the same whatever the preconditioner
    const Vector load(b.begin(), b.end());
    Vector       solution(load.size());
    const double norm = load.l2_norm();
    x.assign(b.size(), 0.);
    if (norm == 0)
      return 0;
    dealii::SolverControl control(max_iterations, tolerance * norm, false, false);
    // as many vectors as iterations: no restart
    dealii::SolverGMRES<Vector> solver(control,
                                       dealii::SolverGMRES<Vector>::AdditionalData(max_iterations + 2, true));
    try
      {
        solver.solve(Applied{A, {}, {}}, solution, load, Applied{M, {}, {}});
      }
    catch (const dealii::SolverControl::NoConvergence &) // Newton's next residual tells
      {
      }
    std::copy(solution.begin(), solution.end(), x.begin());
    return static_cast<int>(control.last_step());
  }
} // namespace wheelrail
