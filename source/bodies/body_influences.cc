#include <wheelrail/bodies/body_influences.h>

#include <cstddef>
#include <vector>

// R at lags i dx and at i dx + step: displacement here, and where the particle was one step before, for the
// slip (u - u')/dq.

namespace wheelrail
{
  BodyInfluences
  body_influences(const BodyTable     &table,
                  const BodyPlacement &placement,
                  const ContactRows   &rows,
                  const HalfspaceGrid &grid,
                  const double         step)
  {
    std::vector<double>       lags  = RowsInfluence::lags(grid, 0);
    const std::vector<double> ahead = RowsInfluence::lags(grid, step);
    // lags i dx and i dx + step: for a step of one element the second set is the first moved on by one, and
    // only one lag is new
    const std::ptrdiff_t count = lags.size(), next = step == grid.dx ? 1 : count;
    lags.insert(lags.end(), ahead.end() - next, ahead.end());
    BodyInfluences       result{body_influence(table, placement, rows, lags), {}};
    std::vector<double> &all   = result.here.by_lag;
    const std::ptrdiff_t block = all.size() / lags.size();
    result.ahead               = {result.here.rows,
                                  result.here.weights,
                                  std::vector<double>(all.begin() + next * block, all.begin() + (next + count) * block)};
    all.resize(count * block);
    return result;
  }
} // namespace wheelrail
