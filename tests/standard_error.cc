// label: fast

// Standard errors of means over cells: how often the true mean lies within two of them, for noise of known
// correlation; and means over whole cells.
#include "near.h"

#include <wheelrail/sampling/steadiness.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;

namespace
{
  /// Means over cells that go on from each other with a factor (autoregressive of first order), unit variance
  /// of what is new in each, after enough of them to have forgotten the first. Their mean is 0.
  std::vector<double>
  noise(const std::size_t n, const double correlation, std::mt19937 &generator)
  {
    std::normal_distribution<double> fresh;
    std::vector<double>              values(n);
    double                           value = 0;
    for (int k = 0; k < 200; ++k)
      value = correlation * value + fresh(generator);
    for (double &v : values)
      v = value = correlation * value + fresh(generator);
    return values;
  }

  double
  mean(const std::vector<double> &values)
  {
    double sum = 0;
    for (const double v : values)
      sum += v;
    return sum / double(values.size());
  }

  /// Share of 2000 signals whose mean lies within two standard errors of 0.
  double
  coverage(const std::size_t n, const double correlation, std::mt19937 &generator)
  {
    constexpr int signals = 2000;
    int           inside  = 0;
    for (int k = 0; k < signals; ++k)
      {
        const auto values = noise(n, correlation, generator);
        inside += std::abs(mean(values)) <= 2 * standard_error(values);
      }
    return double(inside) / signals;
  }

  BOOST_AUTO_TEST_CASE(test_coverage)
  {
    std::mt19937 generator(1);
    struct Case
    {
      std::size_t n;
      double      correlation, least;
    };
    // neighbours correlated by 0.6 are alike over 4 cells, of 0.8 over 9; as many as 12 and 40 cells hold
    for (const Case &one : {Case{12, 0, 0.95},
                            Case{12, 0.3, 0.94},
                            Case{16, 0.6, 0.90},
                            Case{24, 0.6, 0.95},
                            Case{40, 0.8, 0.93},
                            Case{80, 0.8, 0.95}})
      {
        const double found = coverage(one.n, one.correlation, generator);
        BOOST_TEST(found >= one.least,
                   std::to_string(one.n) + " cells with a correlation of " + std::to_string(one.correlation) +
                     ": two errors cover " + std::to_string(found) + ", at least " +
                     std::to_string(one.least));
      }
    // not by errors that are too large to be of use: independent cells, whose mean is known to 1/sqrt(n)
    double sum = 0;
    for (int k = 0; k < 1000; ++k)
      sum += standard_error(noise(24, 0, generator)) / 1000;
    BOOST_TEST(sum * std::sqrt(24.) < 2,
               "24 independent cells: " + std::to_string(sum * std::sqrt(24.)) +
                 " times the true standard error in the mean");
    BOOST_TEST(std::isinf(standard_error({1, 2, 3})), "three cells tell no error");
  }

  /// What repeats from cell to cell is no noise, whatever the rows.
  BOOST_AUTO_TEST_CASE(test_cells)
  {
    std::vector<double> distance, values;
    for (double z = 0; z < 20e-3; z += 1e-3 / 17.3)
      {
        distance.push_back(z);
        values.push_back(100 + 4 * std::sin(2 * M_PI * z / 1e-3) + 1e3 * z);
      }
    const double end   = distance.back();
    const auto   means = cell_means(distance, values, {end - 12.4e-3, end}, 1e-3);
    BOOST_TEST(means.size() == 12, "whole cells of a stretch of 12.4");
    for (std::size_t k = 0; k < means.size(); ++k)
      BOOST_TEST(near(means[k],
                      100 + 1e3 * (end - (double(means.size() - k) - 0.5) * 1e-3),
                      0.02,
                      "mean over cell " + std::to_string(k)));
  }
} // namespace
