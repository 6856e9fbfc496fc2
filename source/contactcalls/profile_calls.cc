#include <wheelrail/base/errors.h>
#include <wheelrail/contactcalls/call_table.h>
#include <wheelrail/contactcalls/contact_calls.h>
#include <wheelrail/contactfiles/surface_shapes.h>
#include <wheelrail/contactfiles/wheel_rail_pose.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

// Points of the profiles as the library has them, in mm whatever the units of the caller; y to the right.

using namespace wheelrail;

namespace
{
  /// Parameters of the points that a sampling asks for: 0 and below those of the profile, 1 at a spacing
  /// [mm], more that many in each of its pieces.
  std::vector<double>
  sampled(const ProfileLine &line, const int sampling, const double spacing)
  {
    std::vector<double> places;
    if (sampling == 1)
      {
        if (!(spacing > 0))
          throw InputError("the spacing of the points is not positive");
        const double first = line.arc(0), length = line.arc(line.end()) - first;
        for (int k = 0; k * millimetre * spacing < length + 1e-9; ++k)
          places.push_back(line.parameter(first + k * millimetre * spacing));
        return places;
      }
    const int parts = std::max(1, sampling);
    for (int k = 0; k <= int(line.end()) * parts; ++k)
      places.push_back(double(k) / parts);
    return places;
  }

  /// The innermost point within the gauge height, the place of the section's origin, and the point at that
  /// height (y, z of each), in the track without the place of the rail.
  std::array<double, 6>
  gauge_points(const ContactTrack &track, const WheelRailPose &pose, const ProfileLine &line)
  {
    const auto at = [&](const double t) {
      const ProfileLine::Place p = line.at(t);
      return pose.rail.turned({0, p.y, p.z});
    };
    double top = 1e9;
    for (const double t : line.samples())
      top = std::min(top, at(t)[2]);
    const double          depth = top + millimetre * track.gauge_height;
    std::array<double, 6> found{{0, 0, pose.rail.move[1], pose.rail.move[2], 0, 0}};
    double                inner = 1e9;
    for (const double t : line.samples())
      {
        const Vector3 p = at(t);
        if (p[2] <= depth && p[1] < inner)
          {
            inner    = p[1];
            found[0] = p[1];
            found[1] = p[2];
          }
        if (p[2] <= depth && found[5] == 0)
          {
            found[4] = p[1];
            found[5] = depth;
          }
      }
    return found;
  }

  std::vector<double>
  profile_values(const CallProblem &problem,
                 const int          task,
                 const bool         wheel,
                 const int          sampling,
                 const double       spacing)
  {
    const ContactCase        &one = problem.before ? *problem.before : problem.one;
    const RailShape           rail(one);
    const ProfileLine         line   = wheel ? WheelShape(one).middle() : rail.middle();
    const std::vector<double> places = sampled(line, sampling, spacing);
    WheelRailPose             pose   = wheel_rail_pose(one, rail.middle());
    if (problem.wheel_rail)
      {
        pose.height              = problem.wheel_rail->height;
        const Vector3 &given_way = problem.wheel_rail->deflection; // of a rail on springs
        add(pose.rail.move, 1, {0, (pose.left ? -1 : 1) * given_way[1], given_way[2]});
      }
    const double        side = pose.left ? -1 : 1; // lines and pose are those of the right-hand side
    std::vector<double> values, heights;
    const RigidMotion   to_track = wheel ? pose.wheel_to_track() : pose.rail;
    switch (task)
      {
        case 0:
          return {double(places.size())};
        case 3:
          {
            const auto found = gauge_points(one.track, pose, rail.middle());
            for (std::size_t k = 0; k < found.size(); ++k)
              values.push_back((k % 2 == 0 ? side : 1) * found[k] / millimetre);
            return values;
          }
        case 1:
        case 2:
          for (const double t : places)
            {
              const ProfileLine::Place p     = line.at(t);
              const Vector3            there = task == 2 ? to_track({0, p.y, p.z}) : Vector3{0, p.y, p.z};
              values.push_back(side * there[1] / millimetre);
              heights.push_back(there[2] / millimetre);
            }
          values.insert(values.end(), heights.begin(), heights.end());
          return values;
        case 4:
          for (const double t : places)
            values.push_back(side * line.arc(t) / millimetre);
          return values;
        case 5:
          for (const double t : places)
            values.push_back(side * line.at(t).angle());
          return values;
        default:
          throw InputError("the task " + std::to_string(task) + " is not computed; taken are -1 to 5");
      }
  }

  void
  get_profile(const char   *name,
              const int    *ire,
              const int    *task,
              const int    *n_integers,
              const int    *integers,
              const int    *n_reals,
              const double *reals,
              const int    *n,
              double       *values)
  {
    const int failed = with_problem(
      {name, ire, &whole, 1},
      {task, n_integers, when(n_integers, integers), n_reals, when(n_reals, reals), n, cleared(n, values)},
      [&](CallElement &, CallProblem &problem) {
        const bool wheel = *n_integers > 0 && integers[0] == 1;
        if ((wheel ? problem.one.wheelset.profile.line : problem.one.track.profile.line) == 0)
          throw InputError(std::string("no profile of the ") + (wheel ? "wheel" : "rail") + " has been set");
        if (*task == -1) // it was found when it was set
          return;
        const std::vector<double> found = profile_values(
          problem, *task, wheel, *n_integers > 1 ? integers[1] : 0, *n_reals > 0 ? reals[0] : 1);
        std::copy_n(found.begin(), std::min(std::size_t(std::max(0, *n)), found.size()), values);
      });
    if (failed != 0 && n && *n > 0 && values)
      values[0] = call_error::profile;
  }
} // namespace

void
cntc_getprofilevalues(const int *ire,
                      const int *task,
                      const int *n_integers,
                      const int *integers,
                      const int *n,
                      double    *values)
{
  constexpr int none = 0;
  get_profile(__func__, ire, task, n_integers, integers, &none, nullptr, n, values);
}

void
cntc_getprofilevalues_new(const int    *ire,
                          const int    *task,
                          const int    *n_integers,
                          const int    *integers,
                          const int    *n_reals,
                          const double *reals,
                          const int    *n,
                          double       *values)
{
  get_profile(__func__, ire, task, n_integers, integers, n_reals, reals, n, values);
}
