// label: fast

// S1002 on 54E1 at shift 0 in the half-space solver against CONTACT: element table, driving, braking, no
// traction, three grids.

#include "element_table.h"
#include "wheel_rail_contact.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;
using test::near_relative;

namespace
{
  /// The undeformed distance from our own profiles; CONTACT's differs by up to 0.3 micrometres.
  BOOST_AUTO_TEST_CASE(test_variants)
  {
    for (const auto &row : test::read_table("contact_wheel_rail_54E1.csv"))
      {
        const auto number = [&](const int column) { return std::stod(row[column]); };
        const auto s      = solve_rolling(
          test::wheel_rail_contact(0.25e-3, std::abs(number(4)) < 1 ? 0 : number(4), number(23) * 1e3));
        const std::string name = row[0] + ": ";
        BOOST_TEST((s.converged() && !s.touches_grid_edge), name + "converged");
        BOOST_TEST(near_relative(s.peak_pressure, number(11) * 1e6, 0.002, name + "peak pressure"));
        BOOST_TEST(near_relative(s.area, number(12) * 1e-6, 0.005, name + "area"));
        BOOST_TEST(near_relative(s.adhesion_area, number(13) * 1e-6, 0.005, name + "area of adhesion"));
        BOOST_TEST(near_relative(s.width_y, number(15) * 1e-3, 0.015, name + "width"));
        BOOST_TEST(near_relative(s.length_x, number(16) * 1e-3, 0.02, name + "length"));
        BOOST_TEST(near_relative(s.peak_shear, number(17) * 1e6, 0.006, name + "peak shear"));
        BOOST_TEST(near(s.xi, number(21), 3e-6, name + "creepage"));
      }
  }

  /// dx 0.5 and 0.125 mm of the driving wheel (rows of CONTACT at shift 0).
  BOOST_AUTO_TEST_CASE(test_grids)
  {
    struct Row
    {
      double dx, peak, area, shear, xi;
    };
    for (const Row &row : {Row{0.5e-3, 1285.96, 179.75, 572.8267, 0.001689},
                           Row{0.125e-3, 1288.28, 176.6406, 580.7715, 0.001728}})
      {
        const auto        s    = solve_rolling(test::wheel_rail_contact(row.dx, -25e3, -0.1107));
        const std::string name = "driving at " + std::to_string(row.dx * 1e3) + " mm: ";
        BOOST_TEST(s.converged(), name + "converged");
        BOOST_TEST(near_relative(s.peak_pressure, row.peak * 1e6, 0.002, name + "peak pressure"));
        BOOST_TEST(near_relative(s.area, row.area * 1e-6, 0.005, name + "area"));
        BOOST_TEST(near_relative(s.peak_shear, row.shear * 1e6, 0.003, name + "peak shear"));
        BOOST_TEST(near_relative(s.xi, row.xi, 0.002, name + "creepage"));
      }
  }

  /// CONTACT's own undeformed distance: h(0, y) and the curvature along x of each row of the element table,
  /// carried on beyond the contact.
  std::vector<double>
  table_distance(const HalfspaceGrid &grid, const std::vector<std::vector<std::string>> &table)
  {
    std::vector<double> h0(grid.my, -1.), curvature(grid.my, 0.), far(grid.my, 0.);
    for (int pass = 0; pass < 2; ++pass)
      for (const auto &row : table)
        {
          const double x = std::stod(row[0]) * 1e-3, h = std::stod(row[7]) * 1e-3;
          const int    j = int(std::round((std::stod(row[1]) * 1e-3 - grid.y0) / grid.dy));
          if (pass == 0 && x == 0)
            h0[j] = h;
          if (pass == 1 && x > far[j])
            {
              far[j]       = x;
              curvature[j] = (h - h0[j]) / (x * x);
            }
        }
    const int first = int(std::find_if(h0.begin(), h0.end(), [](double h) { return h >= 0; }) - h0.begin());
    int       last  = first;
    while (last + 1 < grid.my && h0[last + 1] >= 0)
      ++last;
    for (int j = first - 1; j >= 0; --j)
      {
        h0[j]        = 3 * h0[j + 1] - 3 * h0[j + 2] + h0[j + 3];
        curvature[j] = curvature[first + 2];
      }
    for (int j = last + 1; j < grid.my; ++j)
      {
        h0[j]        = 3 * h0[j - 1] - 3 * h0[j - 2] + h0[j - 3];
        curvature[j] = curvature[last - 2];
      }
    std::vector<double> distance(grid.size());
    for (int j = 0; j < grid.my; ++j)
      for (int i = 0; i < grid.mx; ++i)
        distance[i + grid.mx * j] = h0[j] + curvature[j] * grid.x(i) * grid.x(i);
    return distance;
  }

  BOOST_AUTO_TEST_CASE(test_field)
  {
    const auto       table      = test::read_table("contact_field_54E1.csv");
    HalfspaceProblem problem    = test::wheel_rail_contact(0.25e-3, -25e3, -0.1107);
    problem.undeformed_distance = table_distance(problem.grid, table);
    const auto s                = solve_rolling(problem);
    test::check_element_table(s, table, 3e-4, 3);
    BOOST_TEST(near(s.contact_elements, table.size(), 4, "contact elements of the table"));
  }
} // namespace
