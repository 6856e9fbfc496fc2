// Creep curves of half-spaces against CONTACT; what a curve runs over; messages of --creep-curve.

#include "messages.h"
#include "reference_table.h"

#include <wheelrail/bodies/body_contact.h>
#include <wheelrail/input/motion_file.h>
#include <wheelrail/model/scene_geometry.h>
#include <wheelrail/vehicle/creep_curve.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

using namespace wheelrail;
using test::near;

namespace
{
  Scene
  scene_with(const double yaw)
  {
    Scene scene;
    scene.wheel_load             = 100e3;
    scene.friction.at_rest       = 0.3;
    scene.traction_coefficient   = 0;
    scene.velocity               = 38.889;
    scene.halfspace_element_size = 0.25e-3;
    scene.halfspace_spin         = HalfspaceSpin::contact;
    scene.yaw                    = yaw;
    return scene;
  }

  std::vector<WheelRailSolution>
  solved(const Scene &scene, const CreepCurve &curve)
  {
    const SceneGeometry geometry = make_geometry(scene);
    return solve_creep_curve(scene, curve, [&](const Scene &point) {
      return solve_wheel_rail(point, geometry, scene_load(point, geometry), scene_offsets(point));
    });
  }

  /// Within 0.5 % of the friction that the load gives: creepages to 0.1 % without yaw, larger ones with it.
  BOOST_AUTO_TEST_CASE(test_against_contact)
  {
    const auto table = test::read_table("contact_creep_curve_54E1.csv");
    for (const double yaw : {0., 5e-3})
      {
        CreepCurve                            curve;
        std::vector<std::vector<std::string>> rows;
        for (const auto &row : table)
          if (std::stod(row[2]) == 1e3 * yaw && (yaw > 0) == (std::abs(std::stod(row[0])) > 2e-3))
            {
              curve.values.push_back(std::stod(row[0]));
              rows.push_back(row);
            }
        const auto   points = solved(scene_with(yaw), curve);
        const double few    = 0.005 * 30e3;
        for (std::size_t i = 0; i < points.size(); ++i)
          {
            const std::string which = "yaw " + rows[i][2] + " mrad, creepage " + rows[i][0] + ": ";
            BOOST_TEST(near(points[i].reference->creepage, curve.values[i], 2e-7, which + "creepage"));
            BOOST_TEST(near(points[i].solution.fx,
                            std::stod(rows[i][21]),
                            few,
                            which + "longitudinal force on the rail [N]"));
            BOOST_TEST(near(
              points[i].solution.fy, std::stod(rows[i][22]), few, which + "lateral force on the rail [N]"));
            BOOST_TEST(near(points[i].solution.fn, std::stod(rows[i][20]), few, which + "normal force [N]"));
            BOOST_TEST(near(points[i].reference->spin_moment,
                            1e-3 * std::stod(rows[i][23]),
                            0.8,
                            which + "spin moment [N m]"));
          }
      }
  }

  /// Without spin the forces of an elliptic patch would be odd; here signs and saturation are asked for.
  BOOST_AUTO_TEST_CASE(test_other_axes)
  {
    Scene scene                  = scene_with(0);
    scene.halfspace_element_size = 0.5e-3;
    const auto lateral           = solved(scene, {CreepAxis::lateral, {-0.01, -0.001, 0.001, 0.01}});
    BOOST_TEST(near(lateral[1].reference->lateral_creepage, -0.001, 2e-7, "lateral creepage"));
    for (std::size_t i = 0; i < 4; ++i)
      BOOST_TEST(((lateral[i].reference->traction > 0) == (i < 2)),
                 "the lateral force is against the creepage");
    BOOST_TEST(near(lateral[0].reference->traction / (0.3 * lateral[0].solution.fn),
                    1,
                    0.01,
                    "force at -1 % over friction"));
    const auto spin = solved(scene, {CreepAxis::spin, {-0.5, 0, 0.5}});
    BOOST_TEST(near(spin[2].reference->spin, 0.5, 1e-3, "spin [1/m]"));
    BOOST_TEST(near(spin[1].reference->traction, 0, 50, "no spin and no creepage: no lateral force [N]"));
    BOOST_TEST((spin[0].reference->traction < -2e3 && spin[2].reference->traction > 2e3),
               "spin pushes sideways");
  }

  BOOST_AUTO_TEST_CASE(test_messages)
  {
    const std::string how =
      "; write longitudinal, lateral or spin, then first:last:step or values with commas, and % or 1/m, such "
      "as "
      "\"longitudinal -2:2:0.1 %\" or \"spin -1:1:0.1 1/m\"";
    const auto refused = [&](const std::string &text, const std::string &why) {
      BOOST_TEST(test::same_text(test::message_of([&]() { parse_creep_curve(text); }),
                                 "--creep-curve \"" + text + "\": " + why + how,
                                 "--creep-curve " + text));
    };
    refused("sideways 0:1:0.1 %", "\"sideways\" is none of them");
    refused("", "\"\" is none of them");
    refused("lateral 1:0:0.1 %", "the step must be positive and the last value not below the first");
    refused("lateral 0:1 %", "not understood");
    refused("lateral", "not understood");
    refused("lateral a %", "\" a \" is not a number");
    refused("lateral 1 % 2", "something follows the %");
    refused("longitudinal 0:1:0.00001 %", "more than 1000 values");
    refused("longitudinal 50 %", "50 is beyond 30");
    refused("spin 0:1:0.1", "a spin needs its unit 1/m");
    const CreepCurve curve = parse_creep_curve("longitudinal -2:2:0.1 %");
    BOOST_TEST((curve.values.size() == 41 && std::abs(curve.values[40] - 0.02) < 1e-15), "41 values to 2 %");
    BOOST_TEST((parse_creep_curve("spin -1,0.5 1/m").values == std::vector<double>({-1, 0.5})), "two spins");
  }

  /// Points that are drawn beside a curve.
  BOOST_AUTO_TEST_CASE(test_beside)
  {
    const std::string path = "beside_of_test.csv";
    const auto        read = [&](const std::string &text, const MotionQuantity over) {
      std::ofstream(path) << text;
      return read_curve_file(path, over);
    };
    const MotionFile points =
      read("creepage [%],traction,spin moment [kN m]\n1,0.2,0.01\n-2,-0.3,0\n", MotionQuantity::creepage);
    BOOST_TEST(near((*points.find(MotionQuantity::creepage))[1], -0.02, 1e-15, "creepages in any order"));
    BOOST_TEST(near((*points.find(MotionQuantity::spin_moment))[0], 10, 1e-12, "spin moment [N m]"));
    const auto refused = [&](
                           const std::string &text, const MotionQuantity over, const std::string &expected) {
      BOOST_TEST(
        test::same_text(test::message_of([&]() { read(text, over); }), path + expected, "--beside: " + text));
    };
    refused("spin [1/mm],traction\n1,0\n",
            MotionQuantity::spin,
            ":2: spin = 1 is out of range; -100 1/m to 100 1/m is accepted, in the unit of the first line");
    refused("creepage [%],traction\n1,0\n",
            MotionQuantity::spin,
            ": no spin; the curve runs over it: name a column \"spin [1/m]\"");
    refused("spin [1/m],traction\n1,0\n",
            MotionQuantity::creepage,
            ": no creepage; the curve runs over it: name a column \"creepage [%]\"");
    refused("creepage [%]\n1\n",
            MotionQuantity::creepage,
            ": nothing to draw; name a column longitudinal force, lateral force, spin moment or traction");
    BOOST_TEST(
      test::same_text(test::message_of([]() { read_curve_file("no_such.csv", MotionQuantity::spin); }),
                      "no_such.csv: no such file; --beside needs a table of points to draw beside the curve",
                      "--beside: no such file"));
    BOOST_TEST(
      (read_curve_file(WHEELRAIL_TEST_DIR "/reference/creep_curve_beside.csv", MotionQuantity::creepage)
         .rows() == 7),
      "CONTACT's points can be read");
  }
} // namespace
