#include <wheelrail/base/errors.h>
#include <wheelrail/tables/table.h>
#include <wheelrail/tables/text_rows.h>
#include <wheelrail/wheel/distance_file.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// The different values of one coordinate, growing; steps must be even.
    std::vector<double>
    lines_of(std::vector<double> values, const std::string &path, const char *name)
    {
      std::sort(values.begin(), values.end());
      const double        span = values.empty() ? 0 : values.back() - values.front();
      std::vector<double> lines;
      for (const double value : values)
        if (lines.empty() || value - lines.back() > 1e-6 * span)
          lines.push_back(value);
      if (lines.size() < 4)
        throw InputError(path + ": " + std::to_string(lines.size()) + " values of " + name +
                         "; a grid of at least 4 x 4 points is needed");
      const double step = span / double(lines.size() - 1);
      for (std::size_t k = 0; k < lines.size(); ++k)
        if (std::abs(lines[k] - lines[0] - double(k) * step) > 0.01 * step)
          throw InputError(path + ": the values of " + name + " have no even steps near " +
                           std::to_string(1e3 * lines[k]) + " mm; a regular grid is needed");
      return lines;
    }

    std::size_t
    place_of(const std::vector<double> &lines, const double value)
    {
      const double step = (lines.back() - lines.front()) / double(lines.size() - 1);
      return std::size_t(std::lround((value - lines.front()) / step));
    }
    /// Weights of the cubic through four neighbouring lines at a place, and the first of them.
    std::array<double, 4>
    cubic_weights(const std::vector<double> &lines, const double place, std::size_t &first)
    {
      const double step       = (lines.back() - lines.front()) / double(lines.size() - 1);
      const double t          = std::clamp((place - lines.front()) / step, 0., double(lines.size() - 1));
      first                   = std::min(std::size_t(std::max(0., std::floor(t) - 1)), lines.size() - 4);
      const double          z = t - double(first);
      std::array<double, 4> weights{1, 1, 1, 1};
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b)
          if (a != b)
            weights[a] *= (z - b) / (a - b);
      return weights;
    }
  } // namespace


  double
  DistanceTable::at(const double place_x, const double place_y) const
  {
    std::size_t                 i = 0, j = 0;
    const std::array<double, 4> u = cubic_weights(x, place_x, i), v = cubic_weights(y, place_y, j);
    double                      sum = 0;
    for (std::size_t b = 0; b < 4; ++b)
      for (std::size_t a = 0; a < 4; ++a)
        sum += u[a] * v[b] * distance[i + a + x.size() * (j + b)];
    return sum;
  }


  DistanceTable
  read_distance_file(const std::string &path)
  {
    const Table rows =
      read_table(path,
                 {{"x", Dimension::length, -1e3, 1e3, "-1 km to 1 km", true},
                  {"y", Dimension::length, -1e3, 1e3, "-1 km to 1 km", true},
                  {"distance", Dimension::length, -1e3, 1e3, "-1 km to 1 km", true}},
                 {"rows x, y, distance in mm are needed", false, {}, "#", "x_mm,y_mm,distance_mm"});
    const std::vector<double> &x = *rows.find(0), &y = *rows.find(1), &distance = *rows.find(2);
    DistanceTable              table{lines_of(x, path, "x"), lines_of(y, path, "y"), {}};
    std::vector<unsigned int>  from(table.x.size() * table.y.size(), 0);
    table.distance.resize(from.size());
    for (std::size_t row = 0; row < x.size(); ++row)
      {
        const std::size_t k = place_of(table.x, x[row]) + table.x.size() * place_of(table.y, y[row]);
        if (from[k] > 0)
          throw InputError(place(path, rows.lines[row]) + "the same place as in line " +
                           std::to_string(from[k]) + "; one row for each point is needed");
        from[k]           = rows.lines[row];
        table.distance[k] = distance[row];
      }
    const auto missing = std::find(from.begin(), from.end(), 0u);
    if (missing != from.end())
      {
        const auto k = std::size_t(missing - from.begin());
        throw InputError(path + ": no row for x = " + std::to_string(1e3 * table.x[k % table.x.size()]) +
                         " mm, y = " + std::to_string(1e3 * table.y[k / table.x.size()]) +
                         " mm; one row for each point of the grid is needed");
      }
    return table;
  }
} // namespace wheelrail
