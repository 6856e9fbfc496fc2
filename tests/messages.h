#pragma once

// How the tests of messages bring them about.

#include "check.h"

#include <wheelrail/application/parameters.h>
#include <wheelrail/base/errors.h>

#include <functional>

namespace test
{
  using wheelrail::InputError;
  using wheelrail::scene_from_text;

  inline std::string
  message_of(const std::function<void()> &work)
  {
    try
      {
        work();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "no message";
  }

  inline void
  check_file(const std::string &text, const std::string &expected, const std::string &what)
  {
    check_text(message_of([&]() { scene_from_text(text, "x.prm", {}); }), expected, what);
  }

  inline void
  check_set(const std::string &set, const std::string &expected)
  {
    check_text(message_of([&]() { scene_from_text("", "x.prm", {set}); }), expected, "--set " + set);
  }
} // namespace test
