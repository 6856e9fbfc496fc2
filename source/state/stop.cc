#include <wheelrail/base/quantity.h>
#include <wheelrail/state/stop.h>

#include <cmath>

namespace wheelrail
{
  std::string
  sentence(const Stop &stop)
  {
    return stop.reason + (stop.cure.empty() ? "" : "; " + stop.cure);
  }


  std::string
  obstacle_of_stop(const Stop &stop, const double saved_distance, const RunSettings &scene)
  {
    if (stop.cure.empty() || scene.path() < stop.rolled_distance)
      return "";
    if (stop.energy_error > 0 && scene.energy_limit > stop.energy_error)
      return "";
    std::string      ways           = stop.cure + ", and start anew with --overwrite";
    constexpr double still_a_result = 0.1;
    if (stop.energy_error > 0 && stop.energy_error < still_a_result)
      ways += "; or let it pass with --set \"Run/Energy limit = " +
              format_number((std::floor(1e3 * stop.energy_error) + 1) / 1e3) + "\"";
    // a whole tenth of a millimetre before that place
    const double end = (std::ceil(1e4 * stop.rolled_distance) - 1) / 1e4;
    if (end > saved_distance)
      ways += "; or end the run before that place with --set \"Run/Rolling distance = " +
              format_number(std::round(1e4 * end) / 10) + " mm\"";
    return "the run stopped since " + stop.reason + ", and would stop there again: " + ways;
  }
} // namespace wheelrail
