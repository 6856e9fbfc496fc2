#pragma once

#include <wheelrail/contactfiles/contact_case.h>

#include <string>
#include <vector>

namespace wheelrail
{
  /// All cases of an input file of the program CONTACT (open version, revision 2707), modules 1 and 3, in the
  /// order of the file. What a case does not state it has from the case before of its module and result
  /// element (and of its contact problem, in module 3); digits that keep are resolved.
  ///
  /// Throws InputError with file and line for digits and values that CONTACT does not have or that exclude
  /// each other, a first case that keeps values, a file that ends early, profiles that are not there.
  std::vector<ContactCase>
  read_inp_file(const std::string &path);

  /// The same for the text of a file: `path` names it in messages, and profiles are looked for in its folder.
  std::vector<ContactCase>
  read_inp_text(const std::string &text, const std::string &path);
} // namespace wheelrail
