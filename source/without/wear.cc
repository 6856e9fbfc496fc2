#include <wheelrail/base/left_out.h>
#include <wheelrail/wear/wear_command.h>

namespace wheelrail
{
  int
  act_wear(const po::variables_map &, const RunFunction &, std::ostream &)
  {
    refuse_left_out("wear", Subject::wear);
  }
} // namespace wheelrail
