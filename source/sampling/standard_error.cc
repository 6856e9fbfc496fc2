#include <wheelrail/sampling/standard_error.h>

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace wheelrail
{
  namespace
  {
    /// Integral of values that are straight between their distances, from the first of them to any place.
    class Integral
    {
    public:
      Integral(const std::vector<double> &distance, const std::vector<double> &values)
        : distance_(distance)
        , values_(values)
        , sum_(values.size(), 0.)
      {
        for (std::size_t k = 1; k < values.size(); ++k)
          sum_[k] = sum_[k - 1] + 0.5 * (values[k - 1] + values[k]) * (distance[k] - distance[k - 1]);
      }

      double
      to(const double place) const
      {
        const auto above = std::upper_bound(distance_.begin(), distance_.end(), place);
        if (above == distance_.begin())
          return values_.front() * (place - distance_.front()); // as the first value before it
        const std::size_t k    = std::size_t(above - distance_.begin()) - 1;
        const double      rest = place - distance_[k];
        if (above == distance_.end())
          return sum_[k] + values_[k] * rest;
        const double slope = (values_[k + 1] - values_[k]) / (distance_[k + 1] - distance_[k]);
        return sum_[k] + rest * (values_[k] + 0.5 * slope * rest);
      }

    private:
      const std::vector<double> &distance_, &values_;
      std::vector<double>        sum_;
    };

    /// What a deviation that is known by so many degrees of freedom is multiplied with, so that twice of it
    /// leaves out as much of Student's distribution as two deviations do of the normal one.
    double
    enlarged(const std::size_t freedom)
    {
      constexpr double beyond_two = 0.0227501319; // of a normal distribution, on one side
      return 0.5 * gsl_cdf_tdist_Qinv(beyond_two, double(freedom));
    }

    /// Deviation of the means of blocks over the root of their number, and how well it is known.
    double
    error_of_blocks(const std::vector<double> &means, const std::size_t length, const std::size_t blocks)
    {
      const std::size_t   first = means.size() - blocks * length; // the last ones count
      std::vector<double> of_block(blocks, 0.);
      double              mean = 0, squares = 0;
      for (std::size_t b = 0; b < blocks; ++b)
        {
          for (std::size_t k = 0; k < length; ++k)
            of_block[b] += means[first + b * length + k] / double(length);
          mean += of_block[b] / double(blocks);
        }
      for (const double value : of_block)
        squares += (value - mean) * (value - mean);
      return std::sqrt(squares / double(blocks * (blocks - 1))) * enlarged(blocks - 1);
    }
  } // namespace


  std::vector<double>
  cell_means(const std::vector<double> &distance,
             const std::vector<double> &values,
             const Range               &stretch,
             const double               length)
  {
    if (values.empty())
      return {};
    const Integral integral(distance, values);
    const auto     cells = std::size_t(std::max(0., std::floor((stretch.s1 - stretch.s0) / length + 1e-6)));
    std::vector<double> means(cells);
    for (std::size_t k = 0; k < cells; ++k)
      {
        const double end = stretch.s1 - double(cells - 1 - k) * length;
        means[k]         = (integral.to(end) - integral.to(end - length)) / length;
      }
    return means;
  }


  double
  standard_error(const std::vector<double> &means)
  {
    constexpr std::size_t least = 4;
    if (means.size() < least)
      return std::numeric_limits<double>::infinity();
    double error = 0;
    for (std::size_t length = 1; means.size() / length >= least; ++length)
      error = std::max(error, error_of_blocks(means, length, means.size() / length));
    return error;
  }
} // namespace wheelrail
