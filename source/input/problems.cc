#include <wheelrail/base/errors.h>
#include <wheelrail/input/problems.h>

#include <algorithm>

namespace wheelrail
{
  void
  require_no_problems(std::vector<Problem> problems, const std::string &name)
  {
    constexpr std::size_t shown = 25;
    if (problems.empty())
      return;
    std::stable_sort(
      problems.begin(), problems.end(), [](const Problem &a, const Problem &b) { return a.order < b.order; });
    if (problems.size() > shown)
      {
        const std::size_t rest = problems.size() - shown;
        problems.resize(shown);
        problems.push_back({name + ": " + std::to_string(rest) + " more faults; correct these first"});
      }
    std::string text;
    for (const Problem &problem : problems)
      text += (text.empty() ? "" : "\n") + problem.text;
    throw InputError(text);
  }
} // namespace wheelrail
