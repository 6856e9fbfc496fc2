#pragma once

#include <wheelrail/output/summary.h>

#include <nlohmann/json.hpp>

#include <ostream>
#include <string>
#include <vector>

namespace wheelrail
{
  /// What a run is compared with: the head of its column, and what precedes the keys of its figures
  /// and of the differences.
  struct ComparedWith
  {
    const char *title, *figures, *differences;
    const char *json; ///< the key of its value in compare.json
  };
  inline constexpr ComparedWith half_spaces{"half-space", "halfspace_", "relative_difference_", "halfspace"},
    true_bodies{"true bodies", "bodies_", "bodies_relative_difference_", "bodies"};

  /// What a table of figures says.
  struct Comparison
  {
    nlohmann::ordered_json   table = nlohmann::ordered_json::array(); ///< for compare.json
    std::vector<std::string> beyond; ///< the figures that differ by more than their limit, with both
  };

  /// Prints the table of a run's figures beside those of the half-spaces or the true bodies, with their
  /// differences and what cells of 1 mm, the penalty and the noise of a run explain of them, and adds figures
  /// and differences to the run's summary. Rows of a wheelset with yaw and of true bodies come where there
  /// are such.
  Comparison
  compare_figures(Summary &run, const Summary &halfspace, const ComparedWith &reference, std::ostream &out);

  /// null for what is not finite, which JSON does not have.
  nlohmann::ordered_json
  json_number(double value);
} // namespace wheelrail
