// label: fast

// The half-space contact of a scene against CONTACT: wheel moved against the rail, rail head turned, three
// loads.

#include "reference_table.h"

#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/wheel/halfspace_case.h>

#include <string>
#include <vector>

using namespace wheelrail;
using test::near;
using test::near_relative;

namespace
{
  struct Row
  {
    double lateral, inclination, load, force, normal, lateral_on_rail, peak, area, shear, creepage, spin,
      angle;
  };

  std::vector<Row>
  read_rows()
  {
    std::vector<Row> rows;
    for (const auto &cells : test::read_table("contact_pose_54E1.csv"))
      {
        const auto number = [&](const int column) { return std::stod(cells[column]); };
        rows.push_back({number(1) * 1e-3,
                        number(2) * 1e-3,
                        number(3),
                        number(4),
                        number(5),
                        number(6),
                        number(7) * 1e6,
                        number(8) * 1e-6,
                        number(11) * 1e6,
                        number(12),
                        number(13) * 1e3,
                        number(14)});
      }
    return rows;
  }
} // namespace


BOOST_AUTO_TEST_CASE(halfspace_pose)
{
  Scene scene;
  scene.velocity               = 10;
  scene.halfspace_spin         = HalfspaceSpin::contact;
  const SceneGeometry geometry = make_geometry(scene);
  for (const Row &row : read_rows())
    {
      WheelRailLoad load;
      load.force               = row.load;
      load.vertical            = true;
      load.longitudinal        = -row.force;
      const auto        result = solve_wheel_rail(scene, geometry, load, {row.lateral, -row.inclination, 0});
      const auto       &s      = result.solution;
      const std::string name   = std::to_string(row.lateral * 1e3) + " mm, " +
                               std::to_string(row.inclination * 1e3) + " mrad, " +
                               std::to_string(row.load * 1e-3) + " kN: ";
      BOOST_TEST((s.converged() && !s.touches_grid_edge), name + "converged");
      BOOST_TEST(near_relative(s.fn, row.normal, 0.001, name + "normal force"));
      BOOST_TEST(near_relative(s.peak_pressure, row.peak, 0.01, name + "peak pressure"));
      BOOST_TEST(near_relative(s.area, row.area, 0.01, name + "area"));
      BOOST_TEST(near_relative(s.peak_shear, row.shear, 0.03, name + "peak shear"));
      // CONTACT's weights of its mean angle are not known, here they are the pressure
      // (doc/theory/accuracy.md)
      BOOST_TEST(near(-result.angle, row.angle, 1.5e-3, name + "contact angle"));
      BOOST_TEST(near(result.spin, row.spin, 3e-3, name + "spin"));
      BOOST_TEST(near(result.lateral, -row.lateral_on_rail, 0.002 * row.load, name + "lateral force"));
      BOOST_TEST(near(result.vertical, row.load, 1, name + "vertical force"));
    }
}
