#pragma once

// Boost.Test, and predicates for it that say both values: BOOST_TEST(near(found, expected, tolerance,
// "what")).

#include <boost/test/unit_test.hpp>

#include <string>

namespace test
{
  using boost::test_tools::predicate_result;

  /// True when |value - expected| <= tolerance (absolute; false for a value that is not finite).
  predicate_result
  near(double value, double expected, double tolerance, const std::string &what);

  /// The same for value over expected.
  predicate_result
  near_relative(double value, double expected, double tolerance, const std::string &what);

  /// True when both texts are equal.
  predicate_result
  same_text(const std::string &value, const std::string &expected, const std::string &what);

  /// Whether sanitizers watch every access to memory, which takes ten to fifty times as long: tests that go
  /// through the same code many times then leave repetitions out.
#ifdef __SANITIZE_ADDRESS__
  constexpr bool sanitized = true;
#else
  constexpr bool sanitized = false;
#endif
} // namespace test
