// label: fast

// Influences that are added to half-spaces row by row, against plain sums.

#include "near.h"

#include <wheelrail/halfspace/added_influence.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace wheelrail;
using test::near_relative;

namespace
{
  /// Forces on rows of smooth influence, added by FFT, against plain sums; symmetric.
  BOOST_AUTO_TEST_CASE(test_added)
  {
    HalfspaceGrid grid{7, 5, 1e-3, 1e-3, -3e-3, -2e-3};
    const double  step   = 0.5e-3;
    const int     rows   = 2;
    const auto    kernel = [](const int i, const int a, const int j, const int b, const double lag) {
      const double even = std::exp(-lag * lag / 4e-6) / (1 + std::abs(i - j)), odd = lag * 1e3 * even;
      return (a == 2) == (b == 2) ? even * (1 + (a == b)) : a == 2 ? -odd : odd;
    };
    std::vector<RowsInfluence::Basis> bases;
    RowInfluence                      here{rows, {}, {}}, ahead;
    for (int j = 0; j < grid.my; ++j)
      {
        const double c = std::cos(0.1 * j), s = std::sin(0.1 * j);
        bases.push_back({{0, c, s, 0, s, -c, 1, 0, 0}});
        here.weights.insert(here.weights.end(), {1 - 0.25 * j, 0.25 * j});
      }
    ahead = here;
    for (RowInfluence *influence : {&here, &ahead})
      for (const double lag : RowsInfluence::lags(grid, influence == &here ? 0 : step))
        for (int r = 0; r < 9 * rows * rows; ++r)
          {
            const int row = r / (3 * rows), column = r % (3 * rows);
            influence->by_lag.push_back(kernel(row / 3, row % 3, column / 3, column % 3, lag));
          }
    RowsInfluence added(grid, bases);
    added.add_body(here, ahead, step);
    std::vector<double> t(grid.size(), 0.), u(grid.size(), 0.), slip(grid.size(), 0.);
    const int           source = 2 + grid.mx * 1, receiver = 5 + grid.mx * 3;
    t[source] = 1;
    added.add_displacement({{nullptr, &t, nullptr}}, {{nullptr, nullptr, &u}});
    added.add_slip({{nullptr, &t, nullptr}}, {{&slip, nullptr, nullptr}});
    const auto plain =
      [&](const int e, const int f, const int receiving, const int loading, const double ahead_by) {
        double       sum = 0;
        const double lag = grid.x(e % grid.mx) - grid.x(f % grid.mx) + ahead_by;
        for (int i = 0; i < rows; ++i)
          for (int j = 0; j < rows; ++j)
            for (int a = 0; a < 3; ++a)
              for (int b = 0; b < 3; ++b)
                sum += here.weights[rows * (e / grid.mx) + i] * here.weights[rows * (f / grid.mx) + j] *
                       bases[e / grid.mx][3 * a + receiving] * bases[f / grid.mx][3 * b + loading] *
                       kernel(i, a, j, b, lag) * grid.element_area();
        return sum;
      };
    BOOST_TEST(near_relative(
      u[receiver], plain(receiver, source, 2, 1, 0), 1e-12, "displacement along n under traction y"));
    BOOST_TEST(near_relative(slip[receiver],
                             (plain(receiver, source, 0, 1, 0) - plain(receiver, source, 0, 1, step)) / step,
                             1e-10,
                             "slip along x under traction y"));
    std::vector<double> back(grid.size(), 0.);
    std::swap(t[source], t[receiver]);
    added.add_displacement({{nullptr, nullptr, &t}}, {{nullptr, &back, nullptr}});
    BOOST_TEST(near_relative(back[source], u[receiver], 1e-12, "influence is the same both ways"));
  }

  /// Influences that are as smooth as those of bodies lose nothing with their short modes: against plain
  /// sums.
  BOOST_AUTO_TEST_CASE(test_smooth)
  {
    const HalfspaceGrid grid{80, 1, 0.25e-3, 0.25e-3, 0, 0};
    const double        step   = grid.dx;
    const auto          kernel = [](const int a, const int b, const double lag) {
      const double even = 1 / (1 + lag * lag / 4e-4), odd = lag / 20e-3 * even;
      return (a == 2) == (b == 2) ? even : a == 2 ? -odd : odd;
    };
    RowInfluence here{1, {1}, {}}, ahead{1, {1}, {}};
    for (RowInfluence *influence : {&here, &ahead})
      for (const double lag : RowsInfluence::lags(grid, influence == &here ? 0 : step))
        for (int entry = 0; entry < 9; ++entry)
          influence->by_lag.push_back(kernel(entry / 3, entry % 3, lag));
    RowsInfluence added(grid, {{{0, 1, 0, 0, 0, -1, 1, 0, 0}}});
    added.add_body(here, ahead, step);
    std::vector<double> t(grid.size(), 0.), u(grid.size(), 0.), slip(grid.size(), 0.);
    for (int i = 20; i < 60; ++i)
      t[i] = std::sqrt((i - 19.5) * (60.5 - i)) * (i % 7 == 0 ? 1.1 : 1);
    added.add_displacement({{nullptr, &t, nullptr}}, {{&u, nullptr, nullptr}});
    added.add_slip({{nullptr, &t, nullptr}}, {{&slip, nullptr, nullptr}});
    double u_off = 0, slip_off = 0, u_largest = 0, slip_largest = 0;
    for (int i = 0; i < grid.mx; ++i)
      {
        double one = 0, two = 0;
        for (int j = 0; j < grid.mx; ++j)
          {
            const double lag = grid.x(i) - grid.x(j), force = t[j] * grid.element_area();
            one += kernel(2, 0, lag) * force;
            two += (kernel(2, 0, lag) - kernel(2, 0, lag + step)) / step * force;
          }
        u_off        = std::max(u_off, std::abs(u[i] - one));
        slip_off     = std::max(slip_off, std::abs(slip[i] - two));
        u_largest    = std::max(u_largest, std::abs(one));
        slip_largest = std::max(slip_largest, std::abs(two));
      }
    BOOST_TEST(u_off < 1e-5 * u_largest,
               "smooth influence: displacement off by " + std::to_string(1e6 * u_off / u_largest) + "e-6");
    BOOST_TEST(slip_off < 1e-4 * slip_largest,
               "and slip by " + std::to_string(1e6 * slip_off / slip_largest) + "e-6");
  }
} // namespace
