// What no run can follow, or what a motion file says twice and differently.

#include <wheelrail/base/errors.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/geometry/track.h>
#include <wheelrail/input/entries.h>
#include <wheelrail/model/scene_motion.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using Q = MotionQuantity;

    std::string
    in_m(const double length)
    {
      return format_quantity(length, "m");
    }

    std::string
    rows(const std::size_t first, const std::size_t last)
    {
      return "from row " + std::to_string(first + 1) + " to row " + std::to_string(last + 1);
    }
  } // namespace


  void
  SceneMotion::check(const MotionFile &motion, const std::vector<double> &along, const double start) const
  {
    const std::string entry = entry_text(scene_, "Wheelset", "Motion");
    if (scene_.several_passages() || scene_.rail_from != "new")
      throw InputError(entry +
                       ": only one run over a new rail can follow a motion; leave Run/Passages, "
                       "Passage list and Rail out");
    if (motion.rows() < 2)
      throw InputError(entry + ": one row; a run that follows a motion needs two at least");
    if (motion.find(Q::lateral_shift) && motion.find(Q::lateral_creepage))
      throw InputError(entry +
                       ": lateral shift and lateral creepage; a run moves the wheelset aside as the "
                       "shift says: leave one of the columns out");
    if (motion.find(Q::cant))
      throw InputError(entry +
                       ": cant; a run has one wheel, whose load the column load gives: leave the column out "
                       "(half-spaces of \"vehicle\" take it)");
    check_times(motion);
    const double end = start + scene_.path(), round_off = 1e-9;
    if (start < along.front() - round_off || start > along.back())
      throw InputError(entry_text(scene_, "Wheelset", "Motion start") + ": outside of " + scene_.motion +
                       ", which goes from " + in_m(along.front()) + " to " + in_m(along.back()));
    if (end > along.back() + round_off)
      throw InputError(path_text(scene_) + ": leaves " + scene_.motion + ", whose rows go from " +
                       in_m(along.front()) + " to " + in_m(along.back()) + ", since the run starts at " +
                       in_m(start) + "; roll less, or start earlier");
  }


  void
  SceneMotion::check_times(const MotionFile &motion) const
  {
    const auto *const time = motion.find(Q::time), *const distance = motion.find(Q::distance),
                      *const velocities = motion.find(Q::velocity);
    if (!time || !distance)
      return;
    // a twentieth of the whole time: tables round
    constexpr double  alike = 0.05;
    const std::size_t last  = time->size() - 1;
    const double      whole = (*time)[last] - (*time)[0];
    double            taken = 0, worst = 0;
    std::size_t       at = last;
    for (std::size_t row = 1; row <= last; ++row)
      {
        const double velocity =
          velocities ? 0.5 * ((*velocities)[row] + (*velocities)[row - 1]) : scene_.velocity;
        taken += ((*distance)[row] - (*distance)[row - 1]) / velocity;
        const double off = std::abs(taken - ((*time)[row] - (*time)[0]));
        if (off > worst)
          {
            worst = off;
            at    = row;
          }
      }
    if (worst <= alike * whole)
      return;
    const auto in_km_h = [](const double velocity) {
      return format_number(std::round(36 * velocity) / 10) + " km/h";
    };
    throw InputError(
      entry_text(scene_, "Wheelset", "Motion") + ": " + rows(0, at) + " time and distance say " +
      in_km_h(((*distance)[at] - (*distance)[0]) / ((*time)[at] - (*time)[0])) + ", which differs from " +
      (velocities ? "the column velocity" : entry_text(scene_, "Wheelset", "Velocity")) +
      "; correct one of them, or leave time or distance out");
  }


  void
  SceneMotion::check_accelerations(const std::vector<double> &rolled) const
  {
    // some 1000 g; axle boxes see a tenth of that on the worst joints
    constexpr double most  = 1e4;
    const auto       speed = [&](const double at) {
      return has(Q::velocity) ? value(Q::velocity, at) : scene_.velocity;
    };
    const double arm = running_circle_distance(scene_.track);
    struct Led
    {
      Q           quantity;
      SmoothCurve curve;
      double      arm;
    };
    std::vector<Led> led = {{has(Q::lateral_shift) ? Q::lateral_shift : Q::lateral_creepage, shift_, 1}};
    for (const Q turned : {Q::roll, Q::yaw})
      if (has(turned))
        led.push_back({turned, curves_.at(turned), arm});
    if (has(Q::velocity))
      led.push_back({Q::velocity, curves_.at(Q::velocity), 1});

    for (std::size_t row = 1; row < rolled.size(); ++row)
      for (const Led &one : led)
        {
          const double low = std::max(rolled[row - 1], 0.), high = std::min(rolled[row], scene_.path());
          if (!(high > low))
            continue;
          // cubics between rows: the second derivative is largest at one of the ends, the first, which is
          // what a velocity has, also between them
          const double h       = 1e-3 * (high - low);
          double       largest = 0;
          for (const double at : {low, 0.5 * (low + high), high - h})
            {
              const double v = speed(at), slope = one.curve.slope(at);
              largest = std::max(largest,
                                 std::abs(one.quantity == Q::velocity
                                            ? v * slope
                                            : v * v * (one.curve.slope(at + h) - slope) / h));
            }
          if (one.arm * largest > most)
            throw InputError(
              entry_text(scene_, "Wheelset", "Motion") + ": " + rows(row - 1, row) + ", over " +
              about(1e3 * (rolled[row] - rolled[row - 1])) + " mm of distance, the " +
              motion_name(one.quantity) + " changes with an acceleration of " + about(one.arm * largest) +
              " m/s2" + (one.arm < 1 ? " at the wheel" : "") + "; at most " + about(most) +
              " m/s2 (some 1000 g) is accepted: take the jump out, or spread it over a longer distance");
        }
  }
} // namespace wheelrail
