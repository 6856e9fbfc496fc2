#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scenes
{
  using namespace wheelrail;

  namespace
  {
    /// x at t of a polygon through equidistant breakpoints.
    double
    interpolate(const std::vector<double> &points, const double t)
    {
      const double       s = t * (points.size() - 1);
      const unsigned int k = std::min<double>(s, points.size() - 2);
      return points[k] + (s - k) * (points[k + 1] - points[k]);
    }
  } // namespace


  LocalMesh
  quarter_cylinder(const double inner,
                   const double outer,
                   const double height,
                   const Cells &cells,
                   const double growth)
  {
    const auto place = [=, radial = graded(cells[0], growth)](const Vector3 &s) -> Vector3 {
      const double r = inner + (outer - inner) * interpolate(radial, s[0]), angle = M_PI / 2 * s[1];
      return {r * std::cos(angle), r * std::sin(angle), height * s[2]};
    };
    return make_mesh({{cells, place}});
  }


  LocalMesh
  sphere_octant(const double       inner,
                const double       outer,
                const unsigned int radial,
                const unsigned int n,
                const double       growth)
  {
    std::vector<Block> blocks;
    for (int axis = 0; axis < 3; ++axis)
      blocks.push_back({{n, n, radial}, [=, points = graded(radial, growth)](const Vector3 &s) -> Vector3 {
                          // plane coordinates of the triangle x + y + z = 1, projected to the sphere
                          const double p = s[0], q = s[1];
                          Vector3      weight;
                          weight[axis]           = 1 - (p + q) / 2 + p * q / 3;
                          weight[(axis + 1) % 3] = p / 2 - p * q / 6;
                          weight[(axis + 2) % 3] = q / 2 - p * q / 6;
                          return (inner + (outer - inner) * interpolate(points, s[2])) * normalised(weight);
                        }});
    return make_mesh(blocks);
  }


  LocalMesh
  quarter_ball(const double radius, const BallCells &cells)
  {
    // sizes along an edge from the pole: even first, then growing up to the length of the cube's edge
    const auto breakpoints = [&](const double length) {
      std::vector<double> points = {0};
      double              size   = cells.fine_size;
      while (points.back() < length)
        {
          points.push_back(points.back() + size);
          if (points.back() > cells.fine_radius)
            size = std::min(size * cells.growth, cells.largest);
        }
      if (points.size() > 2 && points.back() - length > length - points[points.size() - 2])
        points.pop_back();
      const double whole = points.back();
      for (double &p : points)
        p /= whole;
      return points;
    };
    const double half    = 0.75 * radius; // half edge of the core, whose faces bulge
    const auto   across  = breakpoints(M_PI / 4 * radius),
               down      = breakpoints(radius - half * (1 + std::sqrt(0.5)) / 2);
    const unsigned int n = across.size() - 1, m = down.size() - 1, u = cells.upper;

    // place on the core: box of half edge with faces bulged towards the sphere; s from -1 to 1
    const auto core = [=](const Vector3 &s) -> Vector3 {
      Vector3      d;
      const double largest = std::max({std::abs(s[0]), std::abs(s[1]), std::abs(s[2])});
      if (largest == 0)
        return {0, 0, 0};
      for (int i = 0; i < 3; ++i)
        d[i] = std::tan(M_PI / 4 * s[i] / largest);
      const Vector3 sphere = (largest * half) * normalised(d), cube = (largest * half / std::sqrt(2.)) * d;
      const double  share = 0.5 * largest;
      return share * sphere + (1 - share) * cube;
    };
    const auto shell = [=](const Vector3 &face, const double t) -> Vector3 {
      const Vector3 on_core = core(face);
      Vector3       d;
      for (int i = 0; i < 3; ++i)
        d[i] = std::tan(M_PI / 4 * face[i]);
      return (1 - t) * on_core + (t * radius) * normalised(d);
    };
    const double centre = radius;
    const auto   lift   = [centre](const Vector3 &X) -> Vector3 { return {X[0], X[1], X[2] + centre}; };
    const auto   g      = [across](const double t) { return interpolate(across, t); };
    // the vertical coordinate of core and sides: from -1 (or 0) evenly to 1 (or 0)
    const double       top = cells.half ? 0 : 1;
    const unsigned int v   = cells.half ? u : 2 * u;
    const auto         z   = [top](const double t) { return -1 + t * (1 + top); };

    std::vector<Block> blocks;
    blocks.push_back({{n, n, v}, [=](const Vector3 &s) { return lift(core({g(s[0]), g(s[1]), z(s[2])})); }});
    blocks.push_back({{n, n, m}, [=](const Vector3 &s) {
                        return lift(shell({g(s[0]), g(s[1]), -1}, 1 - interpolate(down, s[2])));
                      }});
    blocks.push_back({{u, n, v}, [=](const Vector3 &s) { return lift(shell({1, g(s[1]), z(s[2])}, s[0])); }});
    blocks.push_back({{n, u, v}, [=](const Vector3 &s) { return lift(shell({g(s[0]), 1, z(s[2])}, s[1])); }});
    if (!cells.half)
      blocks.push_back({{n, n, u}, [=](const Vector3 &s) {
                          return lift(shell({g(s[0]), g(s[1]), 1}, s[2]));
                        }});
    return make_mesh(blocks);
  }


  std::vector<double>
  graded(const unsigned int n, const double ratio)
  {
    const double        factor = n > 1 ? std::pow(ratio, 1. / (n - 1)) : 1;
    std::vector<double> points = {0};
    double              size   = 1;
    for (unsigned int k = 0; k < n; ++k, size *= factor)
      points.push_back(points.back() + size);
    for (double &p : points)
      p /= points.back();
    return points;
  }
} // namespace scenes
