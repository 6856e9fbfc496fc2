#include <wheelrail/application/machine.h>

#include <fstream>
#include <string>

#include <sched.h>

namespace wheelrail
{
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
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof(allowed), &allowed) == 0)
      machine.cores = CPU_COUNT(&allowed);
    machine.memory = memory_value("MemTotal");
    machine.free   = memory_value("MemAvailable");
    return machine;
  }
} // namespace wheelrail
