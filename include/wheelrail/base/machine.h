#pragma once

namespace wheelrail
{
  /// What a run has at its disposal; zero means unknown.
  struct Machine
  {
    unsigned int ranks  = 0; ///< processes of the run on this machine
    unsigned int cores  = 0; ///< processors in use by the system
    double       memory = 0; ///< in all [bytes]
    double       free   = 0; ///< of it not in use [bytes]
  };

  /// The machine this process runs on.
  Machine
  this_machine(unsigned int ranks);
} // namespace wheelrail
