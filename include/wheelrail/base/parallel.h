#pragma once

#include <cstddef>
#include <functional>

namespace wheelrail
{
  /// Calls work(i) for i from 0 to n - 1 on `threads` threads (0: as many as the machine has processors),
  /// each taking the next index that is free. An exception of `work` ends the loop and is thrown again here,
  /// and so is Interrupted once a signal has come (leave_if_interrupted()).
  void
  parallel_for(std::size_t n, const std::function<void(std::size_t)> &work, unsigned int threads = 0);

  /// Processors on which this process may run: those that mpirun or a batch system gave it.
  unsigned int
  processors_of_process();

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
