#pragma once

#include <string>

namespace wheelrail
{
  /// The subjects that a build can leave out, by options of CMake of the same names: WHEELRAIL_TRACK (pads,
  /// sleepers, receptance), WHEELRAIL_VEHICLE (wheelsets, rows of a vehicle simulation, creep curves),
  /// WHEELRAIL_WEAR (profiles that wear; needs vehicle), WHEELRAIL_CONTACT_FILES (files of the program
  /// CONTACT; needs sections), WHEELRAIL_SECTIONS (rails by slices, as crossings).
  enum class Subject
  {
    track,
    vehicle,
    wear,
    contact_files,
    sections
  };

  bool
  is_built(Subject subject);

  /// Says that `what` belongs to a subject that is left out, and how to have it.
  std::string
  left_out(const std::string &what, Subject subject);

  /// Throws that as InputError.
  [[noreturn]] void
  refuse_left_out(const std::string &what, Subject subject);
} // namespace wheelrail
