#pragma once

#include <string>

namespace test
{
  /// The message of an error of this kind, empty where there is none; one of another kind ends the test.
  template <typename Error, typename Work>
  std::string
  error_of(const Work &work)
  {
    try
      {
        work();
      }
    catch (const Error &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace test
