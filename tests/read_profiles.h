#pragma once

#include "near.h"
#include "profile_samples.h"

#include <wheelrail/base/errors.h>
#include <wheelrail/profiles/measured_profiles.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

/// Profile files read as wheel or rail, and what is asked of them.
namespace test::profile_files
{
  using namespace wheelrail;

  using Points = std::vector<Point2>;

  /// A file read as wheel or rail, with all that was told, or the error.
  struct Read
  {
    Curve                    curve;
    std::vector<std::string> notes;
    std::string              error;

    bool
    tells(const std::string &part) const
    {
      return std::any_of(notes.begin(), notes.end(), [&](const std::string &note) {
        return note.find(part) != std::string::npos;
      });
    }
  };

  inline Read
  read(const ProfileKind kind, const std::string &text, const WheelOrigin origin = WheelOrigin::automatic)
  {
    Read               result;
    ProfileFileOptions options;
    options.kind = kind;
    try
      {
        const MeasuredProfile profile = read_profile_text(text, "p.txt", options);
        result.notes                  = profile.notes;
        result.curve = kind == ProfileKind::wheel ? measured_wheel(profile, 0.135, result.notes, origin).tread
                                                  : measured_rail(profile, "auto", result.notes).head;
      }
    catch (const InputError &error)
      {
        result.error = error.what();
      }
    return result;
  }

  inline void
  check_tells(const Read &read, const std::string &part, const std::string &what)
  {
    std::string told = read.error;
    for (const std::string &note : read.notes)
      told += "\n  note: " + note;
    BOOST_TEST((read.error.empty() && read.tells(part)), what << ": " << part << "\n  found: " << told);
  }

  /// The part of the curve between two lateral places lies on the exact one.
  inline void
  check_on(const Read        &read,
           const Curve       &exact,
           const double       low,
           const double       high,
           const double       most,
           const std::string &what)
  {
    double       worst = read.error.empty() ? 0 : 1;
    unsigned int count = 0;
    for (double t = 0; t < read.curve.parameter_end(); t += 0.5)
      if (const Point2 p = read.curve.at(t).position; p.x > low && p.x < high)
        {
          worst = std::max(worst, norm(exact.at(exact.closest(p)).position - p));
          ++count;
        }
    BOOST_TEST(count > 20, what + ": covers the profile");
    BOOST_TEST(near(worst, 0, most, what + ": distance from the profile that was measured [m]"));
  }

  inline Curve
  S1002()
  {
    return wheel_profile("S1002").tread;
  }

  /// Points of an S1002 tread as MiniProf writes them [m]: from the flange back to the field side, y down on
  /// the flange, the lateral origin on the flange back.
  inline Points
  miniprof_tread()
  {
    Points points;
    for (const Point2 &p : sampled(S1002(), 0.5e-3, 0, 1))
      points.insert(points.begin(), {p.x + 70e-3, -p.y});
    return points;
  }

  /// Without the back of the flange.
  inline Points
  without_back()
  {
    Points points = miniprof_tread();
    points.erase(points.begin(),
                 std::find_if(points.begin(), points.end(), [](const Point2 &p) { return p.x > 1.5e-3; }));
    return points;
  }
} // namespace test::profile_files
