#pragma once

// Half-spaces of a wheelset with yaw against CONTACT, rows of contact_wheel_rail_54E1_yaw.csv.

#include "reference_table.h"

#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/wheel/halfspace_case.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace test
{
  /// Checks one row: peak 0.5 %, area 1 %, forces 1 % of the load, creepages 1 %, angle 1.5 mrad, place 0.1
  /// mm across and 0.5 mm along the rail.
  inline void
  check_yaw_row(const std::vector<std::string> &row)
  {
    using namespace wheelrail;
    const auto   number = [&](const int column) { return std::stod(row[column]); };
    const double load   = 100e3;
    Scene        scene;
    scene.wheel_load                 = load;
    scene.lateral_shift              = 1e-3 * number(0);
    scene.yaw                        = 1e-3 * number(1);
    scene.traction_coefficient       = -number(3) / load;
    scene.velocity                   = 38.889;
    scene.halfspace_element_size     = 0.25e-3;
    scene.halfspace_spin             = HalfspaceSpin::contact;
    const SceneGeometry     geometry = make_geometry(scene);
    const WheelRailSolution result =
      solve_wheel_rail(scene, geometry, scene_load(scene, geometry), scene_offsets(scene));
    const HalfspaceSolution &s     = result.solution;
    const ContactReference  &at    = *result.reference;
    const std::string        which = "shift " + row[0] + ", yaw " + row[1] + ", Fx " + row[3] + ": ";

    BOOST_TEST((s.converged() && !s.touches_grid_edge), which + "converged");
    BOOST_TEST(near(1e-6 * s.peak_pressure / number(36), 1, 0.005, which + "peak pressure over CONTACT's"));
    BOOST_TEST(near(1e6 * s.area / number(39), 1, 0.01, which + "area over CONTACT's"));
    // it stands at a kink of the traction and still grows with finer elements
    BOOST_TEST(near(1e-6 * s.peak_shear / number(48), 1, 0.02, which + "peak shear over CONTACT's"));
    const double few = 0.01 * load;
    BOOST_TEST(near(s.fn, number(21), few, which + "normal force [N]"));
    BOOST_TEST(near(s.fx, number(25), few, which + "force along the rail [N]"));
    BOOST_TEST(near(-result.lateral, number(26), few, which + "lateral force on the rail [N]"));
    BOOST_TEST(near(result.vertical, load, 0.002 * load, which + "vertical force [N]"));
    BOOST_TEST(near(-at.driving, number(28), few, which + "force along the wheelset, on the rail [N]"));
    BOOST_TEST(near(-at.across, number(29), few, which + "force along the axle, on the rail [N]"));
    // where CONTACT's reference point lies 0.03 mm off, the tread's radius changes by 1.5 um
    BOOST_TEST(
      near(at.creepage, number(32), std::max(0.01 * std::abs(number(32)), 4e-6), which + "creepage"));
    BOOST_TEST(
      near(-at.lateral_creepage, number(33), 0.01 * std::abs(number(33)) + 1e-9, which + "lateral creepage"));
    BOOST_TEST(near(at.spin / (1e3 * number(34)), 1, 0.01, which + "spin over CONTACT's"));
    BOOST_TEST(near(at.angle, number(20), 1.5e-3, which + "contact angle [rad]"));
    BOOST_TEST(near(at.place.x, 0.75 + 1e-3 * number(13), 0.1e-3, which + "lateral place [m]"));
    BOOST_TEST(near(at.along, 1e-3 * number(12), 0.5e-3, which + "place along the track [m]"));
    BOOST_TEST(near(at.ahead, 1e-3 * number(17), 0.5e-3, which + "place ahead of the axle [m]"));
  }
} // namespace test
