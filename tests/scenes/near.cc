#include <cmath>
#include <iomanip>
#include <string>

#include "../near.h"

namespace test
{
  predicate_result
  near(const double value, const double expected, const double tolerance, const std::string &what)
  {
    const double     difference = value - expected;
    predicate_result result(std::abs(difference) <= tolerance);
    result.message() << what << ": " << std::setprecision(10) << value << ", expected " << expected
                     << std::setprecision(3) << ", difference " << difference << ", tolerance " << tolerance;
    return result;
  }


  predicate_result
  near_relative(const double value, const double expected, const double tolerance, const std::string &what)
  {
    return near(value / expected, 1, tolerance, what + " over expected");
  }


  predicate_result
  same_text(const std::string &value, const std::string &expected, const std::string &what)
  {
    predicate_result result(value == expected);
    result.message() << what;
    if (!result)
      result.message() << "\n  found:    " << value << "\n  expected: " << expected;
    return result;
  }
} // namespace test
