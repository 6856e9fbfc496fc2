#pragma once

#include <wheelrail/geometry/profile_file.h>
#include <wheelrail/geometry/profiles.h>

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

  /// A tread from flange back to rim face with a measured running surface, in the frame of the
  /// running circle 70 mm from the flange back: moved there by its flange back when the file has another
  /// origin, and in height so that the running circle has y = 0. A part that was not measured is
  /// added: the tread goes on straight up to 5 mm before the face of a rim `rim_width` wide [m], the top
  /// of the flange by an arc into the flange back.
  ///
  /// What was done is added to `notes`. Throws InputError when neither origin nor flange back tells
  /// where the running circle is, or the profile does not reach over it.
  WheelProfile
  measured_wheel(const MeasuredProfile &profile, double rim_width, std::vector<std::string> &notes);
} // namespace wheelrail
