// Both wheels of case of the Manchester contact benchmark against CONTACT.

#include "manchester.h"
#include "reference_table.h"

#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/reference/halfspace_case.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace wheelrail;
using test::check;
using test::check_near;

namespace
{
  constexpr double load = 10e3;

  Scene
  benchmark_scene()
  {
    Scene scene                  = test::manchester_scene();
    scene.velocity               = 2;
    scene.wheel_load             = load;
    scene.friction_coefficient   = 0.3;
    scene.halfspace_element_size = 0.2e-3;
    scene.halfspace_spin         = HalfspaceSpin::contact;
    scene.roll                   = RollMode::given;
    scene.drive                  = Drive::rate;
    for (MaterialData *steel : {&scene.rail_material, &scene.wheel_material})
      {
        steel->youngs_modulus = 2 * 82e9 * 1.28;
        steel->poissons_ratio = 0.28;
      }
    return scene;
  }

  /// Peak 0.5 %, area 1 %, forces 1 % of the load, creepages 1 %, angle 1.5 mrad, place 0.1 mm across and 0.5
  /// mm along the rail.
  void
  check_row(const std::vector<std::string> &row)
  {
    const auto   number = [&](const int column) { return std::stod(row[column]); };
    const bool   left   = row[0] == "left";
    const double mirror = left ? 1 : -1; // the modelled wheel is the left one of the file in the mirror
    Scene        scene  = benchmark_scene();
    scene.lateral_shift = mirror * 1e-3 * number(2);
    scene.yaw           = mirror * 1e-3 * number(3);
    scene.roll_angle    = -mirror * 1e-3 * number(4);
    const SceneGeometry geometry = make_geometry(scene);
    // the wheelset turns with this rate in the benchmark
    scene.creepage = -number(7) * geometry.contact.rolling_radius * std::cos(scene.yaw) / scene.velocity - 1;
    const WheelRailSolution result =
      solve_wheel_rail(scene, geometry, scene_load(scene, geometry), scene_offsets(scene));
    const HalfspaceSolution &s     = result.solution;
    const ContactReference  &at    = *result.reference;
    const std::string        which = row[0] + " wheel, shift " + row[2] + " mm: ";

    check(s.converged() && !s.touches_grid_edge, which + "converged");
    check_near(1e-6 * s.peak_pressure / number(36), 1, 0.005, which + "peak pressure over CONTACT's");
    check_near(1e6 * s.area / number(40), 1, 0.01, which + "area over CONTACT's");
    check_near(1e-6 * s.peak_shear / number(39), 1, 0.01, which + "peak shear over CONTACT's");
    const double few = 0.01 * load;
    check_near(s.fn, number(21), few, which + "normal force [N]");
    check_near(s.fx, number(25), few, which + "force along the rail [N]");
    check_near(-result.lateral, mirror * number(26), few, which + "lateral force on the rail [N]");
    check_near(result.vertical, load, 0.002 * load, which + "vertical force [N]");
    check_near(-at.driving, number(28), few, which + "force along the wheelset, on the rail [N]");
    check_near(-at.across, mirror * number(29), few, which + "force along the axle, on the rail [N]");
    // a rolling radius that is 2 um off is a creepage of 4e-6
    check_near(at.creepage, number(31), std::max(0.01 * std::abs(number(31)), 4e-6), which + "creepage");
    check_near(-at.lateral_creepage,
               mirror * number(32),
               0.01 * std::abs(number(32)) + 1e-9,
               which + "lateral creepage");
    check_near(mirror * at.spin / (1e3 * number(33)), 1, 0.01, which + "spin over CONTACT's");
    check_near(at.angle, mirror * number(20), 1.5e-3, which + "contact angle [rad]");
    check_near(at.place.x, 0.75 + mirror * 1e-3 * number(13), 0.1e-3, which + "lateral place [m]");
    check_near(at.along, 1e-3 * number(12), 0.5e-3, which + "place along the track [m]");
    check_near(at.ahead, 1e-3 * number(17), 0.5e-3, which + "place ahead of the axle [m]");
  }
} // namespace

int
main()
{
  for (const auto &row : test::read_table("contact_manchester_a22.csv"))
    check_row(row);
  return test::report();
}
