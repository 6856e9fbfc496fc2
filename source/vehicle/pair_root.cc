#include <wheelrail/vehicle/pair_root.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wheelrail
{
  namespace
  {
    Pair
    moved(const Pair &at, const double t, const Pair &step)
    {
      return {at[0] + t * step[0], at[1] + t * step[1]};
    }

    /// Derivatives by differences from the value `here`; nothing where a place beside `at` has no value on
    /// either side.
    std::optional<PairSlope>
    derivatives(const PairFunction &function, const Pair &at, const Pair &here, const Pair &step, int &calls)
    {
      PairSlope result{};
      for (int k = 0; k < 2; ++k)
        {
          Pair move{};
          // with the sign of the function, so that the mirror image is sought by mirrored steps
          move[k]    = std::copysign(step[k], here[k]);
          auto there = function(moved(at, 1, move));
          ++calls;
          if (!there)
            {
              move[k] = -move[k];
              there   = function(moved(at, 1, move));
              ++calls;
            }
          if (!there)
            return {};
          for (int i = 0; i < 2; ++i)
            result[i][k] = ((*there)[i] - here[i]) / move[k];
        }
      return result;
    }

    /// The step of Newton's method, shortened as a whole; nothing where the derivatives are singular.
    std::optional<Pair>
    newton_step(const PairSlope &a, const Pair &f, const Pair &longest)
    {
      const double det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
      Pair         step{(a[0][1] * f[1] - a[1][1] * f[0]) / det, (a[1][0] * f[0] - a[0][0] * f[1]) / det};
      if (!std::isfinite(step[0]) || !std::isfinite(step[1]))
        return {};
      const double over = std::max({1., std::abs(step[0]) / longest[0], std::abs(step[1]) / longest[1]});
      return Pair{step[0] / over, step[1] / over};
    }

    /// Broyden's formula: the least change that gives the difference `rise` over `step`, both unknowns
    /// measured in `unit`.
    void
    mend(PairSlope &a, const Pair &step, const Pair &rise, const Pair &unit)
    {
      const double u = step[0] / unit[0], v = step[1] / unit[1], norm = u * u + v * v;
      for (int i = 0; i < 2; ++i)
        {
          const double missing = (rise[i] - a[i][0] * step[0] - a[i][1] * step[1]) / norm;
          a[i][0] += missing * u / unit[0];
          a[i][1] += missing * v / unit[1];
        }
    }
  } // namespace


  double
  larger_magnitude(const Pair &a)
  {
    return std::max(std::abs(a[0]), std::abs(a[1]));
  }


  std::optional<PairRoot>
  find_pair_root(const PairRoot     &first,
                 const PairSearch   &search,
                 const PairFunction &function,
                 const PairFunction &cheap)
  {
    PairRoot   root{first.at, {}, first.slope, false, 1};
    const auto start = function(first.at);
    if (!start)
      return {};
    root.left                                = *start;
    std::optional<PairSlope> &slope          = root.slope;
    bool                      fresh          = false;
    double                    part           = 1; // of the step that is tried
    double                    at_derivatives = std::numeric_limits<double>::infinity(); // what was left there
    constexpr double          worth          = 0.5; // less than that must be left for derivatives once more
    while (!(root.found = larger_magnitude(root.left) <= search.enough) && root.calls < search.most_calls)
      {
        if (!slope)
          {
            root.calls += cheap ? 1 : 0;
            if (const std::optional<Pair> here = cheap ? cheap(root.at) : root.left)
              slope = derivatives(cheap ? cheap : function, root.at, *here, search.step, root.calls);
            fresh = true;
            part  = 1;
          }
        const auto step = slope ? newton_step(*slope, root.left, search.longest) : std::nullopt;
        if (!step)
          break;
        const Pair there = moved(root.at, part, *step);
        const auto value = function(there);
        ++root.calls;
        if (value && larger_magnitude(*value) < larger_magnitude(root.left))
          {
            mend(*slope, moved(there, -1, root.at), moved(*value, -1, root.left), search.step);
            root.at   = there;
            root.left = *value;
            fresh     = false;
            part      = 1;
          }
        else if (part > 0.2)
          part /= 2;
        else if (fresh || larger_magnitude(root.left) > worth * at_derivatives)
          break; // where the function jumps derivatives lead nowhere
        else
          {
            at_derivatives = larger_magnitude(root.left);
            slope.reset();
          }
      }
    return root;
  }
} // namespace wheelrail
