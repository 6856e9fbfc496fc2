#include <wheelrail/base/choices.h>
#include <wheelrail/base/errors.h>

#include <algorithm>
#include <cctype>

namespace wheelrail
{
  void
  require_choice(const std::string &text, const std::vector<std::string> &choices)
  {
    if (std::find(choices.begin(), choices.end(), text) != choices.end())
      return;
    std::string message = text.empty() ? "no value; " : "not known here; ";
    message += join_choices(choices) + " is accepted";
    if (choices.size() > 1 && !text.empty())
      message += perhaps(text, choices);
    throw InputError(message);
  }

  std::string
  join_choices(const std::vector<std::string> &choices, const std::string &last_word)
  {
    std::string words;
    for (std::size_t i = 0; i < choices.size(); ++i)
      words += (i == 0 ? "" : i + 1 == choices.size() ? " " + last_word + " " : ", ") + choices[i];
    return words;
  }

  std::string
  nearest_choice(const std::string &text, const std::vector<std::string> &choices)
  {
    std::string nearest;
    std::size_t smallest = std::max<std::size_t>(2, text.size() / 3) + 1;
    // a text many times as long as any choice resembles none, and is not worth the time
    if (text.size() > 200)
      return nearest;
    for (const std::string &choice : choices)
      {
        const std::size_t distance = edit_distance(choice, text);
        // letters in common, not only a short length
        if (distance < smallest && distance < std::max(choice.size(), text.size()))
          {
            smallest = distance;
            nearest  = choice;
          }
      }
    return nearest;
  }

  std::string
  perhaps(const std::string &text, const std::vector<std::string> &choices)
  {
    const std::string nearest = nearest_choice(text, choices);
    return nearest.empty() ? "" : ", perhaps " + nearest + " is meant";
  }

  unsigned int
  edit_distance(const std::string &a, const std::string &b)
  {
    const auto lower = [](const char c) { return std::tolower(static_cast<unsigned char>(c)); };
    const auto alike = [&](const std::size_t i, const std::size_t j) { return lower(a[i]) == lower(b[j]); };

    std::vector<unsigned int> row(b.size() + 1), above(b.size() + 1), second(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
      above[j] = static_cast<unsigned int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i)
      {
        row[0] = static_cast<unsigned int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j)
          {
            row[j] = std::min({row[j - 1] + 1, above[j] + 1, above[j - 1] + (alike(i - 1, j - 1) ? 0u : 1u)});
            if (i > 1 && j > 1 && alike(i - 1, j - 2) && alike(i - 2, j - 1))
              row[j] = std::min(row[j], second[j - 2] + 1);
          }
        second.swap(above); // the row before the last
        above.swap(row);
      }
    return above[b.size()];
  }
} // namespace wheelrail
