#include <wheelrail/profiles/measurement_noise.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Distance of a point from the polynomial through `beside` neighbours on both sides (two: a cubic), over
    /// the standard deviation that noise of 1 gives it; negative where it cannot be told.
    double
    distance_from_neighbours(const Point2 *const p, const int beside)
    {
      const Point2 chord = p[1] - p[-1];
      const double width = norm(chord);
      if (!(width > 0))
        return -1;
      // coordinates along the chord and to its left; the weights of Lagrange's polynomial at the point
      std::vector<Point2> others;
      for (int k = -beside; k <= beside; ++k)
        if (const Point2 q = p[k] - p[0]; k != 0)
          others.push_back({dot(q, chord) / width, cross(chord, q) / width});
      double value = 0, variance = 1;
      for (std::size_t k = 0; k < others.size(); ++k)
        {
          double weight = 1;
          for (std::size_t j = 0; j < others.size(); ++j)
            if (j != k)
              weight *= others[j].x / (others[j].x - others[k].x);
          value += weight * others[k].y;
          variance += weight * weight;
        }
      return std::isfinite(value) && std::isfinite(variance) ? std::abs(value) / std::sqrt(variance) : -1;
    }

    /// The largest step of which all differences are multiples; 0: none.
    double
    common_step(const std::vector<double> &values)
    {
      const double first = values.front();
      double       range = 0, largest = 0;
      for (const double value : values)
        {
          range   = std::max(range, std::abs(value - first));
          largest = std::max(largest, std::abs(value));
        }
      if (!(range > 0))
        return 0;
      for (int power = static_cast<int>(std::ceil(std::log10(range))); power > -15; --power)
        for (const double factor : {5., 2., 1.})
          {
            const double step = factor * std::pow(10., power), error = 1e-6 + 1e-15 * largest / step;
            if (error < 1e-3 && std::all_of(values.begin(), values.end(), [&](const double value) {
                  const double multiple = (value - first) / step;
                  return std::abs(multiple - std::round(multiple)) < error;
                }))
              return step;
          }
      return 0;
    }

    /// Whether nine of ten steps from point to point are as wide as the median one: places that were chosen.
    bool
    is_stepped_evenly(const std::vector<double> &values)
    {
      std::vector<double> steps;
      for (std::size_t i = 1; i < values.size(); ++i)
        steps.push_back(std::abs(values[i] - values[i - 1]));
      const double usual = median(steps);
      const auto   even  = std::count_if(
        steps.begin(), steps.end(), [&](const double step) { return std::abs(step - usual) < 1e-3 * usual; });
      return usual > 0 && 10 * even >= 9 * static_cast<std::ptrdiff_t>(steps.size());
    }

    double
    rounding_along(const std::vector<Point2> &points, double Point2::*axis)
    {
      std::vector<double> values;
      for (const Point2 &p : points)
        values.push_back(p.*axis);
      return values.size() < 3 || is_stepped_evenly(values) ? 0 : common_step(values);
    }

    /// Normal of the outline at a point, from its neighbours.
    Point2
    normal_at(const std::vector<Point2> &points, const std::size_t i)
    {
      const Point2 d = points[std::min(i + 1, points.size() - 1)] - points[i > 0 ? i - 1 : 0];
      const double l = norm(d);
      return l > 0 ? Point2{-d.y / l, d.x / l} : Point2{0, 1};
    }

    /// For each point how many in a row have its coordinate along an axis.
    std::vector<double>
    in_a_row(const std::vector<Point2> &points, double Point2::*axis, const double step)
    {
      std::vector<double> result(points.size(), 1);
      for (std::size_t i = 0, k = 0; step > 0 && i < points.size(); i = k)
        {
          for (k = i + 1; k < points.size() && std::abs(points[k].*axis - points[i].*axis) < 0.5 * step;)
            ++k;
          std::fill(result.begin() + i, result.begin() + k, static_cast<double>(k - i));
        }
      return result;
    }

    /// Variance of a coordinate that is rounded to multiples of a step.
    double
    rounded(const double step)
    {
      return step * step / 12;
    }
  } // namespace


  double
  median(std::vector<double> values)
  {
    if (values.empty())
      return 0;
    const auto middle = values.begin() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }


  std::vector<double>
  estimated_scatter(const std::vector<Point2> &points, const std::size_t beside)
  {
    constexpr double      reach = 12e-3;
    constexpr std::size_t least = 20;
    const double          scale = 1.4826; // of a median to a standard deviation
    const std::size_t     n     = points.size();
    std::vector<double>   result(n, 0), distance(n, -1), length(n, 0), all;
    for (std::size_t i = 1; i < n; ++i)
      length[i] = length[i - 1] + norm(points[i] - points[i - 1]);
    for (std::size_t i = beside; i + beside < n; ++i)
      if ((distance[i] = distance_from_neighbours(&points[i], static_cast<int>(beside))) >= 0)
        all.push_back(distance[i]);
    const double whole = scale * median(all);
    for (std::size_t i = 0; i < n; ++i)
      {
        std::vector<double> near;
        const auto          take = [&](const std::size_t k) {
          if (distance[k] >= 0)
            near.push_back(distance[k]);
        };
        for (std::size_t k = i; k < n && (k < i + least || length[k] < length[i] + reach); ++k)
          take(k);
        for (std::size_t k = i; k-- > 0 && (k + least > i || length[k] > length[i] - reach);)
          take(k);
        result[i] = std::max(whole, near.size() < least ? 0 : scale * median(near));
      }
    return result;
  }


  Point2
  rounding_of(const std::vector<Point2> &points)
  {
    return {rounding_along(points, &Point2::x), rounding_along(points, &Point2::y)};
  }


  std::vector<double>
  deviation_of(const std::vector<Point2> &points, const Point2 &rounding)
  {
    const std::vector<double> scatter = estimated_scatter(points),
                              along_x = in_a_row(points, &Point2::x, rounding.x),
                              along_y = in_a_row(points, &Point2::y, rounding.y);
    std::vector<double> result;
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        const Point2 n = normal_at(points, i);
        const double x = n.x * n.x * rounded(rounding.x), y = n.y * n.y * rounded(rounding.y);
        result.push_back(
          std::sqrt(std::max(0., scatter[i] * scatter[i] - x - y) + along_x[i] * x + along_y[i] * y));
      }
    return result;
  }
} // namespace wheelrail
