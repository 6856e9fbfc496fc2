#pragma once

#include <stdexcept>

namespace wheelrail
{
  /// Something in the user's input is wrong: the message names what was found, where, what is
  /// accepted and what to do. The program ends with exit code 1 and has written nothing.
  struct InputError : std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };

  /// A run cannot go on or cannot be trusted (energy out of balance, a value that is not finite,
  /// an output file that cannot be written). The program ends with exit code 2.
  struct RunError : std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };
} // namespace wheelrail
