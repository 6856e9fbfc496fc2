#include <wheelrail/statics/joined_solver.h>

namespace wheelrail
{
  JoinedSolver::JoinedSolver(std::unique_ptr<SweptSolver> body,
                             std::vector<JoinedRows>      terms,
                             const std::size_t            size)
    : body_(std::move(body))
    , terms_(std::move(terms))
    , inverse_(terms_.size(), terms_.size())
  {
    for (const JoinedRows &term : terms_)
      {
        std::vector<double> &response = responses_.emplace_back(size, 0.);
        for (const auto &[row, weight] : term.weights)
          response[row] += weight;
        body_->solve(response);
      }
    for (std::size_t a = 0; a < terms_.size(); ++a)
      {
        for (std::size_t b = 0; b < terms_.size(); ++b)
          inverse_(a, b) = stretch(a, responses_[b]);
        inverse_(a, a) += 1 / terms_[a].stiffness;
      }
    inverse_.gauss_jordan();
  }


  /// A row of B times x.
  double
  JoinedSolver::stretch(const std::size_t term, const std::vector<double> &x) const
  {
    double sum = 0;
    for (const auto &[row, weight] : terms_[term].weights)
      sum += weight * x[row];
    return sum;
  }


  void
  JoinedSolver::solve(std::vector<double> &x)
  {
    body_->solve(x);
    std::vector<double> stretches;
    for (std::size_t k = 0; k < terms_.size(); ++k)
      stretches.push_back(stretch(k, x));
    for (std::size_t a = 0; a < terms_.size(); ++a)
      {
        double force = 0;
        for (std::size_t b = 0; b < terms_.size(); ++b)
          force += inverse_(a, b) * stretches[b];
        for (std::size_t row = 0; row < x.size(); ++row)
          x[row] -= force * responses_[a][row];
      }
  }
} // namespace wheelrail
