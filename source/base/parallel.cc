#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/parallel.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <sched.h>

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
} // namespace wheelrail
