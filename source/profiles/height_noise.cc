#include <wheelrail/profiles/height_noise.h>
#include <wheelrail/profiles/measurement_noise.h>
#include <wheelrail/profiles/smoothing_spline.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace wheelrail
{
  namespace
  {
    constexpr double most_stretch = 3;
    constexpr double least_noise  = 2e-8; // below it the last digits of a file make it [m]

    Heights
    line_along(const HeightGrid &grid, const std::size_t row)
    {
      const std::size_t n = grid.along.size();
      Heights           line;
      for (std::size_t k = 0; k < n; ++k)
        line.push_back({grid.along[k], grid.height[row * n + k]});
      return line;
    }

    std::size_t
    rows_of(const HeightGrid &grid)
    {
      return grid.height.size() / grid.along.size();
    }

    /// Noise at each place of a line [m]. Where places lie far apart a smooth shape leaves a cubic, too, but
    /// far less a polynomial of fifth degree: the smaller of both counts.
    std::vector<double>
    noise_along(const Heights &line)
    {
      std::vector<double>       noise = estimated_scatter(line);
      const std::vector<double> fifth = estimated_scatter(line, 3);
      for (std::size_t k = 0; k < noise.size() && line.size() >= 9; ++k)
        noise[k] = std::min(noise[k], fifth[k]);
      return noise;
    }

    double
    without_digits(const double noise)
    {
      return noise > least_noise ? noise : 0;
    }
  } // namespace


  double
  largest_noise(const Heights &heights)
  {
    const std::vector<double> scatter = estimated_scatter(heights);
    return *std::max_element(scatter.begin(), scatter.end());
  }


  double
  stretch_of(const double noise)
  {
    return std::clamp(std::sqrt(noise / 1e-6), 1., most_stretch);
  }


  std::vector<double>
  smoothed(Heights                    heights,
           const double               noise,
           const double               stretch,
           const std::vector<double> &places,
           const unsigned int         draw)
  {
    for (Point2 &p : heights)
      p.x /= stretch;
    const std::vector<Segment> pieces =
      smoothing_spline(heights, {}, std::vector<double>(heights.size(), noise), draw);
    std::vector<double> values;
    std::size_t         piece = 0;
    for (const double place : places)
      {
        const double x = place / stretch;
        while (piece + 1 < pieces.size() && pieces[piece].end.x < x)
          ++piece;
        double a = 0, b = 1;
        for (double m = 0.5; m > a && m < b && b - a > 1e-14; m = 0.5 * (a + b))
          (position_on(pieces[piece], m).x < x ? a : b) = m;
        values.push_back(position_on(pieces[piece], 0.5 * (a + b)).y);
      }
    return values;
  }


  void
  smooth_along(HeightGrid &grid, const unsigned int draw)
  {
    constexpr double     reach = 12e-3;
    const std::size_t    n = grid.along.size(), rows = rows_of(grid);
    std::vector<Heights> lines(rows);
    std::vector<double>  found;
    for (std::size_t row = 0; row < rows; ++row)
      {
        lines[row]                        = line_along(grid, row);
        const std::vector<double> scatter = estimated_scatter(lines[row]);
        found.push_back(*std::min_element(scatter.begin(), scatter.end())); // that of all
      }
    for (std::size_t row = 0; row < rows; ++row)
      {
        std::vector<double> near;
        for (std::size_t other = 0; other < rows; ++other)
          if (rows == 1 || std::abs(grid.across[other] - grid.across[row]) < reach)
            near.push_back(found[other]);
        const std::vector<double> values = smoothed(lines[row], median(near), most_stretch, grid.along, draw);
        std::copy(values.begin(), values.end(), grid.height.begin() + row * n);
      }
  }


  void
  find_noise(HeightGrid &grid)
  {
    double largest = 0;
    for (std::size_t row = 0; row < rows_of(grid); ++row)
      for (const double noise : noise_along(line_along(grid, row)))
        largest = std::max(largest, noise);
    grid.noise = without_digits(largest);
  }


  double
  noise_of_slices(const std::vector<Heights> &lines)
  {
    std::vector<double> of_lines;
    for (const Heights &line : lines)
      {
        const std::vector<double> noise = noise_along(line);
        of_lines.push_back(*std::min_element(noise.begin(), noise.end())); // that of all
      }
    return without_digits(median(of_lines));
  }


  void
  find_noise_of_slices(HeightGrid &grid)
  {
    std::vector<Heights> lines;
    for (std::size_t row = 0; row < rows_of(grid); ++row)
      lines.push_back(line_along(grid, row));
    grid.noise = noise_of_slices(lines);
  }


  HeightGrid
  with_noise(HeightGrid grid, const bool of_slices, const unsigned int draw)
  {
    if (draw == 0)
      return grid;
    std::mt19937_64                  random(draw);
    std::normal_distribution<double> normal(0, 1);
    const std::size_t                n = grid.along.size();
    std::vector<double>              of_slice(n);
    for (double &off : of_slice)
      off = normal(random);
    for (std::size_t k = 0; k < grid.height.size(); ++k)
      grid.height[k] += grid.noise * (of_slices ? of_slice[k % n] : normal(random));
    return grid;
  }


  HeightGrid
  smoothed_heights(HeightGrid grid)
  {
    const std::size_t n = grid.along.size();
    for (std::size_t k = 0; k < n && !grid.across.empty(); ++k)
      {
        Heights across;
        for (std::size_t row = 0; row < grid.across.size(); ++row)
          across.push_back({grid.across[row], grid.height[row * n + k]});
        const std::vector<double> values = smoothed(across, grid.noise, stretch_of(grid.noise), grid.across);
        for (std::size_t row = 0; row < values.size(); ++row)
          grid.height[row * n + k] = values[row];
      }
    smooth_along(grid);
    return grid;
  }
} // namespace wheelrail
