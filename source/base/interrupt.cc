#include <wheelrail/base/interrupt.h>

#include <csignal>
#include <ctime>

#include <unistd.h>

namespace wheelrail
{
  namespace
  {
    volatile std::sig_atomic_t requested = 0, saves = 0;
    volatile std::time_t       requested_at = 0;

    extern "C" void
    note_request(int)
    {
      const std::time_t now = std::time(nullptr);
      // some senders give the same signal to a process and to its group
      if (requested && !saves && now > requested_at + 1)
        ::_exit(3);
      if (!requested)
        requested_at = now;
      requested = 1;
    }
  } // namespace


  void
  catch_interrupts()
  {
    struct sigaction action = {};
    action.sa_handler       = note_request;
    action.sa_flags         = SA_RESTART; // a write in progress is finished, not broken off
    sigemptyset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1})
      sigaction(signal, &action, nullptr);
  }


  void
  save_when_interrupted()
  {
    saves = 1;
  }


  bool
  interrupt_requested()
  {
    return requested != 0;
  }


  void
  leave_if_interrupted()
  {
    if (requested && !saves)
      throw Interrupted();
  }
} // namespace wheelrail
