#include <wheelrail/halfspace/friction_system.h>

#include <algorithm>
#include <cmath>
#include <vector>

// The preconditioner of a Newton step (doc/theory/halfspace.md, Algorithms): the creepages are eliminated; in
// steady rolling the slip of elements that stick is summed against rolling, then A is inverted on the
// periodic grid by its symbol; elements that slip take their diagonal. Symbols: see friction_system.cc.

namespace wheelrail
{
  void
  FrictionSystem::set_responses()
  {
    // z = M^-1 (unit creepage): a unit slip in all rows that hold a slip, that is both of an element that
    // sticks and the one across n of one that slips
    // columns of the unknown creepages: a unit of creepage is a unit of slip in all rows
    response_.clear();
    for (const int d : forces)
      {
        std::vector<double> unit(2 * n_, 0.), z;
        for (std::size_t e = 0; e < n_; ++e)
          unit[2 * e + d] = 1;
        for (std::size_t e = 0; e < n_; ++e)
          if (slipping[e])
            {
              // along n the row holds no slip but that of a layer which hardens
              const double normal = b_ * rise_[e] * (unit[2 * e] * nx_[e] + unit[2 * e + 1] * ny_[e]);
              const double tangent =
                (1 + rise_[e] * (b_ + stiffness_[e])) * (-unit[2 * e] * ny_[e] + unit[2 * e + 1] * nx_[e]);
              unit[2 * e]     = normal * nx_[e] - tangent * ny_[e];
              unit[2 * e + 1] = normal * ny_[e] + tangent * nx_[e];
            }
        inverse_block(unit.data(), z);
        response_.push_back(z);
      }
  }

  void
  FrictionSystem::precondition(const std::vector<double> &r, std::vector<double> &result)
  {
    inverse_block(r.data(), result);
    const std::size_t m = forces.size();
    result.resize(2 * n_ + m, 0.);
    if (m == 0)
      return;
    // Block elimination of the creepages: sum(z) - sum(response) creepage = force row.
    // the factor of the rows of forces in linearise()
    const double scale   = b_ / std::sqrt(double(n_));
    double       a[2][2] = {{0, 0}, {0, 0}}, c[2] = {0, 0};
    for (std::size_t f = 0; f < m; ++f)
      {
        for (std::size_t e = 0; e < n_; ++e)
          {
            c[f] += result[2 * e + forces[f]];
            for (std::size_t g = 0; g < m; ++g)
              a[f][g] += response_[g][2 * e + forces[f]];
          }
        c[f] -= r[2 * n_ + f] / scale;
        a[f][f] += creepage_grip();
      }
    // the Schur complement of the creepages, 1 x 1 or 2 x 2 (Cramer's rule)
    double creepage[2] = {0, 0};
    if (m == 1)
      creepage[0] = c[0] / a[0][0];
    else
      {
        const double det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
        creepage[0]      = (c[0] * a[1][1] - c[1] * a[0][1]) / det;
        creepage[1]      = (a[0][0] * c[1] - a[1][0] * c[0]) / det;
      }
    for (std::size_t f = 0; f < m; ++f)
      {
        result[2 * n_ + f] = creepage[f];
        for (std::size_t k = 0; k < 2 * n_; ++k)
          result[k] -= creepage[f] * response_[f][k];
      }
  }

  void
  FrictionSystem::inverse_block(const double *r, std::vector<double> &result)
  {
    // with a large c of a proximal point the slip is mostly c dt: the diagonal is enough
    result.assign(2 * n_, 0.);
    // B + c is then nearly diagonal; the preconditioner decides on speed only
    if (c_ > 0.3 * kernels_.diagonal)
      for (std::size_t k = 0; k < 2 * n_; ++k)
        result[k] = r[k] / b_;
    else
      inverse_adhesion(r, result);
    for (std::size_t e = 0; e < n_; ++e)
      if (slipping[e])
        {
          // slipping elements by their diagonal: b along n, b + b (|q| - g)/g across it
          const double normal  = (r[2 * e] * nx_[e] + r[2 * e + 1] * ny_[e]) / (b_ * (1 + rise_[e] * b_));
          const double tangent = (-r[2 * e] * ny_[e] + r[2 * e + 1] * nx_[e]) /
                                 (b_ * (1 + rise_[e] * (b_ + stiffness_[e])) + stiffness_[e]);
          result[2 * e]     = normal * nx_[e] - tangent * ny_[e];
          result[2 * e + 1] = normal * ny_[e] + tangent * nx_[e];
        }
  }

  void
  FrictionSystem::inverse_adhesion(const double *r, std::vector<double> &result)
  {
    for (auto &w : work_)
      std::fill(w.begin(), w.end(), 0.);
    for (std::size_t e = n_; e-- > 0;)
      {
        const int k = elements[e];
        if (slipping[e])
          continue;
        // 1. d(A t)/dx = -s: the displacement that belongs to a slip is its sum from the leading edge of a
        // run of sticking elements, in steps of dx against rolling. Elements are in the order of x: from the
        // last one back.
        // a run of sticking elements begins at the leading edge, or behind elements that slip
        const bool follows = kernels_.steady && e + 1 < n_ && elements[e + 1] == k + 1 && !slipping[e + 1] &&
                             (k + 1) % task_.grid.mx != 0;
        for (int d = 0; d < 2; ++d)
          work_[d][k] = kernels_.steady ? (follows ? work_[d][k + 1] : 0.) + task_.grid.dx * r[2 * e + d]
                                        : kernels_.step * r[2 * e + d];
      }
    // 2. tractions of that displacement on the periodic doubled grid, A^-1 by its symbol
    apply(kernels_.inverse_xx, kernels_.inverse_xy, kernels_.inverse_yy, work_, image_);
    // 3. cut to the elements that stick
    for (auto &w : work_)
      std::fill(w.begin(), w.end(), 0.);
    for (std::size_t e = 0; e < n_; ++e)
      if (!slipping[e])
        for (int d = 0; d < 2; ++d)
          result[2 * e + d] = image_[d][elements[e]];
  }
} // namespace wheelrail
