#pragma once

#include <limits>

namespace wheelrail
{
  /// Whether the steps to an equilibrium still lead somewhere. A search that turns in circles, or that met a
  /// value that is not finite, would go on for all its steps.
  class StaticProgress
  {
  public:
    /// Steps in a row that may bring nothing.
    static constexpr int patience = 10;

    /// Takes what is out of balance after a step. True when for `patience` steps it has not fallen by a tenth
    /// below the least one before.
    bool
    stuck(const double norm)
    {
      if (norm <= 0.9 * least_)
        {
          least_ = norm;
          vain_  = 0;
        }
      else
        ++vain_;
      return vain_ >= patience;
    }

  private:
    double least_ = std::numeric_limits<double>::max();
    int    vain_  = 0;
  };
} // namespace wheelrail
