#pragma once

#include <deal.II/lac/full_matrix.h>

#include <wheelrail/statics/swept_solver.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace wheelrail
{
  /// A term stiffness x weights x weights^T of a matrix, by the rows of its weights.
  struct JoinedRows
  {
    double                                      stiffness; ///< may be negative, not zero
    std::vector<std::pair<std::size_t, double>> weights;
  };

  /// A body K with terms B^T C B of low rank, solved for exactly (Sherman, Morrison, Woodbury):
  ///
  ///     x = y - K^-1 B^T (C^-1 + B K^-1 B^T)^-1 B y,        y = K^-1 f.
  class JoinedSolver : public SweptSolver
  {
  public:
    /// `size`: of the vectors. Solves once for each term.
    JoinedSolver(std::unique_ptr<SweptSolver> body, std::vector<JoinedRows> terms, std::size_t size);

    void
    solve(std::vector<double> &x) override;

  private:
    double
    stretch(std::size_t term, const std::vector<double> &x) const;

    std::unique_ptr<SweptSolver>     body_;
    std::vector<JoinedRows>          terms_;
    std::vector<std::vector<double>> responses_; ///< K^-1 B^T, a column a term
    dealii::FullMatrix<double>       inverse_;   ///< (C^-1 + B K^-1 B^T)^-1
  };
} // namespace wheelrail
