#pragma once

#include <wheelrail/output/summary.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// What a run says at its end, at most 25 lines in units of the field: the verdict with its reasons, forces
  /// with Q (vertical), Y (lateral) and Y/Q, the contact, stresses, what it cost, and what to do next. All
  /// figures stand in summary.json.
  std::vector<std::string>
  end_screen(const Summary &summary, const std::string &folder);

  /// The same of a contact of half-spaces or true bodies: verdict, forces, contact, how the plane of contact
  /// lies and the bodies moved, stresses, wear of one passage, cost; at most 30 lines. Reference point, work
  /// and grid stand in summary.json alone.
  std::vector<std::string>
  halfspace_screen(const Summary &summary);
} // namespace wheelrail
