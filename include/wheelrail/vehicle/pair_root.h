#pragma once

#include <array>
#include <functional>
#include <optional>

namespace wheelrail
{
  /// Two numbers that belong together: unknowns, or what is left over of two balances.
  using Pair = std::array<double, 2>;

  /// The larger magnitude of both.
  double
  larger_magnitude(const Pair &a);

  /// Two functions of two unknowns, or nothing where they have no value.
  using PairFunction = std::function<std::optional<Pair>(const Pair &)>;

  /// How a root of two functions is sought.
  struct PairSearch
  {
    Pair   step{};         ///< of the differences for the derivatives
    Pair   longest{};      ///< step from one place to the next
    double enough     = 0; ///< magnitude of both functions
    int    most_calls = 30;
  };

  /// Derivatives: of each function by both unknowns.
  using PairSlope = std::array<Pair, 2>;

  struct PairRoot
  {
    Pair                     at{};   ///< the best place that was tried
    Pair                     left{}; ///< the functions there
    std::optional<PairSlope> slope;  ///< as known there
    bool                     found = false;
    int                      calls = 0;
  };

  /// Seeks the root of two functions from `first.at` on, by Newton's method with derivatives by
  /// differences of `cheap`, a coarser form of the functions, or else of the functions themselves, mended by
  /// Broyden's formula (1965) after each step, or with those of `first` to begin with; a step that makes both
  /// larger is halved. Returns nothing where the functions have no value at the first guess.
  std::optional<PairRoot>
  find_pair_root(const PairRoot     &first,
                 const PairSearch   &search,
                 const PairFunction &function,
                 const PairFunction &cheap = {});
} // namespace wheelrail
