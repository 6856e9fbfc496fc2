#pragma once

#include <wheelrail/vehicle/wheelset_contact.h>

#include <string>

namespace wheelrail
{
  /// Writes what the picture of a wheelset on its rails shows (source/report/wheelset.py) as rows "side,
  /// what, x, y": the outlines of both heads and treads, the patches from edge to edge on the rail, and, each
  /// as a place and an arrow behind it, the forces of the patches on the wheels. Places in mm, seen along the
  /// track: x to the right from the middle of the track, y upwards from the running circles; forces in kN.
  /// Throws RunError when it cannot be written.
  void
  write_wheelset_lines(const WheelsetSolution &wheelset, const std::string &path);
} // namespace wheelrail
