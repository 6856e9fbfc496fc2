#include <wheelrail/profiles/note_lines.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace wheelrail
{
  namespace
  {
    using Words = std::vector<const char *>;

    /// What notes of a line have in them; those of the last line have none of it.
    const Words placed = {"moved ",
                          "mirrored",
                          "turned upside down",
                          "unit ",
                          "body of the rail",
                          "origin of the file",
                          "joined to",
                          " side ends ",
                          "continued ",
                          "cut at the rim face",
                          "crown"};
    const Words mended = {"outlier",
                          " bridged",
                          "step of ",
                          "noise of ",
                          "kink at ",
                          " merged",
                          "averaged",
                          "repeated point",
                          "below the top left out"};

    bool
    has_one_of(const std::string &note, const Words &words)
    {
      return std::any_of(
        words.begin(), words.end(), [&](const char *word) { return note.find(word) != std::string::npos; });
    }
  } // namespace


  std::vector<std::string>
  note_lines(const std::vector<std::string> &notes)
  {
    const std::array<const char *, 3> names = {"placed: ", "points: ", "read: "};
    std::array<std::string, 3>        lines;
    for (const std::string &note : notes)
      {
        const std::size_t of = has_one_of(note, placed) ? 0 : has_one_of(note, mended) ? 1 : 2;
        lines[of] += (lines[of].empty() ? names[of] : "; ") + note;
      }
    std::vector<std::string> found;
    for (const std::string &line : lines)
      if (!line.empty())
        found.push_back(line);
    return found;
  }
} // namespace wheelrail
