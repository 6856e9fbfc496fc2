#pragma once

#include <wheelrail/geometry/profiles.h>
#include <wheelrail/profiles/profile_file.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// A whole rail with a measured head: the head is moved into the frame of a standard rail (`body`:
  /// its name, or "auto" for the one whose head is as wide) and joined to its lower part, each end by a
  /// straight line to the side of the standard head.
  ///
  /// The origin of the file is kept when its head lies where that of the standard rail does (top up
  /// to 15 mm worn, field side within 1.5 mm); otherwise the top becomes y = 0 and the field side of
  /// the head (without one: the gauge side) is put on that of the body, 14 mm below the top.
  /// What was done is added to `notes`. Throws InputError for an unknown body and for a head that
  /// does not fit on it.
  RailProfile
  measured_rail(const MeasuredProfile &profile, const std::string &body, std::vector<std::string> &notes);

  /// A head that is wider than those of standard rails, on `body` widened in its middle by as much: head, web
  /// and foot have straight pieces there. x = 0 stays that of the file, the top becomes y = 0.
  RailProfile
  wide_rail(const MeasuredProfile &profile, const std::string &body, std::vector<std::string> &notes);

  /// A tread from flange back to rim face with a measured running surface, in the frame of the
  /// running circle 70 mm from the flange back: moved there as `origin` says, and in height so that the
  /// running circle has y = 0. Automatic is: by the flange back where it was measured, otherwise by the
  /// flange tip, which lies 47 mm to 63 mm off the running circle or 14 mm to 22 mm off the back. A part that
  /// was not measured is added: the tread continues straight up to 5 mm before the face of a rim `rim_width`
  /// wide [m], the flange, also one cut off before its tip, by an arc into the flange back. The face of the
  /// rim is left out.
  ///
  /// What was done is added to `notes`. Throws InputError when neither flange back nor tip shows
  /// where the running circle is, `origin` puts the tip where none can be, the profile does not reach over
  /// the running circle, or its flange is cut so short that no flange follows.
  WheelProfile
  measured_wheel(const MeasuredProfile    &profile,
                 double                    rim_width,
                 std::vector<std::string> &notes,
                 WheelOrigin               origin = WheelOrigin::automatic);
} // namespace wheelrail
