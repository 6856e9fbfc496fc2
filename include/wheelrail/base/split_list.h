#pragma once

#include <string>
#include <vector>

namespace wheelrail
{
  /// The parts of a text between separators, without the blanks around them; one empty part of an empty text.
  std::vector<std::string>
  split_list(const std::string &text, char separator = ',');
} // namespace wheelrail
