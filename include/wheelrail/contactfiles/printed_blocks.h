#pragma once

#include <wheelrail/contactfiles/solve_cases.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// The solved cases in the blocks that CONTACT prints (revision 2707, its printed output of NAME.inp), in
  /// its units, axes and signs: digits, what the case read, totals by patches, counts of elements, the
  /// picture of the contact (O >= 3) and the table of its elements (O = 5). Sensitivities are left out. Of a
  /// case that is refused its number alone, with the sentences.
  std::string
  printed_blocks(const std::vector<ContactCase> &cases, const std::vector<CaseResult> &results);
} // namespace wheelrail
