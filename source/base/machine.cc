#include <wheelrail/base/machine.h>

#include <fstream>
#include <string>

#include <unistd.h>

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
    // not the affinity mask: mpirun binds each rank to one core
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    machine.cores    = cores > 0 ? cores : 0;
    machine.memory   = memory_value("MemTotal");
    machine.free     = memory_value("MemAvailable");
    return machine;
  }
} // namespace wheelrail
