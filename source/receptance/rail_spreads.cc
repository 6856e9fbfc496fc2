#include <wheelrail/receptance/rail_spreads.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace wheelrail
{
  namespace
  {
    /// Calls f(place, weight) at Gauss points of a stretch.
    template <typename F>
    void
    gauss(const double from, const double to, const F &f)
    {
      static const dealii::QGauss<1> points(10);
      for (unsigned int q = 0; q < points.size(); ++q)
        f(from + points.point(q)[0] * (to - from), points.weight(q) * (to - from));
    }

    /// int a(z) b(z - s) dz
    double
    overlap(const Spread &a, const Spread &b, const double s)
    {
      const double from = std::max(-a.half, s - b.half), to = std::min(a.half, s + b.half);
      double       sum = 0;
      if (from < to)
        gauss(from, to, [&](const double z, const double weight) { sum += weight * a.at(z) * b.at(z - s); });
      return sum;
    }
  } // namespace


  double
  Spread::at(const double s) const
  {
    switch (kind)
      {
        case bump:
          return (1 + std::cos(M_PI * s / half)) / (2 * half);
        case even:
          return 1 / (2 * half);
        default:
          return std::sqrt(3.) * s / (2 * half * half);
      }
  }


  SpreadPair::SpreadPair(const Spread &a, const Spread &b, const double ahead, const bool odd)
  {
    // kinks: where both meet, where one begins to lie within the other
    const double        reach = a.half + b.half, inner = std::abs(a.half - b.half);
    std::vector<double> borders = {-reach, -inner, inner, reach};
    if (std::abs(ahead) < reach)
      // near fields die fast: panels shrink towards the distance zero
      for (const double part : {0., 0.003, 0.01, 0.03, 0.1, 0.3})
        for (const double side : {-1., 1.})
          borders.push_back(std::clamp(-ahead + side * part * reach, -reach, reach));
    std::sort(borders.begin(), borders.end());
    for (std::size_t p = 0; p + 1 < borders.size(); ++p)
      if (borders[p + 1] > borders[p])
        gauss(borders[p], borders[p + 1], [&](const double s, const double part) {
          const double x = ahead + s;
          distance.push_back(std::abs(x));
          weight.push_back(part * overlap(a, b, s) * (odd && x < 0 ? -1 : 1));
        });
  }


  std::complex<double>
  SpreadPair::mean(const std::complex<double> k) const
  {
    const std::complex<double> factor = std::complex<double>(0, -1) * k;
    std::complex<double>       sum    = 0;
    for (std::size_t n = 0; n < distance.size(); ++n)
      sum += weight[n] * std::exp(factor * distance[n]);
    return sum;
  }
} // namespace wheelrail
