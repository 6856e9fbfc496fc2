#pragma once

// Slices of a rail whose head is that of 54E1.

#include <wheelrail/geometry/profiles.h>

#include <fstream>
#include <string>
#include <vector>

namespace test
{
  using wheelrail::Point2;

  inline void
  write_points(const std::string &file, const std::vector<Point2> &points)
  {
    std::ofstream out(file);
    out.precision(12);
    for (const Point2 &p : points)
      out << p.x << ' ' << p.y << '\n';
  }

  /// The head of 54E1 [mm], y down, about each 0.3 mm.
  inline std::vector<Point2>
  head_points()
  {
    const wheelrail::Curve head = wheelrail::rail_profile("54E1").head;
    std::vector<Point2>    points;
    for (double t = head.parameter_end(), step = 0.3e-3; t > 1e-9; t = head.advance(t, -step))
      if (const Point2 p = head.at(t).position; p.y > -20e-3)
        points.push_back({1e3 * p.x, -1e3 * p.y});
    return points;
  }

  /// Slices of one section from `begin` to `end` [mm].
  inline void
  write_slices(const std::string &name, const std::string &section, const double begin, const double end)
  {
    std::ofstream out(name);
    out << "0 1 U_OFFSET U_SCALE\n5 NSLC\n0 0 0 NFEAT NKINK NACCEL\n1 U_INTPOL\n";
    for (int k = 0; k < 5; ++k)
      out << begin + (end - begin) * k / 4 << " '" << section << "'\n";
  }
} // namespace test
