#pragma once

namespace wheelrail
{
  /// From now on SIGINT, SIGTERM and SIGUSR1 no longer end the process but set a flag. Call it
  /// first in main: the launcher forwards Ctrl-C as SIGUSR1 to all ranks.
  void
  catch_interrupts();

  /// Whether one of these signals has arrived at this rank. Ranks hear of it at different times:
  /// agree on the maximum over all ranks before acting on it. The run then saves its state and
  /// ends with exit code 3.
  bool
  interrupt_requested();
} // namespace wheelrail
