#include <wheelrail/mesh/section.h>

#include <algorithm>
#include <limits>

namespace wheelrail
{
  namespace
  {
    // Point of the edge from corner a to corner b, whichever way its curve is stored.
    Point2
    edge_point(const Section &section, const unsigned int a, const unsigned int b, const double t)
    {
      const auto curve = section.curved.find({{std::min(a, b), std::max(a, b)}});
      if (curve == section.curved.end())
        return (1 - t) * section.corners[a] + t * section.corners[b];
      return curve->second(a < b ? t : 1 - t);
    }

    void
    add_quadrilateral(const std::array<Point2, 4> &p, SectionQuality &quality)
    {
      for (unsigned int i = 0; i < 4; ++i)
        {
          const Point2 ahead = p[(i + 1) % 4] - p[i], behind = p[(i + 3) % 4] - p[i];
          const double a = norm(ahead), b = norm(behind);
          quality.area += 0.5 * cross(p[i], p[(i + 1) % 4]);
          quality.min_edge = std::min(quality.min_edge, a);
          quality.max_edge = std::max(quality.max_edge, a);
          quality.min_scaled_jacobian =
            std::min(quality.min_scaled_jacobian, a * b > 0 ? cross(ahead, behind) / (a * b) : 0.);
        }
    }
  } // namespace


  Point2
  Section::position(const unsigned int block, const double xi, const double eta) const
  {
    const auto  &c      = blocks[block].corner;
    const Point2 bottom = edge_point(*this, c[0], c[1], xi), top = edge_point(*this, c[2], c[3], xi);
    const Point2 left = edge_point(*this, c[0], c[2], eta), right = edge_point(*this, c[1], c[3], eta);

    const Point2 bilinear = (1 - eta) * ((1 - xi) * corners[c[0]] + xi * corners[c[1]]) +
                            eta * ((1 - xi) * corners[c[2]] + xi * corners[c[3]]);
    return (1 - eta) * bottom + eta * top + (1 - xi) * left + xi * right - bilinear;
  }


  SectionQuality
  block_quality(const Section &section, const unsigned int block, const unsigned int subdivisions)
  {
    SectionQuality quality;
    quality.min_edge = std::numeric_limits<double>::max();

    const unsigned int  n = subdivisions + 1;
    std::vector<Point2> points;
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        points.push_back(section.position(block, double(i) / subdivisions, double(j) / subdivisions));

    for (unsigned int j = 0; j < subdivisions; ++j)
      for (unsigned int i = 0; i < subdivisions; ++i)
        {
          const unsigned int k = j * n + i;
          add_quadrilateral({{points[k], points[k + 1], points[k + n + 1], points[k + n]}}, quality);
        }
    return quality;
  }

} // namespace wheelrail
