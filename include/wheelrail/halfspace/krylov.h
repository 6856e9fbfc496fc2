#pragma once

#include <functional>
#include <vector>

namespace wheelrail
{
  using LinearMap = std::function<void(const std::vector<double> &, std::vector<double> &)>;

  /// Solves A x = b from x = 0 by GMRES with the right preconditioner M (both maps: result = map(argument)),
  /// without restart (Saad and Schultz 1986). Stops when |b - A x| <= tolerance |b| or after max_iterations
  /// products. Returns the number of products.
  int
  solve_gmres(const LinearMap           &A,
              const LinearMap           &M,
              const std::vector<double> &b,
              double                     tolerance,
              int                        max_iterations,
              std::vector<double>       &x);
} // namespace wheelrail
