#pragma once

// How the tests of messages bring them about.

#include "near.h"

#include <wheelrail/base/errors.h>
#include <wheelrail/model/scene_checks.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

namespace test
{
  using wheelrail::InputError;
  using wheelrail::require_computable;
  using wheelrail::RunError;
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
    catch (const RunError &error)
      {
        return error.what();
      }
    return "no message";
  }

  /// Makes a file that may not be read, reads it by `read`, and compares the message. Root may read
  /// everything, so the effective user is nobody meanwhile.
  inline void
  check_unreadable(const std::function<void(const std::string &)> &read)
  {
    const std::string name = "unreadable.txt";
    unlink(name.c_str());
    close(creat(name.c_str(), 0));
    const bool  root = geteuid() == 0;
    std::string found;
    if (root && seteuid(65534) != 0)
      std::cout << "        left out: " << name
                << " stays readable, since root may not be another user here\n";
    else
      {
        found = message_of([&]() { read(name); });
        if (root && seteuid(0) != 0)
          std::abort();
        BOOST_TEST(same_text(found, name + ": cannot be read; check its permissions", "an unreadable file"));
      }
    unlink(name.c_str());
  }

  inline void
  check_file(const std::string &text, const std::string &expected, const std::string &what)
  {
    BOOST_TEST(same_text(
      message_of([&]() { require_computable(scene_from_text(text, "x.prm", {})); }), expected, what));
  }

  inline void
  check_set(const std::string &set, const std::string &expected)
  {
    BOOST_TEST(same_text(message_of([&]() { require_computable(scene_from_text("", "x.prm", {set})); }),
                         expected,
                         "--set " + set));
  }
} // namespace test
