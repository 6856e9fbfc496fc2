#pragma once

#include <exception>
#include <string>
#include <utility>

namespace wheelrail
{
  /// Work was left because a signal asked for it. The program ends with exit code 3 and says what is kept and
  /// how to go on; where nothing is said, nothing is kept.
  class Interrupted : public std::exception
  {
  public:
    explicit Interrupted(std::string kept = "")
      : kept_(std::move(kept))
    {
    }

    const char *
    what() const noexcept override
    {
      return kept_.c_str();
    }

  private:
    std::string kept_;
  };

  /// From now on SIGINT, SIGTERM and SIGUSR1 no longer end the process but set a flag. Call it
  /// first in main: the launcher forwards Ctrl-C as SIGUSR1 to all ranks. A second signal, a second or more
  /// behind the first, ends the process at once unless it saves (save_when_interrupted()).
  void
  catch_interrupts();

  /// From now on leave_if_interrupted() does nothing: the caller asks interrupt_requested(), and saves.
  void
  save_when_interrupted();

  /// Whether one of these signals has arrived at this rank. Ranks hear of it at different times:
  /// agree on the maximum over all ranks before acting on it. The run then saves its state and
  /// ends with exit code 3.
  bool
  interrupt_requested();

  /// Throws Interrupted once one of these signals has arrived. Long work calls it some times a second where
  /// it may be left: between tasks, steps, iterations.
  void
  leave_if_interrupted();
} // namespace wheelrail
