#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/parallel.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <fstream>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <sched.h>
#include <unistd.h>

namespace wheelrail
{
  void
  parallel_for(const std::size_t n, const std::function<void(std::size_t)> &work, unsigned int threads)
  {
    if (threads == 0)
      threads = std::max(1u, std::thread::hardware_concurrency());
    std::atomic<std::size_t> next{0};
    std::exception_ptr       failure;
    std::mutex               lock;
    const auto               serve = [&]() {
      for (std::size_t i = next++; i < n; i = next++)
        try
          {
            leave_if_interrupted();
            work(i);
          }
        catch (...)
          {
            const std::lock_guard<std::mutex> guard(lock);
            if (!failure)
              failure = std::current_exception();
            next = n;
          }
    };
    std::vector<std::thread> others;
    for (unsigned int t = 1; t < std::min<std::size_t>(threads, n); ++t)
      others.emplace_back(serve);
    serve();
    for (std::thread &other : others)
      other.join();
    if (failure)
      std::rethrow_exception(failure);
  }


  unsigned int
  processors_of_process()
  {
    cpu_set_t mask;
    CPU_ZERO(&mask);
    if (sched_getaffinity(0, sizeof(mask), &mask) != 0) // more processors than the mask holds
      return 1;
    return std::max(1, CPU_COUNT(&mask));
  }


  namespace
  {
    /// A value of /proc/meminfo [bytes], 0 when it is not there.
    double
    memory_value(const std::string &wanted)
    {
      std::ifstream file("/proc/meminfo");
      std::string   name, unit;
      for (double kilobytes; file >> name >> kilobytes;)
        {
          std::getline(file, unit);
          if (name == wanted + ":")
            return 1024 * kilobytes;
        }
      return 0;
    }
  } // namespace


  Machine
  this_machine(const unsigned int ranks)
  {
    Machine machine;
    machine.ranks = ranks;
    // not the affinity mask: mpirun binds each rank to one core
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    machine.cores    = cores > 0 ? cores : 0;
    machine.memory   = memory_value("MemTotal");
    machine.free     = memory_value("MemAvailable");
    return machine;
  }
} // namespace wheelrail
