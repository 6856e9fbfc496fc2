#include <wheelrail/base/interrupt.h>

#include <csignal>
#include <initializer_list>

namespace wheelrail
{
  namespace
  {
    volatile std::sig_atomic_t requested = 0;

    extern "C" void
    note_request(int)
    {
      requested = 1;
    }
  } // namespace

  void
  catch_interrupts()
  {
    struct sigaction action = {};
    action.sa_handler       = note_request;
    action.sa_flags         = SA_RESTART; // a write under way is finished, not broken off
    sigemptyset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1})
      sigaction(signal, &action, nullptr);
  }

  bool
  interrupt_requested()
  {
    return requested != 0;
  }
} // namespace wheelrail
