#include <wheelrail/base/errors.h>
#include <wheelrail/contactcalls/call_table.h>
#include <wheelrail/contactcalls/contact_calls.h>
#include <wheelrail/contactfiles/case_points.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Points below the surface.

using namespace wheelrail;

namespace
{
  const ContactPoints &
  block_of(const CallProblem &problem, const int number)
  {
    const auto found = problem.blocks.find(number);
    if (found == problem.blocks.end())
      throw InputError("there is no block " + std::to_string(number) + " of points; call subs_addblock");
    return found->second;
  }

  /// The three numbers, or the list, that stand for one direction.
  void
  add_indices(const int kind, const int n, const double *values, std::vector<int> &counts)
  {
    if (kind % 4 == 2 && n != 3)
      throw InputError("ISUBS = " + std::to_string(kind) + " needs first, step and last index, 3 values");
    for (int k = 0; k < n; ++k)
      {
        if (!(values[k] >= 0 && values[k] <= most_contact_elements))
          throw InputError("indices of points are not from 0 to " + std::to_string(most_contact_elements));
        counts.push_back(int(std::lround(values[k])));
      }
  }
} // namespace

void
subs_addblock(const int    *ire,
              const int    *icp,
              const int    *block,
              const int    *isubs,
              const int    *nx,
              const int    *ny,
              const int    *nz,
              const double *x,
              const double *y,
              const double *z)
{
  with_problem(
    {__func__, ire, icp}, {block, isubs, nx, ny, nz, z}, [&](CallElement &element, CallProblem &problem) {
      const double  length = element.units.length;
      ContactPoints points;
      points.kind = *isubs;
      points.line = 1;
      if (*isubs < 1 || *isubs > 9 || *isubs == 4 || *isubs == 8)
        throw InputError("ISUBS = " + std::to_string(*isubs) +
                         " is unknown; 1, 2, 3, 5, 6, 7 and 9 are known");
      if (!(x && y) && (*isubs == 9 || *isubs % 4 != 1))
        throw InputError("x or y is a null pointer");
      if (*isubs == 9)
        {
          for (int k = 0; k < *nx; ++k)
            points.x.push_back(x[k] * length);
          for (int k = 0; k < *ny; ++k)
            points.y.push_back(y[k] * length);
        }
      else if (*isubs % 4 != 1)
        {
          if (*isubs % 4 == 3)
            points.counts = {*nx, *ny};
          add_indices(*isubs, *nx, x, points.counts);
          add_indices(*isubs, *ny, y, points.counts);
        }
      if (*isubs < 4)
        {
          if (*nz != 3)
            throw InputError("ISUBS = " + std::to_string(*isubs) + " needs NZ, ZL and DZ, not " +
                             std::to_string(*nz) + " values");
          if (!(z[0] >= 0 && z[0] <= most_contact_elements))
            throw InputError("NZ is not from 0 to " + std::to_string(most_contact_elements));
          for (int k = 0; k < int(std::lround(z[0])); ++k)
            points.z.push_back((z[1] + k * z[2]) * length);
        }
      else
        for (int k = 0; k < *nz; ++k)
          points.z.push_back(z[k] * length);
      // blocks of this number and higher ones are left out
      problem.blocks.erase(problem.blocks.lower_bound(*block), problem.blocks.end());
      problem.blocks[*block] = points;
    });
}

void
subs_calculate(const int *ire, const int *icp, int *error)
{
  const int code = with_problem({__func__, ire, icp, 0, true},
                                {error},
                                [](CallElement &, CallProblem &problem) { calculate_below(problem); });
  if (error)
    *error = code;
}

void
subs_getblocksize(const int *ire, const int *icp, const int *block, int *nx, int *ny, int *nz)
{
  with_problem({__func__, ire, icp, 0, true},
               {block, cleared(nx), cleared(ny), cleared(nz)},
               [&](CallElement &, CallProblem &problem) {
                 const PointBlock points = point_block(block_of(problem, *block),
                                                       call_result(problem, std::max(1, *icp)).solution.grid);
                 *nx                     = int(points.x.size());
                 *ny                     = int(points.y.size());
                 *nz                     = int(points.z.size());
               });
}

void
subs_getresults(const int *ire,
                const int *icp,
                const int *block,
                const int *n_points,
                const int *n_columns,
                const int *columns,
                double    *values)
{
  with_problem({__func__, ire, icp, 0, true},
               {block, n_points, n_columns, when(n_columns, columns), when(n_columns, values)},
               [&](CallElement &element, CallProblem &problem) {
                 block_of(problem, *block);
                 const auto found = problem.below.find({problem.solved ? 1 : std::max(1, *icp), *block});
                 if (found == problem.below.end())
                   throw InputError("the stresses are not computed; call subs_calculate first");
                 const int count = std::min(*n_points, int(found->second.size()));
                 for (int c = 0; c < *n_columns; ++c)
                   for (int k = 0; k < count; ++k)
                     {
                       constexpr double unknown = -999;
                       const int        column  = columns[c];
                       const double     unit =
                         column <= 6 ? 1e3 / element.units.length : 1e-6 / element.units.stress;
                       const double value        = column < 1 || column > 21 || (column >= 4 && column <= 6)
                                                     ? unknown
                                                     : unit * found->second[std::size_t(k)][std::size_t(column - 1)];
                       values[k + *n_points * c] = value;
                     }
               });
}
