#include <wheelrail/base/errors.h>
#include <wheelrail/base/file_kind.h>
#include <wheelrail/reference/distance_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

namespace wheelrail
{
  namespace
  {
    struct Row
    {
      double       x, y, distance; ///< [mm]
      unsigned int line;
    };

    std::vector<Row>
    read_rows(const std::string &path)
    {
      if (const std::string other = other_than_a_file(path); !other.empty())
        throw InputError(path + ": " + other + "; rows x, y, distance in mm are needed");
      std::ifstream file(path);
      if (!file)
        throw InputError(path + ": the file cannot be read; rows x, y, distance in mm are needed");
      std::vector<Row> rows;
      std::string      text;
      for (unsigned int line = 1; std::getline(file, text); ++line)
        {
          text.resize(std::min(text.size(), text.find('#')));
          std::replace(text.begin(), text.end(), ',', ' ');
          std::replace(text.begin(), text.end(), '\r', ' ');
          if (text.find_first_not_of(" \t") == std::string::npos)
            continue;
          std::istringstream words(text);
          Row                row{0, 0, 0, line};
          std::string        more;
          if (!(words >> row.x >> row.y >> row.distance) || words >> more ||
              !std::isfinite(row.x + row.y + row.distance))
            throw InputError(path + ":" + std::to_string(line) +
                             ": three numbers x, y, distance in mm are needed");
          rows.push_back(row);
        }
      return rows;
    }

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
                           std::to_string(lines[k]) + " mm; a regular grid is needed");
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
    const std::vector<Row> rows = read_rows(path);
    std::vector<double>    all_x, all_y;
    for (const Row &row : rows)
      {
        all_x.push_back(row.x);
        all_y.push_back(row.y);
      }
    DistanceTable             table{lines_of(all_x, path, "x"), lines_of(all_y, path, "y"), {}};
    std::vector<unsigned int> from(table.x.size() * table.y.size(), 0);
    table.distance.resize(from.size());
    for (const Row &row : rows)
      {
        const std::size_t k = place_of(table.x, row.x) + table.x.size() * place_of(table.y, row.y);
        if (from[k] > 0)
          throw InputError(path + ":" + std::to_string(row.line) + ": the same place as in line " +
                           std::to_string(from[k]) + "; one row for each point is needed");
        from[k]           = row.line;
        table.distance[k] = 1e-3 * row.distance;
      }
    const auto missing = std::find(from.begin(), from.end(), 0u);
    if (missing != from.end())
      {
        const auto k = std::size_t(missing - from.begin());
        throw InputError(path + ": no row for x = " + std::to_string(table.x[k % table.x.size()]) +
                         " mm, y = " + std::to_string(table.y[k / table.x.size()]) +
                         " mm; one row for each point of the grid is needed");
      }
    for (auto *lines : {&table.x, &table.y})
      for (double &value : *lines)
        value *= 1e-3;
    return table;
  }
} // namespace wheelrail
