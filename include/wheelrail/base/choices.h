#pragma once

#include <string>
#include <vector>

// Words of which one is meant, in messages: what there is, and what resembles a misspelt one.

namespace wheelrail
{
  /// Throws InputError when `text` is none of `choices`; names the nearest.
  void
  require_choice(const std::string &text, const std::vector<std::string> &choices);

  /// "a, b or c", or with another last word between them.
  std::string
  join_choices(const std::vector<std::string> &choices, const std::string &last_word = "or");

  /// The choice nearest to `text` if one resembles it: at most two letters differ, or a third of
  /// them in long words; otherwise an empty text.
  std::string
  nearest_choice(const std::string &text, const std::vector<std::string> &choices);

  /// ", perhaps x is meant" when a choice resembles `text`, otherwise nothing.
  std::string
  perhaps(const std::string &text, const std::vector<std::string> &choices);

  /// Number of single-letter insertions, deletions, replacements and swaps of neighbours between two texts,
  /// case ignored (Damerau, 1964; no letter changed twice).
  unsigned int
  edit_distance(const std::string &a, const std::string &b);
} // namespace wheelrail
