#pragma once

// Slices files of tests and the files of their slices, in the working folder.

#include "reference_table.h"

#include <wheelrail/geometry/plane.h>
#include <wheelrail/geometry/profiles.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace test
{
  inline void
  write_points(const std::string &file, const std::vector<wheelrail::Point2> &points)
  {
    std::ofstream out(file);
    out.precision(12);
    for (const wheelrail::Point2 &p : points)
      out << p.x << ' ' << p.y << '\n';
  }

  /// The head of 54E1 [mm], y down, about each 0.3 mm.
  inline std::vector<wheelrail::Point2>
  head_points()
  {
    const wheelrail::Curve         head = wheelrail::rail_profile("54E1").head;
    std::vector<wheelrail::Point2> points;
    for (double t = head.parameter_end(), step = 0.3e-3; t > 1e-9; t = head.advance(t, -step))
      if (const wheelrail::Point2 p = head.at(t).position; p.y > -20e-3)
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

  /// The slices of an artificial part of nose_wing_sections.csv.
  inline void
  write_part(const std::string &part)
  {
    std::vector<wheelrail::Point2> last;
    for (const auto &row : read_table("nose_wing_sections.csv"))
      if (row[0] == part)
        last.push_back({std::stod(row[1]), std::stod(row[2])});
    const bool    nose = part == "nose";
    std::ofstream out(part + ".slcs");
    out.precision(10);
    out << "0 1 U_OFFSET U_SCALE\n21 NSLC\n5 0 0 NFEAT NKINK NACCEL\n1 U_INTPOL\n";
    for (int k = 0; k < 21; ++k)
      {
        std::vector<wheelrail::Point2> points = last;
        if (nose)
          points.resize(506 + 10 * k);
        else
          points.erase(points.begin(), points.end() - (526 + 5 * k));
        for (wheelrail::Point2 &p : points)
          p = p + wheelrail::Point2{nose ? 0. : k - 20., nose ? 20. - k : 0.};
        const std::string file = part + std::to_string(k) + ".txt";
        write_points(file, points);
        out << (nose ? -100 : 0) + 10 * k << " '" << file << "'\n";
      }
    for (int k = 0; k < 21; ++k)
      if (nose)
        out << -100 + 10 * k << " 0 33.0541 50.9076 87.0158 299\n";
      else
        out << 10 * k << " 0 " << 3.9267 + k << ' ' << 43.0894 + k << ' ' << 68.7971 + k << " 299\n";
  }

  /// The slices of CONTACT's wheel, written as its own files are.
  inline void
  write_flat(const std::string &name)
  {
    std::ofstream slices(name);
    const auto    rows = read_table("rounded_flat_slices.csv");
    slices << "% cylinder with a flat\n\n 0.000 1 TH_OFFSET [usr], TH_SCALE [rad/usr]\n " << rows.size()
           << " NSLC\n 0 0 0 NFEAT, NKINK, NACCEL\n 2 TH_INTPOL (1=intpol, 2=approx)\n";
    char line[80];
    for (std::size_t k = 0; k < rows.size(); ++k)
      {
        const std::string file = "flat_" + std::to_string(k + 1) + ".txt";
        slices << rows[k][0] << " '" << file << "'\n";
        std::ofstream points(file);
        for (int i = 0; i <= 130; ++i)
          {
            const double y = -30.20927 + 0.464758 * i;
            std::snprintf(
              line, sizeof line, "%.6f %.6f\n", y, std::min(0., y * y / 600 - std::stod(rows[k][1])));
            points << line;
          }
      }
  }
} // namespace test
