#pragma once

// Faults of input files of CONTACT, each with its message.

#include <wheelrail/base/errors.h>
#include <wheelrail/contactfiles/inp_file.h>

#include "contact_inputs.h"

#include <string>
#include <utility>
#include <vector>

namespace test
{
  /// What is said of an input, or that nothing is.
  inline std::string
  message_of(const std::string &text)
  {
    try
      {
        wheelrail::read_inp_text(text, "x.inp");
      }
    catch (const wheelrail::InputError &error)
      {
        return error.what();
      }
    return "no message";
  }

  /// An input with texts replaced, and the line and message of its fault.
  struct Fault
  {
    const std::string                               &text;
    std::vector<std::pair<std::string, std::string>> changes;
    std::string                                      expected;
  };

  inline void
  check_faults(const std::vector<Fault> &faults)
  {
    for (const Fault &fault : faults)
      {
        std::string text = fault.text, name;
        for (const auto &[from, to] : fault.changes)
          {
            text = replaced(text, from, to);
            name += (name.empty() ? "" : ", ") + ("\"" + to + "\"");
          }
        check_text(message_of(text), "x.inp:" + fault.expected, name);
      }
  }
} // namespace test
