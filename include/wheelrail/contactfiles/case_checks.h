#pragma once

#include <wheelrail/contactfiles/contact_case.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// Throws InputError with file and line for digits and values of a case that exclude each other or that
  /// miss values which no case has stated. `before`: the case before of its result element, or null.
  void
  check_case(const ContactCase &one, const ContactCase *before);

  /// What of the case is not computed here, a sentence for each digit and value, with file and line, its
  /// meaning and what is taken instead. Empty: all of it is.
  std::vector<std::string>
  refusals(const ContactCase &one);
} // namespace wheelrail
