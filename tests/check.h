#pragma once

// The checks of the tests: every check prints one line, report() gives the exit code.

#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>

namespace test
{
  /// Checks that failed so far in this program.
  inline int &
  failures()
  {
    static int n = 0;
    return n;
  }

  /// Prints "ok" or "FAILED" with the text and counts a failure.
  inline bool
  check(const bool condition, const std::string &text)
  {
    if (!condition)
      ++failures();
    std::cout << (condition ? "ok      " : "FAILED  ") << text << std::endl;
    return condition;
  }

  /// Passes when |value - expected| <= tolerance (absolute; a value that is not finite fails).
  inline bool
  check_near(const double value, const double expected, const double tolerance, const std::string &text)
  {
    const double difference = value - expected;
    const bool   good       = std::abs(difference) <= tolerance;
    if (!good)
      ++failures();
    std::cout << (good ? "ok      " : "FAILED  ") << text << ": " << std::setprecision(10) << value
              << ", expected " << expected << std::setprecision(3) << ", difference " << difference
              << ", tolerance " << tolerance << std::endl;
    return good;
  }

  /// The same for value over expected.
  inline bool
  check_relative(const double value, const double expected, const double tolerance, const std::string &text)
  {
    return check_near(value / expected, 1, tolerance, text + " over expected");
  }

  /// Whether sanitizers watch every access to memory, which takes ten to fifty times as long: tests that go
  /// through the same code many times then leave repetitions out.
#ifdef __SANITIZE_ADDRESS__
  constexpr bool sanitized = true;
#else
  constexpr bool sanitized = false;
#endif

  /// Passes when both texts are equal; prints both when they are not.
  inline bool
  check_text(const std::string &value, const std::string &expected, const std::string &text)
  {
    const bool good = check(value == expected, text);
    if (!good)
      std::cout << "  found:    " << value << "\n  expected: " << expected << std::endl;
    return good;
  }

  /// Prints the result; the exit code of main(): 0 or 1 (a count could wrap around to 0).
  inline int
  report()
  {
    std::cout << (failures() == 0 ? "all checks passed" : std::to_string(failures()) + " checks FAILED")
              << std::endl;
    return failures() == 0 ? 0 : 1;
  }
} // namespace test
