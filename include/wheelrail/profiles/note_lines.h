#pragma once

#include <string>
#include <vector>

namespace wheelrail
{
  /// The notes on a measured profile in at most three lines, what matters first: how it was placed (origin,
  /// mirror, unit, the body or the parts that were added), how its points were mended (outliers, gaps, noise,
  /// kinks), and how the file was read. Each keeps the order and the words of the notes.
  std::vector<std::string>
  note_lines(const std::vector<std::string> &notes);
} // namespace wheelrail
