// label: fast

// Laws of wear and cracks at their breakpoints, and wear across the rail against the work that is done.

#include "near.h"

#include <wheelrail/base/read_file.h>
#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/input/parameters.h>
#include <wheelrail/vehicle/wheelset_contact.h>
#include <wheelrail/wheel/halfspace_case.h>
#include <wheelrail/wheel/halfspace_parts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

using namespace wheelrail;
using test::near;

namespace
{
  BOOST_AUTO_TEST_CASE(test_laws)
  {
    const auto rate = [](const double t) { return 1e3 * usfd_wear_rate(1e6 * t); }; // ug/(m mm2)
    BOOST_TEST(near(rate(1), 5.3, 1e-12, "5.3 T/A ug/(m mm2)"));
    BOOST_TEST(near(rate(10.4), 55.0, 1e-12, "55.0 from 10.4 N/mm2 on"));
    BOOST_TEST(near(rate(10.4 - 1e-9), 55.0, 1e-6, "to which the first branch rises"));
    BOOST_TEST(near(rate(77), 55.0, 1e-12, "to 77.2 N/mm2"));
    BOOST_TEST(near(rate(77.2 + 1e-9), 55.0, 1e-6, "and on, where the source jumps to nothing"));
    BOOST_TEST(near(rate(100), 61.9 * 100 - 4778.7, 1e-9, "then 61.9 T/A - 4778.7"));
    BOOST_TEST(std::isnan(rate(std::nan(""))), "no rate where T-gamma is not determined");
    BOOST_TEST(near(rate(4778.7 / 61.9 + 55 / 61.9), 55, 1e-9, "which begins at the plateau"));

    const WearData data;
    BOOST_TEST(near(burstow_damage(15, data), 0, 0, "no damage at 15 N"));
    BOOST_TEST(near(burstow_damage(40, data), 0.5e-5, 1e-18, "half of it at 40 N"));
    BOOST_TEST(near(burstow_damage(65, data), 1e-5, 1e-18, "all at 65 N"));
    BOOST_TEST(near(burstow_damage(120, data), 0.5e-5, 1e-18, "half of it at 120 N"));
    BOOST_TEST(near(burstow_damage(175, data), 0, 0, "none at 175 N"));
    BOOST_TEST(near(burstow_damage(500, data), 0, 0, "none beyond"));

    BOOST_TEST(near(fatigue_index(0.3, 300e6, 1000e6), 0, 1e-15, "the surface fatigues above mu = k/p0"));
    BOOST_TEST(near(shakedown_limit(0), 4, 1e-12, "line contact shakes down up to 4 k (Johnson 1985)"));
    BOOST_TEST(
      near(shakedown_limit(-0.2), 3.202, 1e-12, "with traction up to less, whichever way it points"));
    BOOST_TEST(
      near(shakedown_limit(1.2) / shakedown_limit(0.6), 0.5, 1e-12, "then by the traction of the surface"));
    BOOST_TEST(near(archard_coefficient(0.1, 1e9, data), 5e-4, 0, "mild wear"));
    BOOST_TEST(near(archard_coefficient(0.5, 1e9, data), 35e-4, 0, "severe wear at 0.2 to 0.7 m/s"));
    BOOST_TEST(near(archard_coefficient(1, 1e9, data), 5e-4, 0, "mild again"));
    BOOST_TEST(near(archard_coefficient(0.1, 2.1e9, data), 350e-4, 0, "seizure above 0.8 H"));
  }

  /// Pages draw the limits by which elastic results are judged.
  BOOST_AUTO_TEST_CASE(test_drawn_limits)
  {
    std::istringstream script(read_whole_file(WHEELRAIL_SOURCE_DIR "/source/report/shakedown.py"));
    std::string        line;
    while (std::getline(script, line) && line.rfind("SHAKEDOWN = [", 0) != 0)
      ;
    std::istringstream numbers(line.substr(line.find('[') + 1));
    int                k = 0;
    for (double limit = 0; numbers >> limit; ++k, numbers.ignore())
      BOOST_TEST(near(shakedown_limit(0.05 * k), limit, 1e-9, "limit of shakedown of the picture"));
    BOOST_TEST(k == 13, "all of the picture's limits");
  }

  /// V = k F s / H of whatever shape: a wheel that slides as a whole, and the main scene.
  BOOST_AUTO_TEST_CASE(test_volume)
  {
    Scene scene                      = {};
    scene.wheel_load                 = 80e3;
    scene.halfspace_element_size     = 0.8e-3;
    scene.wear.archard               = 1e-3;
    scene.drive                      = Drive::rate;
    scene.creepage                   = 0.05;
    const SceneGeometry     geometry = make_geometry(scene);
    const WheelRailSolution result =
      solve_wheel_rail(scene, geometry, scene_load(scene, geometry), scene_offsets(scene));
    const WearProfile profile = wear_profile(result.patch, scene.velocity, scene.wear);
    double            slid = 0, work = 0; // force times way, for each metre rolled [N]
    for (std::size_t e = 0; e < result.patch.pressure.size(); ++e)
      {
        slid += result.patch.pressure[e] * result.patch.area[e] *
                std::hypot(result.patch.slip_along[e], result.patch.slip_lateral[e]);
        work += result.patch.area[e] * (result.patch.traction_along[e] * result.patch.slip_along[e] +
                                        result.patch.traction_lateral[e] * result.patch.slip_lateral[e]);
      }
    BOOST_TEST(near(over_width(profile, profile.depth) / (scene.wear.archard * slid / scene.wear.hardness),
                    1,
                    1e-12,
                    "section that is worn over k F s / H"));
    BOOST_TEST(near(work / (scene.friction.at_rest * slid),
                    1,
                    1e-9,
                    "where all slides, work is friction times force times way"));
    BOOST_TEST(near(over_width(profile, profile.work) / work, 1, 1e-12, "work over the width"));
    BOOST_TEST(near(work / result.solution.creepage_work, 1, 0.01, "which is T-gamma where all slides"));
    const WearProfile passed = halfspace_wear(result.problem, result.solution, scene.velocity, scene.wear);
    BOOST_TEST(near(over_width(passed, passed.depth) / over_width(profile, profile.depth),
                    1,
                    0.01,
                    "section from the ways of particles, where all slides"));
    BOOST_TEST(near(over_width(passed, passed.work) / result.solution.friction_work, 1, 1e-12, "their work"));
  }

  /// A ball that slides over a flat becomes a cap: pi h^2 (R - h/3) = k F s / H. Its worn shape is a ball
  /// with a flat of depth h at each moment; half-spaces press it on, and the ball loses what a passage takes.
  /// 1 kN over 1 km with k/H = 1e-8 mm2/N are 10 mm3, of a ball of 10 mm a cap of 0.5696 mm (as a paraboloid
  /// 0.5642 mm).
  BOOST_AUTO_TEST_CASE(test_ball)
  {
    constexpr double ball = 10e-3, load = 1e3, way = 1e3, stages = 8;
    WearData         data;
    data.hardness                    = 2.5e9;
    data.archard                     = 1e-14 * data.hardness;
    const auto volume_for_each_metre = [&](const double depth) {
      const double     flat = std::sqrt(depth * (2 * ball - depth)), reach = 1.15 * flat + 1e-3;
      HalfspaceProblem problem;
      problem.grid                = centred_grid(reach, reach, reach / 30, reach / 30);
      problem.undeformed_distance = sampled_distance(problem.grid, [&](const double x, const double y) {
        return std::max(0., ball - std::sqrt(ball * ball - x * x - y * y) - depth);
      });
      problem.normal_force        = load;
      problem.xi                  = -1; // it slides, everywhere
      const HalfspaceSolution s   = solve_rolling(problem);
      BOOST_TEST((s.converged() && !s.touches_grid_edge), "the contact of the worn ball is solved");
      const WearProfile worn = wear_profile(halfspace_patch(s), 1, data);
      return over_width(worn, worn.depth);
    };
    // dh/ds = (dV/ds) / (pi h (2 R - h)), from the first cap on that the load presses flat; midpoints in V
    double     volume = 0;
    const auto cap    = [&](const double of) { // depth of a cap of that volume, by Newton
      double h = std::sqrt(of / (M_PI * ball));
      for (int k = 0; k < 50; ++k)
        h -= (M_PI * h * h * (ball - h / 3) - of) / (M_PI * h * (2 * ball - h));
      return h;
    };
    for (int k = 0; k < stages; ++k)
      {
        const double step = way / stages, middle = volume + 0.5 * step * 1e-14 * load;
        volume += step * volume_for_each_metre(cap(middle));
      }
    BOOST_TEST(near(volume / (1e-14 * load * way), 1, 1e-3, "volume that the ball lost over k F s / H"));
    BOOST_TEST(near(1e3 * cap(volume), 0.5696, 0.5696e-3, "depth of the cap [mm]"));
  }

  /// Work of friction and work of the creepages of the main scene.
  BOOST_AUTO_TEST_CASE(test_readings)
  {
    const Scene             scene    = read_scene(WHEELRAIL_SOURCE_DIR "/prm/rolling.prm", {}).scene;
    const SceneGeometry     geometry = make_geometry(scene);
    const WheelRailSolution result =
      solve_wheel_rail(scene, geometry, scene_load(scene, geometry), scene_offsets(scene));
    const Summary figures = halfspace_summary(scene, result);
    // the mean of the tractions of two elements is half an element upstream of where the creepages are
    // counted
    const HalfspaceSolution &s    = result.solution;
    const auto              &slip = result.problem.rigid_slip_y;
    double                   half = 0;
    for (int j = 0; j < s.grid.my; ++j)
      for (int i = 1; i < s.grid.mx; ++i)
        {
          const int e = i + s.grid.mx * j;
          half += 0.5 * s.traction_y[e] * (slip[e] - slip[e - 1]) * s.grid.element_area();
        }
    BOOST_TEST(near((get_figure(figures, "friction_work_N") - half) / get_figure(figures, "creepage_work_N"),
                    1,
                    1e-3,
                    "work of friction over that of the creepages"));
    BOOST_TEST(
      near(get_figure(figures, "frictional_power_W") / (get_figure(figures, "t_gamma_N") * scene.velocity),
           1,
           1e-12,
           "power over work and speed"));
  }

  /// Figures of the main scene, from its T-gamma and its patch.
  BOOST_AUTO_TEST_CASE(test_figures)
  {
    Scene scene                      = read_scene(WHEELRAIL_SOURCE_DIR "/prm/rolling.prm", {}).scene;
    scene.rail_material.yield_stress = 480e6;
    const SceneGeometry geometry     = make_geometry(scene);
    const Summary       figures      = halfspace_summary(
      scene, solve_wheel_rail(scene, geometry, scene_load(scene, geometry), scene_offsets(scene)));
    const auto value = [&](const char *key) { return get_figure(figures, key); };
    BOOST_TEST(near(value("t_gamma_over_area_N_per_m2") * value("contact_area_m2") / value("t_gamma_N"),
                    1,
                    1e-12,
                    "T-gamma over area"));
    BOOST_TEST(near(1e3 * value("usfd_wear_rate_kg_per_m3"),
                    5.3e-6 * value("t_gamma_over_area_N_per_m2"),
                    1e-9,
                    "mild wear [ug/m/mm2]"));
    BOOST_TEST(near(1e5 * value("burstow_damage"),
                    (value("t_gamma_N") - 15) / 50,
                    1e-9,
                    "crack damage on its rising line"));
    BOOST_TEST(near(value("utilised_friction") * value("normal_force_N") /
                      std::hypot(value("longitudinal_force_N"), value("tangential_lateral_force_N")),
                    1,
                    1e-9,
                    "traction over normal force"));
    BOOST_TEST(
      near(value("shakedown_load") * 480e6 / std::sqrt(3.) / value("max_pressure_Pa"), 1, 1e-12, "p0/k"));
    scene.friction.at_rest     = 0;
    scene.traction_coefficient = 0;
    const Summary none         = halfspace_summary(
      scene, solve_wheel_rail(scene, geometry, scene_load(scene, geometry), scene_offsets(scene)));
    BOOST_TEST(near(get_figure(none, "usfd_wear_rate_kg_per_m3"), 0, 1e-15, "without friction no wear"));
    BOOST_TEST(near(get_figure(none, "t_gamma_N"), 0, 1e-12, "and no T-gamma"));
  }

  /// A node that slips 0.3 m/s while its neighbours stick wears as its mean slip of 0.15 m/s does: a seventh.
  BOOST_AUTO_TEST_CASE(test_bursts)
  {
    PatchFields patch;
    patch.n_along   = 5;
    patch.n_lateral = 3;
    const WearData data;
    const double   V = 10;
    for (int e = 0; e < 15; ++e)
      {
        patch.lateral.push_back(1e-3 * (e % 3));
        patch.pressure.push_back(e / 3 > 0 ? 1e8 : 0);
        patch.traction_along.push_back(0);
        patch.traction_lateral.push_back(0);
        patch.slip_along.push_back(e / 3 == 2 ? 0.3 / V : 0);
        patch.slip_lateral.push_back(0);
        patch.area.push_back(1e-6);
      }
    const WearProfile single = wear_profile(patch, V, data), nodes = wear_profile(patch, V, data, true);
    const double      of_k = 1e8 * 0.3 / V * 1e-3 / data.hardness;
    BOOST_TEST(near(single.depth[1] / of_k, 35e-4, 1e-15, "coefficient of a steady slip of 0.3 m/s"));
    BOOST_TEST(near(nodes.depth[1] / of_k, 5e-4, 1e-15, "of a burst between nodes that stick"));
  }
} // namespace
