#include <wheelrail/base/errors.h>
#include <wheelrail/contactcalls/call_table.h>
#include <wheelrail/contactcalls/contact_calls.h>

#include <algorithm>
#include <filesystem>
#include <string>

// Track, wheelset and profiles of module 1.

using namespace wheelrail;

namespace
{
  void
  need(const std::string &what, const int found, const int least, const int most)
  {
    if (found < least || found > most)
      throw InputError(what + " needs " + std::to_string(least) +
                       (most > least ? " to " + std::to_string(most) : "") + " values, not " +
                       std::to_string(found));
  }

  void
  set_design(ContactTrack &track, const double *v, const double curvature, const CallUnits &units)
  {
    track.gauge_height   = v[0] * units.length;
    const bool gauge     = track.gauge_height > 0;
    track.gauge_sequence = gauge ? v[1] : 0;
    track.gauge          = gauge ? v[2] * units.length : 0;
    track.rail_y         = gauge ? 0 : v[1] * units.length;
    track.rail_z         = gauge ? 0 : v[2] * units.length;
    track.cant           = v[3];
    track.roller_radius  = v[4] * units.length;
    track.curvature      = curvature / units.length;
    track.line           = 1;
  }

  /// Places or velocities along x, y, z [mm], then angles [rad], of which there are three of each but for a
  /// rail's two places.
  void
  copy_motion(const double *from, double *to, const int lengths, const int angles, const CallUnits &units)
  {
    for (int k = 0; k < lengths + angles; ++k)
      to[k] = from[k] * (k < lengths ? units.length : 1);
  }

  void
  set_deviation(ContactTrack &track, const double *v, const CallUnits &units)
  {
    copy_motion(v, track.deviation.data(), 2, 1, units);
    copy_motion(v + 3, track.deviation.data() + 3, 2, 1, units);
    track.deviation_line = 1;
  }

  void
  set_track(const char *name, const int *ire, const int *Z, const int *count, const double *v)
  {
    with_problem(
      {name, ire, &whole, 1}, {Z, count, when(count, v)}, [&](CallElement &element, CallProblem &problem) {
        const CallUnits  &units = element.units;
        ContactTrack     &track = problem.one.track;
        const std::string what  = "Z = " + std::to_string(*Z);
        const int         n     = *count;
        switch (*Z)
          {
            case 0:
              break;
            case 1:
              need(what, n, 5, 6);
              set_design(track, v, n > 5 ? v[5] : 0, units);
              break;
            case 2:
              need(what, n, 6, 6);
              set_deviation(track, v, units);
              break;
            case 3:
              need(what, n, 11, 12);
              set_design(track, v, n > 11 ? v[5] : 0, units);
              set_deviation(track, v + n - 6, units);
              break;
            case 32:
            case 33:
              need(what, n, 4, 5);
              track.springs = {v[0] / units.length, v[1], v[2] / units.length, v[3]};
              if (n > 4)
                track.springs.push_back(v[4] * units.length);
              break;
            default:
              throw InputError(what + " is unknown; 0 to 3, 32 and 33 are known");
          }
      });
  }

  ContactProfile
  profile_options(const int        n_integers,
                  const int       *integers,
                  const int        n_reals,
                  const double    *reals,
                  const CallUnits &units)
  {
    ContactProfile profile;
    const auto     integer = [&](const int k, const int otherwise) {
      return k < n_integers ? integers[k] : otherwise;
    };
    const auto real = [&](const int k, const double otherwise) { return k < n_reals ? reals[k] : otherwise; };
    profile.mirror_y         = integer(2, 0);
    profile.mirror_z         = integer(3, 0);
    profile.error_handling   = integer(4, 0);
    profile.smoothing_method = integer(5, 0);
    profile.scale            = real(0, 0) > 0 ? reals[0] : units.length;
    profile.smoothing        = real(1, 0);
    profile.largest_gap      = real(2, profile.largest_gap);
    profile.zigzag           = real(3, profile.zigzag);
    profile.kink_high        = real(4, profile.kink_high);
    profile.kink_low         = real(5, profile.kink_high / 5);
    profile.kink_width       = n_reals > 6 ? reals[6] * units.length : profile.kink_width;
    profile.options          = n_integers > 4 || n_reals > 2 ? 2 : 0;
    profile.line             = 1;
    return profile;
  }

  bool
  is_wheel(const std::string &file)
  {
    const std::string ending = std::filesystem::path(file).extension().string();
    return ending == ".prw" || ending == ".whl" || ending == ".wheel" || ending == ".slcw";
  }
} // namespace

void
cntc_settrackdimensions(const int *ire, const int *Z, const int *n, const double *values)
{
  set_track(__func__, ire, Z, n, values);
}

void
cntc_settrackdimensions_new(const int *ire, const int *Z, const int *n, const double *values)
{
  set_track(__func__, ire, Z, n, values);
}

void
cntc_settrackdimensions_old(const int *ire, const int *, const int *, const double *)
{
  with_problem({__func__, ire, &whole, 1}, {}, [](CallElement &, CallProblem &) {
    throw InputError("the values of this old form are not taken; call cntc_settrackdimensions");
  });
}

void
cntc_setprofileinputfname(const int    *ire,
                          const char   *name,
                          const int    *name_length,
                          const int    *n_integers,
                          const int    *integers,
                          const int    *n_reals,
                          const double *reals)
{
  with_problem({__func__, ire, &whole, 1},
               {name_length, n_integers, when(n_integers, integers), n_reals, when(n_reals, reals)},
               [&](CallElement &element, CallProblem &problem) {
                 std::string file = call_text(name, *name_length);
                 std::replace(file.begin(), file.end(), '\\', '/');
                 std::error_code ignored;
                 if (!std::filesystem::is_regular_file(file, ignored))
                   throw InputError("the profile \"" + file + "\" is not there, or is no file");
                 const int      kind  = *n_integers > 0 ? integers[0] : -1;
                 const bool     wheel = kind == 1 || (kind != 0 && is_wheel(file));
                 ContactProfile profile =
                   profile_options(*n_integers, integers, *n_reals, reals, element.units);
                 profile.file                                                       = file;
                 (wheel ? problem.one.wheelset.profile : problem.one.track.profile) = profile;
               });
}

void
cntc_setprofileinputvalues(const int    *ire,
                           const int    *n_points,
                           const double *yz,
                           const int    *n_integers,
                           const int    *integers,
                           const int    *n_reals,
                           const double *reals)
{
  with_problem(
    {__func__, ire, &whole, 1},
    {n_points, when(n_points, yz, 2), n_integers, when(n_integers, integers), n_reals, when(n_reals, reals)},
    [&](CallElement &element, CallProblem &problem) {
      const bool wheel = *n_integers < 1 || integers[0] >= 1;
      if (*n_points < 4)
        throw InputError("the profile has less than four points");
      ContactProfile profile = profile_options(*n_integers, integers, *n_reals, reals, element.units);
      profile.file           = wheel ? "values of the wheel" : "values of the rail";
      for (int k = 0; k < *n_points; ++k)
        profile.points.emplace_back(yz[2 * k], yz[2 * k + 1]);
      (wheel ? problem.one.wheelset.profile : problem.one.track.profile) = profile;
    });
}

void
cntc_setwheelsetdimensions(const int *ire, const int *E, const int *n, const double *values)
{
  with_problem(
    {__func__, ire, &whole, 1}, {E, n, when(n, values)}, [&](CallElement &element, CallProblem &problem) {
      if (*E <= 0)
        return;
      need("E = " + std::to_string(*E), *n, 3, 4);
      ContactWheelset &w = problem.one.wheelset;
      w.flange_distance  = values[0] * element.units.length;
      w.flange_place     = values[1] * element.units.length;
      w.radius           = values[2] * element.units.length;
      w.tape_place.clear();
      if (*n > 3)
        w.tape_place.push_back(values[3] * element.units.length);
      w.line = 1;
    });
}

void
cntc_setwheelsetposition(const int *ire, const int *E, const int *n, const double *values)
{
  with_problem(
    {__func__, ire, &whole, 1}, {E, n, when(n, values)}, [&](CallElement &element, CallProblem &problem) {
      if (*E <= 0)
        return;
      need("E = " + std::to_string(*E), *n, 6, 6);
      copy_motion(values, problem.one.wheelset.position.data(), 3, 3, element.units);
      problem.approach                   = problem.one.wheelset.position[2]; // Z_WS, where FZ is not given
      problem.one.wheelset.position_line = 1;
    });
}

void
cntc_setwheelsetvelocity(const int *ire, const int *E, const int *n, const double *values)
{
  with_problem(
    {__func__, ire, &whole, 1}, {E, n, when(n, values)}, [&](CallElement &element, CallProblem &problem) {
      if (*E <= 0)
        return;
      need("E = " + std::to_string(*E), *n, 6, 6);
      copy_motion(values, problem.one.wheelset.velocity.data(), 3, 3, element.units);
      problem.spin                       = problem.one.wheelset.velocity[5]; // where FX_WS is not given
      problem.one.wheelset.velocity_line = 1;
    });
}

void
cntc_setwheelsetflexibility(const int *ire, const int *E, const int *n, const double *values)
{
  with_problem(
    {__func__, ire, &whole, 1}, {E, n, when(n, values)}, [&](CallElement &element, CallProblem &problem) {
      problem.one.wheelset.flexible.fill(0);
      if (*E < 4)
        return;
      need("E = " + std::to_string(*E), *n, 12, 12);
      copy_motion(values, problem.one.wheelset.flexible.data(), 3, 3, element.units);
      copy_motion(values + 6, problem.one.wheelset.flexible.data() + 6, 3, 3, element.units);
    });
}
