#include <wheelrail/base/left_out.h>
#include <wheelrail/vehicle/creep_curve_command.h>
#include <wheelrail/vehicle/vehicle_command.h>
#include <wheelrail/vehicle/wheelset_command.h>

#include <string>

namespace wheelrail
{
  int
  act_vehicle(const po::variables_map &, const RunFunction &, std::ostream &)
  {
    refuse_left_out("vehicle", Subject::vehicle);
  }


  std::string
  take_wheel(const po::variables_map &options, SceneInput &)
  {
    if (options.count("wheelset"))
      refuse_left_out("--wheelset", Subject::vehicle);
    return "";
  }


  int
  run_wheelset_command(const Scene &, bool, std::ostream &)
  {
    refuse_left_out("Wheelset/Wheels = both", Subject::vehicle);
  }


  CreepCurve
  parse_creep_curve(const std::string &)
  {
    refuse_left_out("--creep-curve", Subject::vehicle);
  }


  int
  run_creep_curve_command(const Scene &,
                          const SceneGeometry *,
                          const CreepCurve &,
                          const std::string &,
                          bool,
                          std::ostream &)
  {
    refuse_left_out("--creep-curve", Subject::vehicle);
  }
} // namespace wheelrail
