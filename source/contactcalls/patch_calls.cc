#include <wheelrail/contactcalls/call_table.h>
#include <wheelrail/contactcalls/contact_calls.h>
#include <wheelrail/contactfiles/surface_shapes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

// Results of wheel and rail.

using namespace wheelrail;

namespace
{
  void
  get_motion(const char *name, const int *ire, const int *n, double *values, const bool velocity)
  {
    with_problem(
      {name, ire, &whole, 1}, {n, when(n, values)}, [&](CallElement &element, CallProblem &problem) {
        std::array<double, 6> motion =
          velocity ? problem.one.wheelset.velocity : problem.one.wheelset.position;
        if (problem.wheel_rail) // height and pitch rate are results where forces are given
          motion[velocity ? 5 : 2] =
            velocity ? problem.wheel_rail->pitch_rate : problem.wheel_rail->height / millimetre;
        for (int k = 0; k < std::min(*n, 6); ++k)
          values[k] = motion[std::size_t(k)] / (k < 3 ? element.units.length : 1);
      });
  }

  /// Roll and yaw of a motion that turns by yaw about z, then by roll about x.
  double
  roll_of(const RigidMotion &motion)
  {
    return std::atan2(-motion.rows[1][2], motion.rows[2][2]);
  }

  double
  yaw_of(const RigidMotion &motion)
  {
    return std::atan2(-motion.rows[0][1], motion.rows[0][0]);
  }

  /// Mean of the places of a grid, weighted by the pressure [m].
  std::array<double, 2>
  pressure_centre(const HalfspaceSolution &s)
  {
    double sum = 0, x = 0, y = 0;
    for (int j = 0; j < s.grid.my; ++j)
      for (int i = 0; i < s.grid.mx; ++i)
        {
          const double p = s.pressure[std::size_t(s.grid.mx) * j + i];
          sum += p;
          x += p * s.grid.x(i);
          y += p * s.grid.y(j);
        }
    return {{sum > 0 ? x / sum : 0, sum > 0 ? y / sum : 0}};
  }

  /// Places of a patch and of its bodies, in the order of CONTACT; lengths [m], y to the right. Nothing
  /// stands for the arc along the wheel.
  std::array<double, 38>
  locations(const CallProblem &problem, const WheelRailPatch &patch)
  {
    const ContactCase &one       = *problem.before;
    WheelRailPose      pose      = wheel_rail_pose(one, RailShape(one).middle());
    pose.height                  = problem.wheel_rail->height;
    const double           side  = pose.left ? -1 : 1; // the pose is that of the right-hand side
    const RigidMotion      wheel = pose.wheel_to_track(), set = pose.wheelset_to_track();
    const auto             centre = pressure_centre(patch.solution);
    const Vector3         &track  = patch.in_track;
    const Vector3          in_set = set.back({track[0], side * track[1], track[2]});
    std::array<double, 38> all{};
    const auto             put = [&](const std::size_t first, const std::initializer_list<double> values) {
      std::copy(values.begin(), values.end(), all.begin() + std::ptrdiff_t(first - 1));
    };
    put(1, {track[0], track[1], track[2], patch.angle});
    put(5, {patch.on_rail[0], patch.on_rail[1], patch.on_rail[2], patch.arc});
    put(9, {patch.angle - side * roll_of(pose.rail)});
    put(10, {patch.on_wheel[0], patch.on_wheel[1], patch.on_wheel[2]});
    put(14, {patch.angle - side * roll_of(wheel)});
    put(15,
        {track[0] + centre[0] - patch.origin_x,
         track[1] + (centre[1] - patch.origin_y) * std::cos(patch.angle)});
    const Vector3 &given_way = problem.wheel_rail->deflection; // of a rail on springs
    put(18, {given_way[1], given_way[2]});
    put(21, {wheel.move[0], side * wheel.move[1], wheel.move[2]});
    put(24, {side * roll_of(wheel), side * yaw_of(wheel)});
    put(
      26,
      {side * pose.rail.move[1] + given_way[1], pose.rail.move[2] + given_way[2], side * roll_of(pose.rail)});
    put(30, {in_set[0], side * in_set[1], in_set[2], patch.angle - side * roll_of(set)});
    put(34, {pose.wheel.move[0], side * pose.wheel.move[1], pose.wheel.move[2]});
    put(37, {side * roll_of(pose.wheel), side * yaw_of(pose.wheel)});
    return all;
  }

  /// Whether the location of that place in the list is an angle.
  bool
  is_angle(const int place)
  {
    constexpr std::array<int, 9> angles = {{4, 9, 14, 24, 25, 28, 33, 37, 38}};
    return std::find(angles.begin(), angles.end(), place) != angles.end();
  }

  /// A vector, or a moment, of printed axes in those of a body: its motion is that of the right-hand side,
  /// on the left one both are seen in a mirror.
  Vector3
  seen_from(const RigidMotion &motion, const double side, const Vector3 &v, const bool moment)
  {
    const Vector3 sign  = moment ? Vector3{side, 1, side} : Vector3{1, side, 1};
    const Vector3 there = motion.back(Vector3{sign[0] * v[0], sign[1] * v[1], sign[2] * v[2]} + motion.move);
    return {sign[0] * there[0], sign[1] * there[1], sign[2] * there[2]};
  }
} // namespace

void
cntc_getwheelsetposition(const int *ire, const int *n, double *values)
{
  get_motion(__func__, ire, n, values, false);
}

void
cntc_getwheelsetvelocity(const int *ire, const int *n, double *values)
{
  get_motion(__func__, ire, n, values, true);
}

void
cntc_getnumcontactpatches(const int *ire, int *n)
{
  with_problem({__func__, ire, &whole, 1, true}, {cleared(n)}, [&](CallElement &, CallProblem &problem) {
    *n = int(problem.wheel_rail->patches.size());
  });
}

void
cntc_getcontactlocation(const int *ire, const int *icp, const int *n, double *values)
{
  with_problem(
    {__func__, ire, icp, 1, true}, {n, cleared(n, values)}, [&](CallElement &element, CallProblem &problem) {
      const auto all = locations(problem, *call_result(problem, *icp).patch);
      for (int k = 0; k < std::min(*n, int(all.size())); ++k)
        values[k] = all[std::size_t(k)] / (is_angle(k + 1) ? 1 : millimetre * element.units.length);
    });
}

void
cntc_getglobalforces(const int *ire, const int *icp, const int *n, double *values)
{
  with_problem(
    {__func__, ire, icp, 1, true}, {n, cleared(n, values)}, [&](CallElement &element, CallProblem &problem) {
      const ContactCase  &one  = *problem.before;
      const WheelRailPose pose = wheel_rail_pose(one, RailShape(one).middle());
      const double        side = pose.left ? -1 : 1;
      Vector3             track{}, wheelset{}, rail_moment{}, wheel_moment{};
      const auto          take = [&](const WheelRailPatch &patch) {
        add(track, 1, patch.force_track);
        add(wheelset, 1, patch.force_wheelset);
        add(rail_moment, 1, patch.moment_rail);
        add(wheel_moment, 1, patch.moment_wheelset);
      };
      if (*icp == -1)
        for (const WheelRailPatch &patch : problem.wheel_rail->patches)
          take(patch);
      else
        take(*call_result(problem, *icp).patch);
      const Vector3 all[8] = {track,
                              rail_moment,
                              wheelset,
                              wheel_moment,
                              seen_from(pose.rail, side, track, false),
                              seen_from(pose.rail, side, rail_moment, true),
                              seen_from(pose.wheel, side, wheelset, false),
                              seen_from(pose.wheel, side, wheel_moment, true)};
      for (int k = 0; k < std::min(*n, 24); ++k)
        values[k] = element.units.body * all[k / 3][std::size_t(k % 3)] /
                    (k / 3 % 2 == 1 ? millimetre * element.units.length : 1);
    });
}
