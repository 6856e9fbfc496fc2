#pragma once

#include <wheelrail/contactcalls/call_table.h>

namespace wheelrail
{
  /// Sets a flag of CONTACT's library by its code; a value that it does not have is cut to the nearest it
  /// has. Throws InputError for flags that follow from other calls; unknown codes are said and left out.
  void
  set_flag(CallElement &element, CallProblem &problem, int code, int value);
  void
  set_global_flag(int code, int value);

  /// The value of a flag, 0 for unknown codes.
  int
  flag(const CallElement &element, const CallProblem &problem, int code);
} // namespace wheelrail
