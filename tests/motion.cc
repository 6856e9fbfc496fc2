// label: fast

// What a run follows: curves through the rows of a motion, the pose of the wheelset that is led, where its
// patches come to lie, and what a motion that no run can follow is answered by.

#include <wheelrail/base/smooth_curve.h>
#include <wheelrail/commands/scene_row.h>
#include <wheelrail/model/model.h>
#include <wheelrail/model/scene_motion.h>

#include "messages.h"
#include "near.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

using namespace wheelrail;
using test::near;
using test::same_text;

namespace
{
  const std::string file = "motion_of_test.csv";

  Scene
  scene_with(const std::string &table)
  {
    std::ofstream(file) << table;
    Scene scene                = {};
    scene.traction_coefficient = 0.25;
    scene.motion               = file;
    scene.rolling_distance     = 0.1;
    return scene;
  }

  void
  test_curve()
  {
    const SmoothCurve curve({0, 1, 3, 4, 6}, {2, 2, 0, 0, 1});
    BOOST_TEST(near(curve.at(0.5), 2, 1e-15, "level where neighbours are level"));
    BOOST_TEST(near(curve.at(3), 0, 1e-15, "through its points"));
    double least = 1;
    for (int k = 0; k <= 600; ++k)
      least = std::min(least, curve.at(0.01 * k));
    BOOST_TEST(near(least, 0, 1e-15, "never below the least value"));
    for (const double x : {1., 3., 4.})
      BOOST_TEST(near(curve.slope(x - 1e-9), curve.slope(x + 1e-9), 1e-6, "a continuous slope"));
    BOOST_TEST(
      near((curve.at(2.001) - curve.at(1.999)) / 0.002, curve.slope(2), 1e-5, "the slope of its values"));
    BOOST_TEST(near(curve.at(7), 1, 0, "the last value beyond the end"));
    BOOST_TEST(near(curve.slope(7), 0, 0, "and no slope there"));
    BOOST_TEST(near(SmoothCurve({0, 2}, {1, 2}).at(0.5), 1.25, 1e-15, "a line through two points"));
    BOOST_TEST(near(curve.mirrored().at(5), -curve.at(5), 1e-15, "mirrored"));
  }

  /// The way that is led against the pose that rigid contact finds at each place.
  void
  test_pose(const bool left)
  {
    Scene scene = scene_with(
      "distance [m],lateral shift [mm],roll [mrad],yaw [mrad],load [kN]\n"
      "5,0,0,-3,100\n5.05,0.3,1,2,120\n5.1,1,2,8,80\n5.2,1,2,8,80\n");
    scene.left_wheel             = left;
    scene.velocity               = 20;
    const Scene         start    = scene_at_start(scene);
    const SceneGeometry geometry = make_geometry(start);
    const auto          samples  = sample_path(start, geometry);
    const GuidedPath    way      = make_path(start, samples, 1);
    BOOST_TEST(samples.size() > 10, "samples");
    const WheelPose &first = geometry.contact.pose;
    for (const PathSample &sample : samples)
      {
        const WheelPose  &pose   = sample.geometry.contact.pose;
        const RigidMotion lead   = way.lead(sample.rolled);
        const Vector3     middle = {0, 0, sample.geometry.contact.along - geometry.contact.along};
        const Vector3     moved  = pose.centre() + middle - first.centre() - lead.move;
        BOOST_TEST(near(norm(pose.axis() - lead.turned(first.axis())), 0, 1e-12, "direction of the axle"));
        BOOST_TEST(near(std::hypot(moved[0], moved[2]), 0, 1e-9, "centre of the wheel [m]"));
        BOOST_TEST(
          near(way.contact_along.at(sample.rolled), sample.geometry.contact.along, 1e-12, "contact"));
        BOOST_TEST(near(way.load.at(sample.rolled), sample.scene.wheel_load, 1e-9, "load [N]"));
        const double           h    = 1e-6;
        const GuidedPath::Rate rate = way.rate(sample.rolled);
        const RigidMotion      next = way.lead(sample.rolled + h), last = way.lead(sample.rolled - h);
        const Vector3          arm = {0.1, 0.2, 0.3};
        const Vector3 there = (0.5 / h) * (next.turned(arm) + next.move - last.turned(arm) - last.move);
        if (sample.rolled > h)
          BOOST_TEST(
            near(norm(there - rate.centre - cross(rate.spin, lead.turned(arm))), 0, 1e-5, "velocity"));
      }
    SweepSizes sizes;
    sizes.approach = 1e-4;
    plan_for_path(geometry, samples, sizes);
    BOOST_TEST(sizes.across.s1 - sizes.across.s0 > 15e-3, "the patches lie beside each other");
    BOOST_TEST(sizes.ahead.s1 - sizes.ahead.s0 > 7e-3, "the contact goes ahead with the yaw");
  }

  void
  test_over_time()
  {
    const Scene scene = scene_with(
      "time [s],velocity [m/s],creepage [%],lateral creepage [%]\n"
      "0,10,0.1,0\n0.01,20,0.1,0.2\n0.02,20,0.3,0.2\n");
    const SceneMotion motion(scene);
    BOOST_TEST(near(motion.at(0.15).velocity, 20, 1e-12, "150 mm are covered in 10 ms at 15 m/s"));
    BOOST_TEST(near(motion.at(0.35).creepage, 0.003, 1e-12, "and 350 mm in 20 ms"));
    BOOST_TEST((motion.at(0.1).drive == Drive::rate), "a creepage holds the rate");
    BOOST_TEST(near(motion.at(0.35).lateral_shift, 0.15 * 0.001 + 0.2 * 0.002, 1e-9, "drifted aside [m]"));
    double    time  = 0;
    const int parts = 20000;
    for (int k = 0; k < parts; ++k)
      time += 0.3 / parts / motion.at(0.3 * (k + 0.5) / parts).velocity;
    BOOST_TEST(near(motion.duration(0.3) / time, 1, 1e-6, "time of the way"));
  }

  void
  refused(const Scene &scene, const std::string &expected)
  {
    BOOST_TEST(test::same_text(test::message_of([&]() { SceneMotion motion(scene); }), expected, expected));
  }

  void
  refused_from(const Scene &scene, const std::string &begin)
  {
    const std::string message = test::message_of([&]() { SceneMotion motion(scene); });
    BOOST_TEST(message.rfind(begin, 0) == 0, begin + "...: " + message);
  }

  void
  test_messages()
  {
    const std::string entry = "Wheelset/Motion = " + file;
    const std::string rows  = "distance [m],load [kN]\n0,0\n1,100\n2,0\n";
    Scene             scene = scene_with(rows);
    refused(scene,
            "Wheelset/Motion start = first row: without a load there is no contact; start where " + file +
              " has one");
    scene.motion_start = 3;
    refused(scene, "Wheelset/Motion start = 3 m: outside of " + file + ", which goes from 0 m to 2 m");
    scene.motion_start = 1.95;
    refused(scene,
            "Run/Rolling distance = 100 mm: leaves " + file +
              ", whose rows go from 0 m to 2 m, since the run starts at 1.95 m; roll less, or start earlier");
    scene.motion_start = 1;
    scene.passages     = 2;
    refused(scene,
            entry +
              ": only one run over a new rail can follow a motion; leave Run/Passages, Passage list and "
              "Rail out");
    refused(scene_with("time [s],yaw [mrad]\n0,1\n"),
            entry + ": one row; a run that follows a motion needs two at least");
    refused(scene_with("time [s],lateral shift [mm],lateral creepage [%]\n0,1,1\n1,1,1\n"),
            entry +
              ": lateral shift and lateral creepage; a run moves the wheelset aside as the shift says: "
              "leave one of the columns out");
    refused(
      scene_with("distance [m],cant [mm]\n0,100\n1,100\n"),
      entry +
        ": cant; a run has one wheel, whose load the column load gives: leave the column out (half-spaces of "
        "\"vehicle\" take it)");
    refused(scene_with("time [s],torque [kN m],traction\n0,1,1\n1,1,1\n"),
            file + ": torque and traction; one follows from the other: leave one of the columns out");
    refused(
      scene_with("distance [mm],lateral shift [mm]\n0,0\n50,0\n50.000001,1\n200,1\n"),
      entry +
        ": from row 2 to row 3, over 1e-06 mm of distance, the lateral shift changes with an acceleration of "
        "9.1e+18 m/s2; at most 10000 m/s2 (some 1000 g) is accepted: take the jump out, or spread it "
        "over a longer distance");
    refused_from(
      scene_with("distance [mm],velocity [km/h]\n0,140\n50,140\n50.0001,400\n200,400\n"),
      entry +
        ": from row 2 to row 3, over 0.0001 mm of distance, the velocity changes with an acceleration of ");
    refused_from(
      scene_with("distance [mm],velocity [m/s]\n0,39\n50,39\n51,40\n200,40\n"),
      entry + ": from row 2 to row 3, over 1 mm of distance, the velocity changes with an acceleration of ");
    refused_from(scene_with("distance [mm],yaw [mrad]\n0,0\n50,0\n51,5\n200,5\n"),
                 entry +
                   ": from row 2 to row 3, over 1 mm of distance, the yaw changes with an acceleration of ");
    // beyond the path of the run rows may say what they like; within it, what wheelsets do
    BOOST_TEST(same_text(test::message_of([]() {
                           SceneMotion motion(
                             scene_with("distance [mm],lateral shift [mm]\n0,0\n60,1\n150,1\n150.001,2\n"));
                         }),
                         "no message",
                         "1 mm over 60 mm, and a jump after the end of the run"));
    refused(scene_with("time [s],distance [m],yaw [mrad]\n0,0,0\n0.1,2,1\n0.2,4,2\n"),
            entry +
              ": from row 1 to row 3 time and distance say 72 km/h, which differs from "
              "Wheelset/Velocity = 140 km/h; correct one of them, or leave time or distance out");
    refused(scene_with("time [s],distance [m],velocity [m/s]\n0,0,20\n0.1,2,20\n1.2,4,20\n"),
            entry +
              ": from row 1 to row 3 time and distance say 12 km/h, which differs from the column "
              "velocity; correct one of them, or leave time or distance out");
    const Scene far =
      scene_at_start(scene_with("distance [m],lateral shift [mm],yaw [mrad]\n0,0,0\n0.1,-11.9,50\n"));
    const std::string message = test::message_of([&]() { sample_path(far, make_geometry(far)); });
    BOOST_TEST((message.rfind(entry + ", ", 0) == 0 &&
                message.find(" rolled: Wheel 'S1002' and rail '54E1' have no ") != std::string::npos),
               "where wheel and rail do not touch: " + message);
  }
} // namespace


BOOST_AUTO_TEST_CASE(motion)
{
  test_curve();
  test_pose(false);
  test_pose(true);
  test_over_time();
  test_messages();
}
